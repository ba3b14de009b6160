#pragma once

#include <QWidget>

#include "window/timeline/phase_scrubber.h"

class QComboBox;
class QLabel;
class QSlider;
class QSpinBox;
class QToolButton;

namespace viscera::app {

/// Transport of a sequence: to the start, step, play or pause, loop, rate, slow motion, the cycle with its
/// phases. Knows
/// nothing of sequences: shows what it is told and says what the user did.
class TimelineBar final : public QWidget {
  Q_OBJECT

public:
  explicit TimelineBar(QWidget* parent = nullptr);

  /// The sequence to show: name, the unit of its rate ("beats / min"), rates it may be played at.
  void setSequence(const QString& name, const QString& rateUnit, double lowest, double highest);
  /// No sequence: everything is disabled and a line says where sequences come from.
  void clearSequence();
  void setPhases(std::vector<PhaseBand> phases);
  /// The way of what travels through the organ, and what is on it now.
  void setCourse(std::vector<CoursePlace> course);
  void setMarks(std::vector<CourseMark> marks);
  void setRate(double perMinute);
  /// How fast time passes; 1 is real time.
  void setSpeed(double speed);
  void setPlaying(bool playing);
  void setLooping(bool looping);
  /// The present instant; `fraction` of the cycle.
  void setInstant(double fraction, double seconds);

Q_SIGNALS:
  void playToggled();
  void loopToggled(bool looping);
  void rateChosen(double perMinute);
  void speedChosen(double speed);
  void scrubbed(double fraction);
  /// One frame back (-1) or forward (1).
  void stepRequested(int frames);
  void startRequested();

private:
  QToolButton* addButton(const char* iconName, const QString& tip);

  QToolButton* start_ = nullptr;
  QToolButton* back_ = nullptr;
  QToolButton* play_ = nullptr;
  QToolButton* forward_ = nullptr;
  QToolButton* loop_ = nullptr;
  QSpinBox* rate_ = nullptr;
  QSlider* rateSlider_ = nullptr;
  QComboBox* speed_ = nullptr;
  PhaseScrubber* scrubber_ = nullptr;
  QLabel* phase_ = nullptr;
};

} // namespace viscera::app
