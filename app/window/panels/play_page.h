#pragma once

#include "window/actions.h"
#include "window/timeline/volume_monitor.h"
#include "window/widgets/page.h"

class QComboBox;
class QTableWidget;

namespace viscera::app {

/// Play: the sequence, how fast time passes, and what the tracked volumes do over a beat.
class PlayPage final : public Page {
  Q_OBJECT

public:
  PlayPage(Playback& playback, VolumeMonitor& volumes, const Actions& actions, QWidget* parent = nullptr);

private:
  void syncState();
  void syncTable();

  Playback& playback_;
  VolumeMonitor& volumes_;
  QLabel* sequence_ = nullptr;
  QLabel* rate_ = nullptr;
  QLabel* period_ = nullptr;
  QLabel* phase_ = nullptr;
  QComboBox* speed_ = nullptr;
  QTableWidget* table_ = nullptr;
  QLabel* output_ = nullptr;
};

} // namespace viscera::app
