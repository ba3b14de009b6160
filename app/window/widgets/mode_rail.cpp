#include "window/widgets/mode_rail.h"

#include <QAction>
#include <QButtonGroup>
#include <QToolButton>
#include <QVBoxLayout>

#include "window/style/icon.h"

namespace viscera::app {
namespace {
constexpr int kIconSize = 24;
} // namespace

ModeRail::ModeRail(QWidget* parent) : QWidget(parent), buttons_(new QButtonGroup(this)) {
  setObjectName(QStringLiteral("modeRail"));
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 8, 4, 8);
  column->setSpacing(4);
  for (const ModeDescription& description : modeDescriptions()) {
    auto* button = new QToolButton(this);
    button->setObjectName(QStringLiteral("modeButton"));
    button->setProperty("mode", QString::fromLatin1(description.id));
    button->setIcon(icon(description.icon));
    button->setIconSize(QSize(kIconSize, kIconSize));
    button->setText(description.name);
    button->setToolTip(tr("%1 (%2)\n%3").arg(description.name).arg(description.key).arg(description.hint));
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setCheckable(true);
    button->setFixedSize(std::max(60, button->fontMetrics().horizontalAdvance(description.name) + 12),
                         kIconSize + button->fontMetrics().height() + 20);
    buttons_->addButton(button, static_cast<int>(description.mode));
    column->addWidget(button, 0, Qt::AlignHCenter);
  }
  column->addStretch(1);
  connect(buttons_, &QButtonGroup::idClicked, this,
          [this](int id) { Q_EMIT modeChosen(static_cast<Mode>(id)); });
}

void ModeRail::setMode(Mode mode) {
  if (auto* button = buttons_->button(static_cast<int>(mode)))
    button->setChecked(true);
}

} // namespace viscera::app
