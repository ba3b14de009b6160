#pragma once

#include <QByteArray>
#include <QObject>

#include <optional>
#include <vector>

#include "window/actions.h"
#include "window/settings.h"

class QMainWindow;

namespace viscera::app {

class PanelDock;

/// Where the panels stand around the view: docks that the user may move, which the settings remember.
class WindowLayout final : public QObject {
  Q_OBJECT

public:
  /// What stands in the window beside the view, which owns it.
  struct Panels {
    QWidget* rail;
    QWidget* organs;
    QWidget* handles;
    QWidget* properties;
    QWidget* timeline;
    QWidget* charts;
    QWidget* imports;
  };

  /// Adds "view.layout". Both have to live longer.
  WindowLayout(QMainWindow& window, Actions& actions);

  void place(const Panels& panels);
  /// The docks that can be shown and hidden.
  const std::vector<PanelDock*>& docks() const { return docks_; }
  /// The panel of imports is only there while files are looked at: in front of the properties, in no menu.
  PanelDock* imports() const { return imports_; }
  void showImports();
  void hideImports();

  /// Makes the charts' panel at least so high; nothing: as high as it was before that.
  void fitCharts(std::optional<int> height);

  /// As the settings have it; after `place`.
  void restore(const Settings& settings);
  void save(Settings& settings) const;

private:
  PanelDock* addDock(const QString& title, const char* id, Qt::DockWidgetArea area, QWidget* contents,
                     bool scrolling);
  void placeRail(QWidget* rail);
  void bringBack();

  QMainWindow& window_;
  std::vector<PanelDock*> docks_;
  PanelDock* properties_ = nullptr;
  PanelDock* imports_ = nullptr;
  PanelDock* charts_ = nullptr;
  std::optional<int> chartsBefore_; ///< Their height before `fitCharts` made them higher.
  bool importing_ = false;
  QByteArray standard_;
};

} // namespace viscera::app
