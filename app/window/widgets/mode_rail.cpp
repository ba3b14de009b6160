#include "window/widgets/mode_rail.h"

#include <QButtonGroup>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

#include "window/modes/mode_controller.h"
#include "window/style/icon.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {
constexpr int kModeIconSize = 24;
} // namespace

ModeRail::ModeRail(ModeController& modes, QWidget* parent) : QWidget(parent) {
  auto* buttons = new QButtonGroup(this);
  setObjectName(QStringLiteral("modeRail"));
  setAttribute(Qt::WA_StyledBackground);
  auto* column = makeLayout<QVBoxLayout>(this, 4, {4, 8, 4, 8});
  for (const auto& mode : modes.all()) {
    const Mode::Description& description = mode->description();
    auto* button = new QToolButton(this);
    button->setObjectName(QStringLiteral("modeButton"));
    button->setProperty("mode", QString::fromLatin1(description.id));
    button->setIcon(icon(description.icon));
    button->setIconSize(QSize(kModeIconSize, kModeIconSize));
    button->setText(description.name);
    button->setToolTip(tr("%1 (%2)\n%3").arg(description.name).arg(description.key).arg(description.hint));
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setCheckable(true);
    button->setFixedSize(std::max(60, button->fontMetrics().horizontalAdvance(description.name) + 12),
                         kModeIconSize + button->fontMetrics().height() + 20);
    buttons->addButton(button);
    connect(button, &QToolButton::clicked, &modes, [&modes, id = description.id] { modes.choose(id); });
    const auto sync = [&modes, button, shown = mode.get()] { button->setChecked(&modes.present() == shown); };
    connect(&modes, &ModeController::changed, button, sync);
    sync();
    column->addWidget(button, 0, Qt::AlignHCenter);
  }
  column->addStretch(1);
}

} // namespace viscera::app
