#pragma once

#include <QWidget>

#include "window/circulation/circulation_charts.h"
#include "window/style/theme.h"
#include "window/timeline/beat_strip.h"
#include "window/view/view_model.h"

namespace viscera::app {

/// The physiology of the beating heart below the view of a lecture, at the instant that is shown: the charts
/// of its circulation, or the strip of the textbook's beat. The view's `heartSigns` say which of their parts
/// are drawn.
class LectureSigns final : public QWidget {
  Q_OBJECT

public:
  /// All have to live longer. The charts are made when the first circulation is shown.
  struct Parts {
    CirculationModel& circulation;
    Playback& playback;
    VolumeMonitor& volumes;
    ViewModel& view;
  };
  explicit LectureSigns(const Parts& parts, QWidget* parent = nullptr);

  /// Follows the heart while it is on; else nothing is shown.
  void setOn(bool on);
  void setTheme(const Theme& theme);
  /// Takes its part of a screen of that height, at most `room` pixels; hides where that is too little.
  void fitInto(int screenHeight, int room);

Q_SIGNALS:
  /// The signs need another height.
  void wantedChanged();

private:
  enum class Drawn { nothing, textbook, circulation };

  void sync();
  void showInstant();
  void makeCharts();
  Drawn wanted() const;

  Parts parts_;
  Theme theme_;
  bool on_ = false;
  Drawn drawn_ = Drawn::nothing;
  Drawn toldDrawn_ = Drawn::nothing; ///< With the last `wantedChanged`.
  presentation::HeartSigns toldSigns_;
  BeatStrip* strip_;
  CirculationCharts* charts_ = nullptr;
};

} // namespace viscera::app
