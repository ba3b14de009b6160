#include "window/widgets/ready_made.h"

#include <QAction>
#include <QPushButton>

#include "window/style/icon.h"
#include "window/widgets/wrapped_label.h"

namespace viscera::app {

QString shortenedName(const QString& name, const QWidget& shownIn) {
  constexpr int kWidestName = 180; // Logical pixels.
  return shownIn.fontMetrics().elidedText(name, Qt::ElideMiddle, kWidestName);
}

QLabel* makeRemark(const QString& text, QWidget* parent) {
  auto* label = new WrappedLabel(text, parent);
  label->setObjectName(QStringLiteral("muted"));
  return label;
}

QToolButton* makeIconButton(const char* name, const QString& tip, QWidget* parent, int size) {
  auto* button = new QToolButton(parent);
  button->setIcon(icon(name));
  if (size > 0)
    button->setIconSize(QSize(size, size));
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  return button;
}

QPushButton* makeActionButton(QAction* action, QWidget* parent) {
  auto* button = new QPushButton(action->icon(), action->iconText(), parent);
  button->setObjectName(action->objectName());
  button->setCheckable(action->isCheckable());
  const auto sync = [button, action] {
    button->setEnabled(action->isEnabled());
    button->setToolTip(action->toolTip());
    button->setChecked(action->isChecked());
  };
  QObject::connect(button, &QPushButton::clicked, action, &QAction::trigger);
  QObject::connect(action, &QAction::changed, button, sync);
  sync();
  return button;
}

void embolden(QWidget* widget, double factor) {
  QFont font = widget->font();
  font.setBold(true);
  if (factor != 1) // Else the size goes on following the program's.
    font.setPointSizeF(font.pointSizeF() * factor);
  widget->setFont(font);
}

} // namespace viscera::app
