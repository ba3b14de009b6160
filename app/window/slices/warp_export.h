#pragma once

#include <QObject>

class QWidget;

namespace viscera::app {

class Actions;
class Settings;
class Workspace;

/// Exports the scan, and the label map that the organs came from, deformed by the present pose. Written by a
/// worker, which can be cancelled.
class WarpExport final : public QObject {
  Q_OBJECT

public:
  /// All have to live longer.
  WarpExport(Workspace& workspace, Settings& settings, QWidget* window);

  /// Adds "export.scan".
  void addTo(Actions& actions);
  /// Writes the scan (.nii, .nii.gz or .nrrd) and, where organs came from a label map, that one warped in the
  /// same way: "NAME.labels.nii.gz", "NAME.seg.nrrd".
  void exportScan(const QString& file);

private:
  void chooseAndExport();

  Workspace& workspace_;
  Settings& settings_;
  QWidget* window_;
};

} // namespace viscera::app
