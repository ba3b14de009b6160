#pragma once

#include <QObject>

#include <functional>
#include <map>

class QTreeWidget;

namespace viscera::app {

/// Lets a list handle keys that are otherwise shortcuts of the window, while the list has the focus and rows
/// of it are selected. The list owns this object.
///
///     (new ListKeys(list))->add(Qt::Key_Delete, [this] { removeChosen(); });
class ListKeys final : public QObject {
public:
  explicit ListKeys(QTreeWidget* list);

  /// Calls `action` for the key. Returns this object, so that calls can be chained.
  ListKeys* add(Qt::Key key, std::function<void()> action);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QTreeWidget* list_;
  std::map<int, std::function<void()>> actions_;
};

} // namespace viscera::app
