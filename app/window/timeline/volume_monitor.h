#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <array>
#include <optional>
#include <vector>

#include "viscera/motion/clinical_numbers.h"
#include "viscera/motion/volume_record.h"
#include "viscera/scene/color_map.h"
#include "window/timeline/playback.h"
#include "window/workspace.h"

namespace viscera::app {

/// Follows the volumes of the organs that are tracked: now, over the time of a sequence, and over the time in
/// which handles were dragged. Organs of a second view can be followed beside them. Tells at most ten times a
/// second that there is something new.
class VolumeMonitor final : public QObject {
  Q_OBJECT

public:
  /// One organ that is followed.
  struct Line {
    document::OrganId organ;
    int side = 0; ///< 1: in the second view; `organ` is one of that view's document.
    QString name;
    Vec3 color = Vec3::Ones();
    bool cavity = false; ///< A cavity has stroke volume and ejection fraction.
    double restMl = 0;
    double nowMl = 0;
  };

  VolumeMonitor(Workspace& workspace, Playback& playback, QObject* parent = nullptr);

  /// Follows the organs of a second view too, whose playback follows the first; null: no longer. They have to
  /// live until then.
  void setSecond(Workspace* workspace, Playback* playback);
  bool hasSecond() const { return sides_[1].workspace != nullptr; }

  /// The first view's organs come first.
  const std::vector<Line>& lines() const { return lines_; }
  /// The record of the sequence as played; one column a line, the time is the first view's.
  const motion::VolumeRecord& record() const { return record_; }
  /// The record of the last changes of the pose, ten rows a second while one goes on: time stands still
  /// between them. One column a line.
  const motion::VolumeRecord& drags() const { return drags_; }
  /// A line over one cycle of its sequence, as far as its instants were seen at this rate.
  const motion::CycleTrace& cycle(std::size_t line) const { return cycles_[line]; }
  /// The playback that moves a line's organ.
  const Playback& playbackOf(std::size_t line) const { return *sides_[lines_[line].side].playback; }
  /// Of a cavity, since the motion began or its rate changed; none before one whole beat was played.
  std::optional<motion::CardiacIndices> indices(std::size_t line) const;
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
  /// One view and what is known about its beat.
  struct Side {
    Workspace* workspace = nullptr;
    Playback* playback = nullptr;
    double since = 0; ///< Seconds played when its extremes began to be kept.
    double rate = 0;  ///< For which they are kept.
    std::vector<Subscription> subscriptions;
  };

  void watch(Side& side);
  std::vector<Line> linesOf(int side) const;
  void rebuild();
  void sample();
  void sampleDrag(bool goesOn);
  /// Forgets what was recorded.
  void restart();
  void restartSidesWithNewRates();
  /// Whether one whole beat of the line's sequence was seen.
  bool beatSeen(std::size_t line) const;

  std::array<Side, 2> sides_;
  std::vector<Line> lines_;
  motion::VolumeRecord record_;
  motion::VolumeRecord drags_;
  QElapsedTimer sinceDragged_; ///< Since the last row of a drag that goes on.
  bool dragging_ = false;
  std::vector<scene::ValueRange> extremes_; ///< For each line; frames do not meet the extremes in every beat.
  std::vector<motion::CycleTrace> cycles_;  ///< For each line.
  QTimer throttle_;
};

} // namespace viscera::app
