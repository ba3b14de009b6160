#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "window/timeline/playback.h"
#include "window/view/view_model.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// The instant of a cine study: that of the motion while the organs show one, so that images and organs move
/// together; else its own, which it plays and scrubs. The instant is part of the view's state
/// (`presentation::CineLook`), where the slices read it.
class StudyPlayer final : public QObject {
  Q_OBJECT

public:
  /// All have to live longer.
  StudyPlayer(Workspace& workspace, ViewModel& view, Playback& playback, QObject* parent = nullptr);

  /// Whether there is a study and no motion, so that the timeline is the study's.
  bool leads() const;
  bool playing() const { return frames_.isActive(); }
  bool loop() const { return loop_; }
  /// The part of the cycle, [0, 1].
  double fraction() const { return view_.state().scan.cine.fraction; }
  /// The duration of the study's cycle; 0 without a study.
  double periodSeconds() const;

  void toggle();
  void pause();
  void setLooping(bool looping);
  void seek(double fraction);
  /// Goes by pictures of the first slice that is shown.
  void step(int pictures);

Q_SIGNALS:
  /// A study came or went, or begins or ends to play.
  void stateChanged();

private:
  void followMotion();
  void advance();

  Workspace& workspace_;
  ViewModel& view_;
  Playback& playback_;
  QTimer frames_;
  QElapsedTimer clock_; ///< Since the last frame.
  bool loop_ = true;
  Subscription subscription_;
};

} // namespace viscera::app
