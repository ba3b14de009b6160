#pragma once

#include <QByteArray>
#include <QDockWidget>
#include <QHash>
#include <QObject>
#include <QSet>
#include <QSize>

#include <optional>
#include <vector>

#include "window/modes/mode.h"
#include "window/work/actions.h"
#include "window/work/settings.h"

class QMainWindow;
class QToolBar;

namespace viscera::app {

class PanelDock;

/// Arranges the panels around the view as docks that the user may move, and saves their places in the
/// settings. Panels that a mode does not need are hidden in it, unless the user has shown them there; what
/// the user has hidden stays hidden. In a small window panels fold until the view has its part of it, and are
/// back once there is room; those that the user asks for there stay.
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
  /// Shows only the view with `bare`: no panels, menus, modes and status bar.
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
  void giveCorners();
  void bringBack();
  void arrange();
  void showPanels();
  bool isWanted(const QDockWidget& dock) const;
  /// Panels that are hidden together where the view has too little room.
  struct FoldingGroup {
    std::vector<QDockWidget*> panels;
    double part; ///< Of the window: while the view has less than this part, the panels fold.
  };
  /// Groups in the order in which they fold: first the panels that the mode needs least.
  std::vector<FoldingGroup> foldingGroups() const;
  QSet<QDockWidget*> withoutRoom() const;
  double partOfView(const QSet<QDockWidget*>& folded) const;
  QSize roomForAll() const;
  int expectedWidth(QDockWidget& dock) const;
  int expectedHeight(QDockWidget& dock) const;
  void fitSoon();
  void fitPanels();
  bool eventFilter(QObject* watched, QEvent* event) override;
  void learnHeights();
  /// Sets the heights now, and again after Qt has laid out the panels.
  void keepHeights();
  void applyPanelHeights();
  int heightOf(const QDockWidget& dock) const;
  void setFullScreen(bool full);
  void watchWindow(const QEvent& event);
  void giveWidths();

  /// The width that the user gave a panel, and the width of the window at that time.
  struct Width {
    int panel;
    int window;
  };
  int widthOf(const Width& wish) const;

  QMainWindow& window_;
  QAction* fullScreen_ = nullptr;
  std::vector<PanelDock*> docks_;
  PanelDock* organs_ = nullptr;
  PanelDock* handles_ = nullptr;
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
  QSet<QDockWidget*> folded_;        ///< For want of room.
  QSet<QString> kept_;               ///< What the user has shown in spite of that, as in `chosen_`.
  bool restored_ = false;            ///< Before that the window has no size of its own.
  bool fitting_ = false;             ///< Panels will be fitted to the window.
  QHash<QDockWidget*, int> heights_; ///< Of panels that come and go with the modes, as the user left them.
  QHash<QDockWidget*, int> settled_; ///< What they were once these had been given.
  QHash<QDockWidget*, Width> widths_;
  QHash<QDockWidget*, int> pressed_; ///< Their widths when the mouse was pressed, maybe between two panels.
  int timelineHeight_ = 0;           ///< What its rows took when it last had its layout.
  bool resizing_ = false;            ///< Heights are to be given once more: what they are now says nothing.
  std::vector<QWidget*> putAway_;    ///< While it is bare.
  QByteArray standard_;
};

/// How large the window is at its first start on a screen with so much room.
QSize firstWindowSize(const QSize& available);

} // namespace viscera::app
