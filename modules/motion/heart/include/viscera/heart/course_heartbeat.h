#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/heart/beating_heart.h"
#include "viscera/heart/cavity_fit.h"

namespace viscera::heart {

/// A heartbeat given as states at evenly spaced instants, such as a computed circulation.
struct HeartCourse {
  Text name;                            ///< "Heartbeat: exercise"
  double period = 0;                    ///< s
  std::vector<HeartInstant> instants;   ///< At 0, 1/n, 2/n ... of the beat.
  std::vector<sequences::Phase> phases; ///< Covering [0, 1].
  std::vector<ValveInstants> valves{};  ///< As many as `instants`, or none if they are not known.
  std::optional<BeatClock> begins{};    ///< The clock at its beginning; empty if it is not known.

  /// Between two instants: linear. O(1).
  HeartInstant at(double phase) const;
  /// The valves at that instant; empty if they are not known. Linear in between. O(1).
  std::optional<ValveInstants> valvesAt(double phase) const;
  /// The clock at that instant; empty if it is not known. O(1).
  std::optional<BeatClock> clockAt(double phase) const;
};

/// The heartbeat of a course, in which the heart's cavities have the course's volumes at every instant. It
/// has one rate, that of the course: another rate is another course. Immutable; thread-safe.
class CourseHeartbeat final : public sequences::Sequence, public BeatingHeart {
public:
  /// Throws `DataError` when the course has fewer than eight instants or no period, or when its volumes
  /// cannot be reached somewhere; `Cancelled`.
  CourseHeartbeat(CavityFit fit, HeartCourse course, Progress& progress);
  /// The same heart with a course that is similar to that of `similar`: its search begins with the solutions
  /// of `similar`, and nothing is checked beforehand, so that it is made at once. `poseAt` throws `DataError`
  /// where the volumes cannot be reached. Throws `DataError` for a course without instants or period.
  CourseHeartbeat(const CourseHeartbeat& similar, HeartCourse course);

  std::string id() const override { return "heartbeat"; }
  Text name() const override { return course_.name; }
  const Points& restHandles() const override { return fit_.restHandles(); }
  std::vector<sequences::HandleGroup> groups() const override { return fit_.motion().rig().groups(); }
  double standardRatePerMinute() const override { return 60 / course_.period; }
  double lowestRatePerMinute() const override { return 60 / course_.period; }
  double highestRatePerMinute() const override { return 60 / course_.period; }
  std::vector<sequences::Phase> phases(double /*ratePerMinute*/) const override { return course_.phases; }

  double finestStepSeconds() const override { return 0.01; }

  const BeatingHeart* heart() const override { return this; }
  std::optional<CardiacBeat> textbookBeat(double /*ratePerMinute*/) const override { return std::nullopt; }
  std::optional<ValveInstants> valves(double seconds, double /*ratePerMinute*/) const override {
    return course_.valvesAt(seconds / course_.period);
  }
  std::optional<BeatClock> clock(double seconds, double /*ratePerMinute*/) const override {
    return course_.clockAt(seconds / course_.period);
  }
  std::optional<HeartFrame> frame() const override { return motion().rig().anatomy.frame; }

  /// Costs one `CavityFit::pose` from a near solution.
  void poseAt(double seconds, double ratePerMinute, Points& pose) const override;

  const HeartMotion& motion() const { return fit_.motion(); }
  const HeartCourse& heartCourse() const { return course_; }

private:
  CavityFit fit_;
  HeartCourse course_;
  std::vector<FoundCavities> found_; ///< Solutions at the checked instants, from which searches at others
                                     ///< begin.
};

} // namespace viscera::heart
