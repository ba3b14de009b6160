#pragma once

#include <QWidget>

#include "window/style/theme.h"
#include "window/timeline/measured_motion.h"

class QCheckBox;
class QComboBox;
class QStackedLayout;
class QTableWidget;

namespace viscera::app {

class ElidedLabel;
class PlaneTable;

/// A table of how well a tracked motion fits the measured series, for each phase, of all surfaces together or
/// of one: distances, measured volumes and those of the fit, the wall's volume, flipped triangles, folded
/// tissue. A click on a row shows its phase. Of a motion from images it says which phases have labels, marks
/// the ends of diastole and systole and estimates, and has a table of the planes. If another series was
/// tracked before, the table can show the differences between both. Above the table are the switches for
/// measured surfaces and distances in the view.
class ResidualTable final : public QWidget {
  Q_OBJECT

public:
  ResidualTable(MeasuredMotion& measured, Playback& playback, QWidget* parent = nullptr);

  void setTheme(const Theme& theme);

  QSize sizeHint() const override;

private:
  QWidget* makeHead();
  void makeTable();
  void rebuild();
  void fill();
  void syncSwitches();
  void fillRow(int row, const live::TrackedPhase& phase);
  void fillDifferences();
  void markPhase();
  /// A volume in a phase, with the sign of an estimate where it is one.
  QString volume(std::size_t phase, double ml) const;
  QStringList summary() const;
  QStringList reasonsOf(std::size_t phase) const;
  QString phaseName(std::size_t phase) const;
  /// The surface that is shown; -1: all together; -2: the differences from the series before; -3: the planes.
  int surface() const;

  MeasuredMotion& measured_;
  Playback& playback_;
  QComboBox* surfaces_;
  QCheckBox* ghost_ = nullptr;
  QCheckBox* distances_ = nullptr;
  ElidedLabel* summary_;
  QStackedLayout* stack_;
  QTableWidget* table_;
  QTableWidget* differences_;
  PlaneTable* planes_;
  std::size_t planesOf_ = 0; ///< The phase that the table of planes shows.
  Theme theme_;
};

} // namespace viscera::app
