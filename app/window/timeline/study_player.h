#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "window/timeline/playback.h"
#include "window/view/view_model.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// The instant of a cine study or of a scan of several phases: that of the motion while the organs show one,
/// so that images and organs move together; else its own, which it plays and scrubs. The instant is part of
/// the view's state
/// (`presentation::CineLook`), where the slices read it.
class StudyPlayer final : public QObject {
  Q_OBJECT

public:
  /// All have to live longer.
  StudyPlayer(Workspace& workspace, ViewModel& view, Playback& playback, QObject* parent = nullptr);

  /// Whether there are images over time and no motion, so that the timeline is theirs.
  bool leads() const;
  /// Whether they are a scan, and not a study.
  bool ofScan() const { return hasImages() && !workspace_.state().study; }
  bool playing() const { return frames_.isActive(); }
  bool loop() const { return loop_; }
  /// The part of the cycle, [0, 1].
  double fraction() const { return view_.state().scan.cine.fraction; }
  /// The duration of the images' cycle; 0 without such images.
  double periodSeconds() const;

  void toggle();
  void pause();
  void setLooping(bool looping);
  void seek(double fraction);
  /// Goes by pictures of the first slice that is shown, or by phases of the scan.
  void step(int pictures);

Q_SIGNALS:
  /// Images came or went, or begin or end to play.
  void stateChanged();

private:
  bool hasImages() const;
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
