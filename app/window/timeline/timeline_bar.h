#pragma once

#include <QWidget>
#include <vector>

#include "window/timeline/beat_strip.h"
#include "window/timeline/phase_scrubber.h"
#include "window/timeline/playback.h"
#include "window/timeline/study_player.h"
#include "window/timeline/volume_monitor.h"
#include "window/view/view_model.h"
#include "window/work/actions.h"

class QAction;
class QComboBox;
class QLabel;
class QSlider;
class QSpinBox;
class QToolButton;

namespace viscera::app {

/// Shows a rate of the sequence in whole cycles per minute, without emitting signals. The box also accepts it
/// if the sequence's range holds no other whole number: the beat of a circulation has one rate, which may
/// have a fraction and cannot be changed here. The tooltip names the range, or what determines the rate.
void showRate(QSpinBox& box, const sequences::Sequence& sequence, double ratePerMinute);

/// The buttons and the strip that play a sequence: to the start, step, play or pause, loop, rate, slow
/// motion, the cycle with its phases; and the actions that do the same by keys. In a narrow bar the name of
/// the phase goes, then the slider of the rate: the strip and the box beside it say the same.
class TimelineBar final : public QWidget {
  Q_OBJECT
public:
  /// Adds "play.toggle", "play.start", "play.loop" and the steps: "play.back", "play.forward",
  /// "play.backFinely", "play.forwardFinely". Both have to live longer.
  TimelineBar(Playback& playback, Actions& actions, QWidget* parent = nullptr);

  /// Shows electrocardiogram, sounds and valves of a textbook's beat while the view wants them, and plays the
  /// cine study while there is one and no motion. Both have to live longer.
  /// Marks the ends of diastole and systole of a measured motion.
  void follow(const ViewModel& view, StudyPlayer& study, const VolumeMonitor& volumes);

  /// The least size, without what a narrow bar leaves out.
  QSize minimumSizeHint() const override;

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  void addTo(Actions& actions);
  template <typename Clicked>
  QToolButton* addButton(const char* iconName, const QString& tip, Clicked clicked);
  void addRate();
  void sync();
  void syncSequence(const sequences::Sequence& sequence);
  void clearSequence();
  void syncStudy();
  /// Whether the timeline is the study's.
  bool ofStudy() const { return study_ && study_->leads(); }
  void toggle();
  void seek(double fraction);
  void step(int frames, bool finely = false);
  void setLooping(bool looping);
  void setSignsShown(bool shown);
  void syncInstant();
  void syncSigns();
  int widthWith(int strip, bool slider, bool phase) const;
  void leaveOut();

  Playback& playback_;
  StudyPlayer* study_ = nullptr;    ///< Null until `follow`.
  std::vector<QAction*> transport_; ///< Usable while there is a sequence.
  QAction* loopAction_ = nullptr;
  QToolButton* play_ = nullptr;
  QToolButton* loop_ = nullptr;
  QSpinBox* rate_ = nullptr;
  QSlider* rateSlider_ = nullptr;
  QComboBox* speed_ = nullptr;
  PhaseScrubber* scrubber_ = nullptr;
  BeatStrip* signs_ = nullptr;
  bool signsShown_ = false;
  QLabel* phase_ = nullptr;
};

} // namespace viscera::app
