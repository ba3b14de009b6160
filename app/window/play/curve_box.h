#pragma once

#include <QWidget>

#include "window/timeline/playback.h"
#include "window/work/settings.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace viscera::app {

/// The controls that prescribe an organ's volume over the cycle of the present sequence by a file, and remove
/// it again. That belongs to the view: it is not an undo step, a session saves it, and another sequence
/// begins without it.
class CurveBox final : public QWidget {
  Q_OBJECT

public:
  CurveBox(Workspace& workspace, Playback& playback, Settings& settings, QWidget* parent = nullptr);

  /// Reads a file and prescribes it for the organ that is chosen; errors are shown as a message.
  void load(const QString& file);

private:
  void choose();
  void sync();

  Workspace& workspace_;
  Playback& playback_;
  Settings& settings_;
  QComboBox* organ_;
  QPushButton* choose_;
  QPushButton* remove_;
  QLabel* shown_;
};

} // namespace viscera::app
