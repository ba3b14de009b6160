#pragma once

#include <QKeySequence>
#include <QObject>

#include <functional>
#include <map>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace viscera::app {

/// The window's actions by name: each is made once and stands in menus, panels and the list of shortcuts.
class Actions final : public QObject {
  Q_OBJECT

public:
  /// `window` takes the shortcuts.
  explicit Actions(QWidget* window);

  /// Everything about an action but what it does.
  struct Description {
    QString text;                  ///< In a menu, with its mnemonic.
    const char* icon = nullptr;    ///< Of the icon set.
    QList<QKeySequence> shortcuts; ///< The first is shown.
    QString tip;                   ///< A sentence; the shortcut is added to it.
  };

  QAction* add(const char* id, const Description& description, std::function<void()> run);
  QAction* addToggle(const char* id, const Description& description, bool on, std::function<void(bool)> run);
  /// Asserts that it exists.
  QAction* operator[](const char* id) const;
  /// In the order in which they were added.
  const std::vector<QAction*>& all() const { return order_; }

private:
  QAction* make(const char* id, const Description& description);

  QWidget* window_;
  std::map<QString, QAction*> byId_;
  std::vector<QAction*> order_;
};

} // namespace viscera::app
