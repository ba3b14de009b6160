#include "window/widgets/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QChildEvent>
#include <QComboBox>
#include <QSlider>
#include <QWidget>

namespace viscera::app {
namespace {

bool takesValuesFromTheWheel(const QObject* object) {
  return qobject_cast<const QComboBox*>(object) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(object) != nullptr ||
         qobject_cast<const QSlider*>(object) != nullptr;
}

} // namespace

WheelGuard::WheelGuard(QWidget* contents) : QObject(contents) {
  watch(contents);
}

void WheelGuard::watch(QObject* object) {
  if (!object->isWidgetType())
    return;
  object->installEventFilter(this);
  for (QObject* child : object->children())
    watch(child);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ChildAdded)
    watch(static_cast<QChildEvent*>(event)->child());
  if (event->type() != QEvent::Wheel || !takesValuesFromTheWheel(watched))
    return QObject::eventFilter(watched, event);
  // Kept from the widget, and not accepted: so Qt offers it to the parents, of which one scrolls.
  event->ignore();
  return true;
}

} // namespace viscera::app
