#include "window/widgets/list_keys.h"

#include <QKeyEvent>
#include <QTreeWidget>

#include <utility>

namespace viscera::app {

ListKeys::ListKeys(QTreeWidget* list) : QObject(list), list_(list) {
  list->installEventFilter(this);
}

ListKeys* ListKeys::add(Qt::Key key, std::function<void()> action) {
  actions_[key] = std::move(action);
  return this;
}

bool ListKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
    return QObject::eventFilter(watched, event);
  const auto found = actions_.find(static_cast<QKeyEvent*>(event)->key());
  if (found == actions_.end() || list_->selectedItems().isEmpty())
    return false;
  if (event->type() == QEvent::ShortcutOverride)
    event->accept();
  else
    found->second();
  return true;
}

} // namespace viscera::app
