#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/heart/cardiac_cycle.h"

/// The valves of a beating heart: how far each is open, what flows through it, and where its ring is.
namespace viscera::heart {

/// The four valves, in the order in which arrays hold them.
enum class HeartValve { mitral, aortic, tricuspid, pulmonary };
inline constexpr std::size_t kHeartValves = 4;

/// The opening of a valve and the flow through it at one instant.
struct ValveInstant {
  double areaMm2 = 0;    ///< Through which blood can pass, forwards or back; 0: shut and tight.
  double flowMlPerS = 0; ///< Forward positive; negative through a valve that leaks.

  friend bool operator==(const ValveInstant&, const ValveInstant&) = default;
};
using ValveInstants = std::array<ValveInstant, kHeartValves>;

/// The valves of the textbook's beat at `seconds` after its start: open between the times of its phases, 40
/// ms of each spent on the way, to normal areas (doi 10.1016/j.echo.2017.02.009); the flow is the change of
/// the ventricles' volumes. O(1).
ValveInstants textbookValves(const CardiacBeat& beat, double seconds);

/// The ring to which a valve's leaflets are attached, an ellipse.
struct ValveRing {
  Vec3 center = Vec3::Zero();      ///< mm
  Vec3 first = Vec3::UnitX();      ///< One half axis, mm.
  Vec3 second = Vec3::UnitY();     ///< The other; orthogonal to it.
  Vec3 downstream = Vec3::UnitZ(); ///< Unit, orthogonal to both: the normal direction of the flow.

  double areaMm2() const;
  /// Radius of the circle with the same area, mm.
  double radius() const;
};
using ValveRings = std::array<ValveRing, kHeartValves>;

/// The rings of the sample heart at rest: the mitral and the aortic one beside each other in the base of the
/// left ventricle's cavity, the tricuspid one in that of the right one, the pulmonary one at the end of its
/// outflow. They are a little larger than the normal areas, so that healthy flow is not restricted.
ValveRings sampleHeartRings();

/// A ring that moves with the surface around it: with the similarity (turn, shift, scale) that fits the
/// surface's vertices near the ring best (Umeyama 1991, doi 10.1109/34.88573). Immutable; thread-safe.
class CarriedRing {
public:
  /// `surface` is the surface at rest, `n x 3` mm. Throws `DataError` when it has fewer than three points.
  /// O(n).
  CarriedRing(const ValveRing& rest, const Points& surface);

  /// The ring moved with `surface` (the same vertices, moved). O(vertices near the ring).
  ValveRing at(const Points& surface) const;

private:
  ValveRing rest_;
  std::vector<Eigen::Index> anchors_;
  Eigen::Matrix3Xd atRest_; ///< The anchors, a column each.
};

} // namespace viscera::heart
