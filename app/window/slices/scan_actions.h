#pragma once

#include <QMenu>
#include <QObject>

#include <optional>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/document/scan_item.h"
#include "viscera/document/study_item.h"
#include "window/view/view_model.h"
#include "window/work/actions.h"
#include "window/work/settings.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// The actions that open and close a scan and change how it is shown: layouts of the views, level and width,
/// thickness.
class ScanActions final : public QObject {
  Q_OBJECT

public:
  /// All have to live longer.
  ScanActions(Workspace& workspace, ViewModel& view, Settings& settings, QWidget* window);

  /// Adds "file.openScan", "file.openSeries", "scan.close", the layouts, the presets and the switches.
  void addTo(Actions& actions);
  /// The context menu of a slice: level, width and others. Filled by `addTo`.
  QMenu* sliceMenu() { return &menu_; }
  const QMenu& sliceMenu() const { return menu_; }
  /// The ids of all layouts, and of the switches, for a menu.
  const std::vector<const char*>& layouts() const { return layouts_; }
  const std::vector<const char*>& switches() const { return switches_; }

  /// Reads a scan or a cine study on a worker and adds it to the document; asks for the series if there are
  /// several that are no study.
  void open(const QString& fileOrFolder);
  /// Shows all of a scan or study that was just added to the document, and a message about its findings.
  void opened();
  /// Shows a message about organs, just added, that do not fit the scan.
  void reportScanFit();

Q_SIGNALS:
  /// The user has chosen another layout, or opening a scan has changed it.
  void layoutChosen();

private:
  /// What is at a place: a study, or series to choose from.
  struct Found {
    std::optional<document::StudyItem> study;
    std::vector<medical_io::ScanSeries> series;
  };

  void makeLayouts(Actions& actions);
  void makePresets(Actions& actions);
  void makeSwitches(Actions& actions);
  void chooseAndOpen(bool folder);
  void take(const QString& place, Found found);
  void choose(const QString& place, const std::vector<medical_io::ScanSeries>& series);
  void read(const QString& place, const medical_io::ScanOptions& options);
  void showFromHere();
  /// `partly`: the scan has not all slices of its series; others are offered.
  void reportScanFindings(const std::vector<Text>& sentences, bool partly);
  /// Adds a checkable action that is checked while the view has that choice.
  void addChoice(Actions& actions, const char* id, const Actions::Description& description,
                 std::function<bool(const presentation::ScanLook&)> chosen,
                 std::function<void(presentation::ScanLook&)> choose);

  Workspace& workspace_;
  ViewModel& view_;
  Settings& settings_;
  QWidget* window_;
  QMenu menu_;
  std::vector<const char*> layouts_, switches_;
};

} // namespace viscera::app
