#pragma once

#include <QByteArray>
#include <QDockWidget>
#include <QHash>
#include <QObject>

#include <optional>
#include <vector>

#include "window/actions.h"
#include "window/modes/mode.h"
#include "window/settings.h"

class QMainWindow;
class QToolBar;

namespace viscera::app {

class PanelDock;

/// Arranges the panels around the view as docks that the user may move, and saves their places in the
/// settings. Panels that a mode does not need are hidden in it, unless the user has shown them there; what
/// the user has hidden stays hidden.
class WindowLayout final : public QObject {
  Q_OBJECT

public:
  /// The panels of the window beside the view; the window owns them.
  struct Panels {
    QWidget* rail;
    QWidget* organs;
    QWidget* handles;
    QWidget* properties;
    QWidget* timeline;
    QWidget* charts;
    QWidget* slides;
    QWidget* imports;
  };

  /// Adds "view.layout" and "view.fullScreen". Both have to live longer.
  WindowLayout(QMainWindow& window, Actions& actions);

  void place(const Panels& panels);
  /// The docks that can be shown and hidden.
  const std::vector<PanelDock*>& docks() const { return docks_; }
  /// The import panel, shown in front of the properties while files are checked; it is in no menu.
  PanelDock* imports() const { return imports_; }
  void showImports();
  void hideImports();
  /// Shows the panels that this mode needs or that the user has shown in it.
  void follow(const Mode& mode);
  /// With `bare` only the view is shown: no panels, menus, modes and status bar.
  void setBare(bool bare);
  bool bare() const { return bare_; }

  /// Makes the charts' panel at least so high; empty: restores its height before that.
  void fitCharts(std::optional<int> height);

  /// Restores the layout from the settings; call it after `place`.
  void restore(const Settings& settings);
  void save(Settings& settings) const;

private:
  PanelDock* addDock(const QString& title, const char* id, Qt::DockWidgetArea area, QWidget* contents,
                     bool scrolling);
  void placeRail(QWidget* rail);
  void bringBack();
  void arrange();
  bool eventFilter(QObject* watched, QEvent* event) override;
  void learnHeights();
  /// Sets the heights now, and again after Qt has laid out the panels.
  void keepHeights();
  void giveHeights();
  int heightOf(const QDockWidget& dock) const;
  void setFullScreen(bool full);
  void watchWindow(const QEvent& event);
  void widenPanels();

  /// The width that the user gave a panel, and the width of the window at that time.
  struct Width {
    int panel;
    int window;
  };

  QMainWindow& window_;
  std::vector<PanelDock*> docks_;
  PanelDock* properties_ = nullptr;
  PanelDock* imports_ = nullptr;
  PanelDock* timeline_ = nullptr;
  PanelDock* charts_ = nullptr;
  std::optional<int> chartsBefore_; ///< Their height before `fitCharts` made them higher.
  bool importing_ = false;
  bool bare_ = false;
  bool wasFullScreen_ = false; ///< Whether the window was in full screen before it was bare.
  QToolBar* rail_ = nullptr;
  std::string mode_; ///< The mode passed to `follow`, and the panels that it needs.
  UsefulPanels useful_;
  /// What the user has chosen, by "mode/panel".
  QVariantMap chosen_;
  QHash<QDockWidget*, int> heights_; ///< Heights that the user gave to panels that some modes hide.
  QHash<QDockWidget*, int> settled_; ///< Their heights after these were set.
  QHash<QDockWidget*, Width> widths_;
  QHash<QDockWidget*, int> pressed_; ///< Their widths when the mouse was pressed, maybe between two panels.
  int windowWidth_ = 0;              ///< When its size changed last.
  int timelineHeight_ = 0;           ///< Height of the timeline's rows at its last layout.
  bool resizing_ = false;            ///< Heights are about to be set again, so the present ones are not the
                                     ///< user's.
  std::vector<QWidget*> putAway_;    ///< The widgets that are hidden while the view is bare.
  QByteArray standard_;
};

} // namespace viscera::app
