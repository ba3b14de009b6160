#pragma once

#include <QObject>

#include <functional>

#include "viscera/core/progress.h"

class QWidget;

namespace viscera::app {

class Actions;
class Settings;
class Workspace;

/// The actions that export the present pose for other programs: displacements, a displacement field, tables
/// of volumes and of what is measured. Written by a worker, as a whole or not at all.
class ExportActions final : public QObject {
  Q_OBJECT

public:
  ExportActions(Workspace& workspace, Settings& settings, QWidget* window);

  /// Adds "export.organs", "export.displacements", "export.transform", "export.table" and
  /// "export.measurements".
  void addTo(Actions& actions);

  /// All organs that are shown, as they are posed, with names and colours (.glb).
  void exportOrgans(const QString& file);
  /// The current organ at rest with where each vertex went (.vtp).
  void exportDisplacements(const QString& file);
  /// The motion of the space around the current organ, for 3D Slicer and ITK (.nrrd, .mha).
  void exportTransform(const QString& file);
  /// Volumes and sizes of all organs (.csv).
  void exportTable(const QString& file);
  /// Everything that is measured, at rest and now (.csv).
  void exportMeasurements(const QString& file);

private:
  void choose(const QString& title, const QString& name, const QString& filter,
              void (ExportActions::*exporting)(const QString&));
  void write(const QString& what, const QString& file, std::function<QString(Progress&)> work);

  Workspace& workspace_;
  Settings& settings_;
  QWidget* window_;
};

} // namespace viscera::app
