#pragma once

#include <QWidget>

#include <string>
#include <utility>
#include <vector>

#include "viscera/heart/heart_numbers.h"
#include "window/modes/mode.h"
#include "window/timeline/measured_motion.h"
#include "window/timeline/volume_monitor.h"

class QLabel;
class QTableWidget;

namespace viscera::app {

/// The clinical numbers of the cavities of a measured motion at the ends of diastole and systole, also for
/// each square metre of body surface; buttons that choose these ends, ask for height and weight, and write
/// the table as CSV. Hidden without such a motion.
class HeartNumbersBox final : public QWidget {
  Q_OBJECT

public:
  /// All have to live longer.
  HeartNumbersBox(const ModeParts& parts, const MeasuredMotion& measured, QWidget* parent = nullptr);

  /// Writes what the table shows (docs/user_guide.md).
  void writeCsv(const QString& file);

private:
  using Ventricles = std::vector<std::pair<std::string, std::vector<heart::HeartNumber>>>;

  QWidget* makeButtons();
  void sync();
  /// While something plays, the view changes with every frame, and the numbers do not.
  void syncIfNew();
  Ventricles ventricles() const;
  void askForSize();
  QString personText() const;
  void chooseAndWriteCsv();

  Workspace& workspace_;
  Playback& playback_;
  VolumeMonitor& volumes_;
  ViewModel& view_;
  Settings& settings_;
  const MeasuredMotion& measured_;
  int madeOf_ = -1; ///< The monitor's `cycles` when the table was made.
  heart::ChosenEnds madeWith_;
  anatomy::Person madeFor_;
  QLabel* ends_;
  QLabel* about_; ///< Whether the numbers are estimates, and whose body surface they are for.
  QTableWidget* table_;
};

} // namespace viscera::app
