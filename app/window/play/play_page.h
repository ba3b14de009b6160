#pragma once

#include <optional>
#include <vector>

#include "viscera/heart/clinical_numbers.h"
#include "window/key_sequence/fit_offer.h"
#include "window/movie/movie_box.h"
#include "window/play/play_mode.h"
#include "window/timeline/volume_monitor.h"
#include "window/widgets/page.h"
#include "window/work/actions.h"

class QAbstractButton;
class QTableWidget;

namespace viscera::app {

/// The property page of the mode Play: sequences, appearance, tracked volumes with normal ranges, movies, and
/// motions of the user's own.
class PlayPage final : public Page {
  Q_OBJECT

public:
  PlayPage(const ModeParts& parts, PlayMode& mode, const Actions& actions, QWidget* parent = nullptr);

private:
  void makeMotion(const ModeParts& parts, const Actions& actions);
  void makeCirculation(const ModeParts& parts, const Actions& actions);
  void makeTable();
  void makePatientCirculation(Workspace& workspace);
  void syncPatientCirculation();
  void makeRecording(Settings& settings);
  void makeOwnMotions(const ModeParts& parts);
  void syncState();
  void syncPhase();
  void syncTable();
  void fillRow(std::size_t line);
  void syncIndices();
  void syncWalls();

  Playback& playback_;
  VolumeMonitor& volumes_;
  PlayMode& mode_;
  ViewModel& view_;
  FitOffer* offer_ = nullptr;
  QLabel* rate_ = nullptr;
  QLabel* phase_ = nullptr;
  QWidget* cycleHead_ = nullptr; ///< Of the table, which is shown with a sequence.
  QTableWidget* table_ = nullptr;
  QLabel* fraction_ = nullptr;
  QLabel* stroke_ = nullptr;
  QLabel* output_ = nullptr;
  std::vector<QLabel*> walls_; ///< In the order of `heart::wallMotionRanges`.
  QLabel* normal_ = nullptr;
  QAbstractButton* patient_ = nullptr; ///< The button "Circulation of this heart".
  QLabel* patientFit_ = nullptr;
  /// The left ventricle of an organ with a tracked motion; empty while there is none.
  std::optional<heart::CardiacIndices> ventricle_;
  MovieBox* record_ = nullptr;
  Subscription subscription_;
};

} // namespace viscera::app
