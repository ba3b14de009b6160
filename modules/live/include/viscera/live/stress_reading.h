#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/deformation/witness_interpolation.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/live/stress_quantity.h"

/// Interpolates a stress map at any point: at probes, and along profiles.
namespace viscera::live {

/// The values of a stress map at one material point. Numbers are not finite where there is no tissue.
struct StressReading {
  Vec3 rest = Vec3::Zero(); ///< Where the point lies at rest, mm, LPS.
  Vec3 now = Vec3::Zero();  ///< Where it lies in the pose.
  bool inTissue = false;
  bool folded = false; ///< One of the mesh's points around it is folded; the numbers are then unreliable.
  double stressDegrees = 0;
  double volumeRatio = 0;
  double stretchMax = 0;
  double stretchMin = 0;
  /// The numbers for tissue of a map of extremes, by the shear modulus; those of other maps follow from the
  /// stretches.
  struct Extremes {
    double vonMisesPerShear = 0;
    double energyPerShear = 0;
    double poisson = 0;
  };
  std::optional<Extremes> extremes = std::nullopt;
};

/// The quantity of a reading, in its unit; not a number where there is no tissue, nor where it is folded,
/// except for the folded quantity itself, nor of a material that is not stated. Pascals come of the
/// interpolated stretches, or of the interpolated extremes of a maximum over a cycle.
double valueOf(const StressReading& reading, const StressMeasure& measure);

/// Material points of an organ: each is tied to the tetrahedron of the witness mesh that holds it at rest,
/// and reads the map linearly between its corners; a point of the mesh reads exactly its own numbers.
/// Immutable, thread-safe.
class TissuePoints {
public:
  /// `rest` is `n x 3` mm. A point that lies `reachMm` outside the mesh at most reads its nearest place; one
  /// farther away is in no tissue. O((mesh + n) log n).
  TissuePoints(std::shared_ptr<const deformation::WitnessMesh> mesh, const Points& rest, double reachMm,
               Threads threads = {});

  const std::shared_ptr<const deformation::WitnessMesh>& mesh() const { return mesh_; }
  /// Distance of one point from the tissue, mm; 0 inside.
  double distance(Eigen::Index point) const { return places_.distance(point); }

  /// Reads a map and the mesh's points in its pose (`mesh rows x 3` mm). O(n).
  std::vector<StressReading> read(const Points& posed, const deformation::StressMap& map) const;

private:
  std::shared_ptr<const deformation::WitnessMesh> mesh_;
  Points rest_;
  double reach_;
  deformation::WitnessInterpolation places_;
};

/// How far outside a mesh a probe may lie, mm: the surface of another mesh of the same organ (with other
/// witness points, of a repaired copy) is another one by a little. A fiftieth of the mesh's diagonal.
double probeReach(const deformation::WitnessMesh& mesh);

/// Stress along a straight line at rest.
struct StressProfile {
  std::vector<double> mm; ///< From the line's beginning, at rest.
  std::vector<StressReading> readings;
};

inline constexpr int kProfilePoints = 101;
inline constexpr int kMostProfilePoints = 10001;

/// `count` places (at least 2), evenly from one to the other, both included, `count x 3`.
Points placesAlong(const Vec3& from, const Vec3& to, int count);

/// The readings of `placesAlong` with their distances.
StressProfile profileOf(std::vector<StressReading> readings);

} // namespace viscera::live
