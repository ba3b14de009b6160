#pragma once

#include <QObject>

#include <functional>
#include <map>

class QTreeWidget;

namespace viscera::app {

/// Keys that the window has for other things: with the list in focus, and rows of it chosen, they are meant
/// for the list. Owned by it.
///
///     (new ListKeys(list))->add(Qt::Key_Delete, [this] { removeChosen(); });
class ListKeys final : public QObject {
public:
  explicit ListKeys(QTreeWidget* list);

  /// Calls `action` for the key. Gives itself, so that others can be added.
  ListKeys* add(Qt::Key key, std::function<void()> action);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QTreeWidget* list_;
  std::map<int, std::function<void()>> actions_;
};

} // namespace viscera::app
