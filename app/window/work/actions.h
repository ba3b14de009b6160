#pragma once

#include <QKeySequence>
#include <QObject>

#include <functional>
#include <map>
#include <vector>

class QAction;
class QWidget;

namespace viscera::app {

/// A property of an action: the name of its icon.
inline constexpr const char* kIconName = "iconName";

/// A register of the window's actions by name; menus, panels and the list of shortcuts share one action.
class Actions final : public QObject {
  Q_OBJECT

public:
  /// `window` takes the shortcuts.
  explicit Actions(QWidget* window);

  /// Everything about an action but what it does.
  struct Description {
    QString text;                  ///< The text in a menu, with its mnemonic.
    const char* icon = nullptr;    ///< A name of the icon set.
    QList<QKeySequence> shortcuts; ///< The first is shown.
    QString tip;                   ///< A sentence; the shortcut is added to it.
  };

  QAction* add(const char* id, const Description& description, std::function<void()> run);
  QAction* addToggle(const char* id, const Description& description, bool on, std::function<void(bool)> run);
  /// Enables these actions while `allowed` returns true; `sync` calls it.
  void enableWhile(const std::vector<const char*>& ids, std::function<bool()> allowed);
  /// Calls `bring` in every `sync`, so that it can update the state of actions.
  void onSync(std::function<void()> bring) { syncs_.push_back(std::move(bring)); }
  /// Updates which actions are enabled and checked. Call it after every change that they may depend on.
  void sync();
  /// Asserts that it exists.
  QAction* operator[](const char* id) const;
  /// All actions in the order in which they were added.
  const std::vector<QAction*>& all() const { return order_; }

private:
  QAction* make(const char* id, const Description& description);

  QWidget* window_;
  std::map<QString, QAction*> byId_;
  std::vector<QAction*> order_;
  std::vector<std::function<void()>> syncs_;
};

} // namespace viscera::app
