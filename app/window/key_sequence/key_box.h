#pragma once

#include <QWidget>

#include "window/key_sequence/key_sequence_playback.h"
#include "window/work/actions.h"
#include "window/work/settings.h"

class QComboBox;
class QDoubleSpinBox;
class QPushButton;
class QTableWidget;

namespace viscera::app {

/// The controls that record a key sequence: each key stores the pose of Deform mode with a time. Keys are
/// listed, moved in time, given another easing, copied back to the document's pose, replaced and removed; the
/// sequence is played, saved and opened. Every change is an undo step.
class KeyBox final : public QWidget {
  Q_OBJECT

public:
  KeyBox(Workspace& workspace, Playback& playback, KeySequencePlayback& motion, Settings& settings,
         QWidget* parent = nullptr);

  /// Adds a key at the time and with the easing that are set.
  void addKey();

private:
  void makeTop();
  void makeTable();
  void makeButtons();
  void sync();
  void fillRow(int row);
  void onTimeEdited(int row);
  document::KeyId selectedKey() const;
  QString fileName(bool saving) const;
  void syncButtons();

  Workspace& workspace_;
  Playback& playback_;
  KeySequencePlayback& motion_;
  Settings& settings_;
  QDoubleSpinBox* seconds_ = nullptr;
  QComboBox* easing_ = nullptr;
  QTableWidget* table_ = nullptr;
  QDoubleSpinBox* period_ = nullptr;
  QPushButton* take_ = nullptr;
  QPushButton* replace_ = nullptr;
  QPushButton* remove_ = nullptr;
  QPushButton* play_ = nullptr;
  QPushButton* save_ = nullptr;
  bool filling_ = false;
  Subscription subscription_;
};

} // namespace viscera::app
