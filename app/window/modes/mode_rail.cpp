#include "window/modes/mode_rail.h"

#include <QButtonGroup>
#include <QResizeEvent>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

#include "window/modes/mode_controller.h"
#include "window/style/icon.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {
constexpr int kModeIconSize = 24;
constexpr int kAroundModeIcon = 12;
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
    button->setCheckable(true);
    button->setFixedWidth(std::max(60, button->fontMetrics().horizontalAdvance(description.name) + 12));
    buttons_.push_back(button);
    buttons->addButton(button);
    connect(button, &QToolButton::clicked, &modes, [&modes, id = description.id] { modes.choose(id); });
    const auto sync = [&modes, button, shown = mode.get()] { button->setChecked(&modes.present() == shown); };
    connect(&modes, &ModeController::changed, button, sync);
    sync();
    column->addWidget(button, 0, Qt::AlignHCenter);
  }
  column->addStretch(1);
  setWords(true);
}

int ModeRail::heightFor(bool words) const {
  const QMargins around = layout()->contentsMargins();
  const int word = words ? fontMetrics().height() + 20 : kAroundModeIcon;
  const auto count = static_cast<int>(buttons_.size());
  return around.top() + around.bottom() + count * (kModeIconSize + word) + (count - 1) * layout()->spacing();
}

QSize ModeRail::sizeHint() const {
  return {QWidget::sizeHint().width(), heightFor(true)};
}

QSize ModeRail::minimumSizeHint() const {
  return {QWidget::minimumSizeHint().width(), heightFor(false)};
}

void ModeRail::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (const bool words = event->size().height() >= heightFor(true); words != words_)
    setWords(words);
}

void ModeRail::setWords(bool words) {
  words_ = words;
  for (QToolButton* button : buttons_) {
    button->setToolButtonStyle(words ? Qt::ToolButtonTextUnderIcon : Qt::ToolButtonIconOnly);
    button->setFixedHeight(kModeIconSize + (words ? button->fontMetrics().height() + 20 : kAroundModeIcon));
  }
}

} // namespace viscera::app
