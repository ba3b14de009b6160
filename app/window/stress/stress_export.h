#pragma once

#include <QObject>

#include "window/stress/stress_model.h"

class QWidget;

namespace viscera::app {

class Actions;

/// Exports the displayed stress map to the same files that `viscera stress` writes. Written by a worker, as a
/// whole or not at all.
class StressExport final : public QObject {
  Q_OBJECT

public:
  StressExport(Workspace& workspace, Playback& playback, StressModel& model, Settings& settings,
               QWidget* window);

  /// Adds "stress.exportMap", "stress.exportPoints", "stress.exportHistogram", "stress.exportCurve",
  /// "stress.exportProbes" and "stress.exportProfiles".
  void addTo(Actions& actions);

  /// Every value at every point (.vtu).
  void exportMap(const QString& file);
  /// The values at the witness points (.csv).
  void exportPoints(const QString& file);
  /// The histogram of the displayed quantity over the witness points (.csv).
  void exportHistogram(const QString& file);
  /// The rotational stress over one cycle of the sequence (.csv).
  void exportCurve(const QString& file);
  /// The pinned probes of the organ with their values (.csv).
  void exportProbes(const QString& file);
  /// The values along the lines between them (.csv).
  void exportProfiles(const QString& file);

private:
  void choose(const QString& title, const QString& name, const QString& filter,
              void (StressExport::*exporting)(const QString&));
  void write(const QString& what, const QString& file, std::function<void(Progress&)> work);

  Workspace& workspace_;
  Playback& playback_;
  StressModel& model_;
  Settings& settings_;
  QWidget* window_;
};

} // namespace viscera::app
