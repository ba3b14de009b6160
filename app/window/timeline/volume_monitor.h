#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <optional>
#include <vector>

#include "viscera/scene/color_map.h"
#include "viscera/session/cardiac_indices.h"
#include "viscera/session/volume_record.h"
#include "window/timeline/playback.h"
#include "window/workspace.h"

namespace viscera::app {

/// Follows the volumes of the organs that are tracked: now, over the time of a sequence, and over the time in
/// which handles were dragged. Tells at most ten times a second that there is something new.
class VolumeMonitor final : public QObject {
  Q_OBJECT

public:
  /// One organ that is followed.
  struct Line {
    session::OrganId organ;
    QString name;
    Vec3 color = Vec3::Ones();
    bool cavity = false; ///< A cavity has stroke volume and ejection fraction.
    double restMl = 0;
    double nowMl = 0;
  };

  VolumeMonitor(Workspace& workspace, Playback& playback, QObject* parent = nullptr);

  const std::vector<Line>& lines() const { return lines_; }
  /// The record of the sequence as played; one column a line.
  const session::VolumeRecord& record() const { return record_; }
  /// The record of the last changes of the pose, ten rows a second while one goes on: time stands still
  /// between them. One column a line.
  const session::VolumeRecord& drags() const { return drags_; }
  /// Of a cavity, since the motion began or its rate changed; none before one whole beat was played.
  std::optional<session::CardiacIndices> indices(std::size_t line) const;
  /// The smallest and the largest volume since then, ml; none before one whole beat was played.
  std::optional<scene::ValueRange> range(std::size_t line) const;
  /// Volumes as they are this moment.
  void refresh();

Q_SIGNALS:
  /// Other organs are followed: everything that was recorded is gone.
  void linesChanged();
  /// New volumes, at most ten times a second.
  void updated();

private:
  void rebuild();
  void sample();
  void sampleDrag(bool goesOn);
  /// Forgets what was recorded.
  void restart();
  /// Whether one whole beat was seen since.
  bool beatSeen() const;

  Workspace& workspace_;
  Playback& playback_;
  std::vector<Line> lines_;
  session::VolumeRecord record_;
  session::VolumeRecord drags_;
  QElapsedTimer sinceDragged_; ///< Since the last row of a drag that goes on.
  bool dragging_ = false;
  std::vector<scene::ValueRange> extremes_; ///< For each line; frames do not meet the extremes in every beat.
  double sampledSince_ = 0;
  double sampledRate_ = 0;
  QTimer throttle_;
  std::vector<session::Subscription> subscriptions_;
};

} // namespace viscera::app
