#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "viscera/heart/clinical_numbers.h"
#include "viscera/heart/heart_numbers.h"
#include "viscera/live/cycle_curves.h"
#include "viscera/live/motion_copy.h"
#include "viscera/scene/color_map.h"
#include "viscera/sequences/volume_record.h"
#include "window/timeline/playback.h"
#include "window/work/workspace.h"

namespace viscera::app {

class MeasuredMotion;

/// Measures the volumes of the tracked organs: now, over the time of a sequence, and over the time in which
/// handles were dragged. A worker also measures the whole cycle of each view's sequence ahead, so that
/// curves, extremes and ejection fractions are exact before a frame of it was played. Organs of a second view
/// can be tracked too. Emits `shown` with every frame of a sequence or of a drag, for texts, and `updated` at
/// most ten times a second, for charts.
class VolumeMonitor final : public QObject {
  Q_OBJECT

public:
  static constexpr std::size_t kMostLines = 8;

  /// One tracked organ.
  struct Line {
    document::OrganId organ;
    int side = 0; ///< 1: in the second view; `organ` is one of that view's document.
    QString name; ///< In the language of the window.
    Vec3 color = Vec3::Ones();
    bool cavity = false; ///< A cavity, or a chamber by its name, has stroke volume and ejection fraction.
    double restMl = 0;
    double nowMl = 0;
    std::string label; ///< The name as the numerical modules know it: for normal ranges and tables.
  };

  VolumeMonitor(Workspace& workspace, Playback& playback, QObject* parent = nullptr);

  /// Also tracks the organs of a second view, whose playback follows the first; null: stops that. Both have
  /// to live until then.
  void setSecond(Workspace* workspace, Playback* playback);
  bool hasSecond() const { return sides_[1].workspace != nullptr; }
  /// Sets the source of tracked motions, which determines which organs move as a patient's heart was
  /// measured.
  void setMeasured(const MeasuredMotion& measured);

  /// The first view's organs come first. Hidden organs are left out. Of more than `kMostLines` whole organs
  /// in a view, the chosen one and the largest are there: more curves than that tell nothing apart.
  const std::vector<Line>& lines() const { return lines_; }
  /// How many visible, tracked organs have no line.
  int unlisted() const { return unlisted_; }
  /// The line of the organ that is chosen in the first view; behind the last one for none.
  std::size_t chosenLine() const;
  /// A line's name; with two views, preceded by the number of its view.
  QString nameOf(const Line& line) const;
  /// The record of the sequence as played; one column for each line, the time is the first view's.
  const sequences::VolumeRecord& record() const { return record_; }
  /// The record of the last changes of the pose, ten rows a second while one goes on: time stands still
  /// between them. A pose that changes while a sequence is shown instead is recorded once it is shown. One
  /// column for each line.
  const sequences::VolumeRecord& drags() const { return drags_; }
  /// Whether the mouse holds what changes the pose.
  bool dragging() const { return dragging_; }
  /// A volume over one cycle.
  struct Curve {
    std::vector<double> fractions; ///< Ascending, in [0, 1].
    std::vector<double> milliliters;
  };
  /// A line over one cycle of its sequence at the present rate, with the present handles, coordinates and
  /// locks. Empty while no sequence moves it, and while the cycle is being measured.
  Curve cycle(std::size_t line) const;
  /// A number that changes whenever a `cycle` changes or becomes empty.
  int cycles() const { return cycles_; }
  /// The playback that moves a line's organ.
  const Playback& playbackOf(std::size_t line) const { return *sides_[lines_[line].side].playback; }
  /// Whether the volumes of a line over its cycle are estimates: those of a motion from images and labels of
  /// one phase only. Texts about its numbers say so.
  bool isEstimate(std::size_t line) const;
  /// The indices of a cavity, from `cycle`; none while that is empty, and of a right ventricle whose volumes
  /// are estimates: what its images show falls short too far.
  std::optional<heart::CardiacIndices> indices(std::size_t line) const;
  /// The smallest and the largest volume of `cycle`, ml; none while that is empty.
  std::optional<scene::ValueRange> range(std::size_t line) const;
  /// Whether a line's organ has a heartbeat to follow: the textbook's, one that was fitted, computed by a
  /// circulation or measured. Keys that were recorded by hand are none.
  bool beats(std::size_t line) const;
  /// The normal ranges of a line for that person; ranges for a beating heart only if `beats`.
  std::vector<heart::NormalRange> normals(std::size_t line, const anatomy::Person& person) const;
  /// The cavity of a measured motion whose beat the timeline shows: the chosen one, or the first; none while
  /// its cycle is not known.
  std::optional<std::size_t> measuredLine() const;
  /// The ends of diastole and systole of a line, found or chosen; none while its cycle is not known.
  std::optional<heart::CycleEnds> ends(std::size_t line, const heart::ChosenEnds& chosen) const;
  /// The numbers of a cavity at those ends, indexed by that body surface (m2; 0: not); empty as above.
  std::vector<heart::HeartNumber> numbers(std::size_t line, const heart::ChosenEnds& chosen,
                                          double bodySurfaceM2) const;
  /// How the walls of the first view's heart move over the cycle; none for other organs, and while the cycle
  /// is being measured.
  std::optional<heart::WallMotion> wall() const;
  /// Measures the volumes now.
  void refresh();
  void update();

Q_SIGNALS:
  /// The tracked organs have changed, and all records were cleared.
  void linesChanged();
  /// Another organ is chosen.
  void chosenChanged();
  /// The volumes of `lines` were updated to the shown pose; emitted with every frame of a sequence or of a
  /// drag, and with `updated`. For texts; charts take too long to draw.
  void shown();
  /// New volumes or another measured cycle, at most ten times a second.
  void updated();

private:
  /// A right ventricle with estimates has no indices.
  bool isUncertain(std::size_t line) const;
  /// One view and what is known about its beat.
  struct Side {
    Workspace* workspace = nullptr;
    Playback* playback = nullptr;
    std::optional<live::MotionCause> cause;  ///< The cause of the present or pending measurement.
    std::optional<live::CycleCurves> curves; ///< None while it is being measured.
    std::vector<Subscription> subscriptions = {};
    int ticket = 0; ///< Number of the newest measurement; results of older ones are ignored.
  };

  void watch(Side& side);
  std::vector<Line> linesOf(int side) const;
  /// The whole organs of a view that have a line, each with its cavities.
  static std::set<document::OrganId> chartedIn(Workspace& workspace);
  void rebuild();
  void followFrame();
  void sample();
  bool posesAreSeen() const;
  void sampleDrag(bool goesOn);
  void addDrag(bool begins);
  /// Schedules measuring after all observers were notified of a change, and later if no cycle is visible.
  void measureSoon(const Side& side);
  /// Begins to measure each cycle whose cause has changed.
  void measureCycles();
  void measure(int side);

  std::array<Side, 2> sides_;
  int cycles_ = 0;
  std::vector<Line> lines_;
  int unlisted_ = 0;
  sequences::VolumeRecord record_;
  sequences::VolumeRecord drags_;
  QPointer<const MeasuredMotion> measured_;
  QElapsedTimer sinceDragged_; ///< Time since the last row of the present drag.
  bool dragging_ = false;
  bool dragsBehind_ = false; ///< The pose was changed while it was not shown.
  QTimer throttle_;
  QTimer frame_;       ///< Ends when the frame with the new positions is drawn.
  QTimer measureSoon_; ///< Until cycles are measured.
};

} // namespace viscera::app
