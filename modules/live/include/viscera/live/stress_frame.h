#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "viscera/coordinates/binding.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/rotational_stress.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/deformation/witness_interpolation.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/document/ids.h"
#include "viscera/live/stress_quantity.h"

/// The stress map of one organ at one instant, and its curves and maximum over a cycle.
namespace viscera::live {

/// Summary statistics of a stress map at one instant.
struct StressSample {
  double seconds = 0;
  deformation::StressStatistics statistics;
};

/// One cycle of a sequence as the poses that it gives the handles.
struct PosedCycle {
  double periodSeconds = 0;
  /// The pose at a fraction of the cycle, [0, 1): `n x 3` mm, valid until the next call. For one thread.
  std::function<const Points&(double fraction)> poseAt;
  /// Poisson's ratio of the material whose largest energy is found with the maximum.
  double poisson = elasticity::kUsualPoisson;
};

/// The stress over one cycle of a sequence.
struct CycleStress {
  double periodSeconds = 0;
  std::vector<StressSample> samples; ///< Of the witness points, evenly over the cycle, its end left out.
  /// The largest rotational stress at every point of the mesh, the largest and the smallest stretch, and the
  /// volume ratio that is farthest from 1 (by its factor; one at most 0 before all others), each by itself;
  /// the largest stress and energy of a tissue are its `extremes`.
  /// None unless it was asked for.
  std::optional<deformation::StressMap> peak;
  std::vector<Points> poses; ///< Of the handles at the samples, `n x 3` mm.

  /// The samples with the cycle's end, which is its beginning: what a curve is drawn from.
  std::vector<StressSample> closed() const;
  /// The instant with the largest rotational stress; null without samples.
  const StressSample* worst() const;
};

/// Instants of a cycle at which `LiveStress` evaluates the stress.
inline constexpr int kCycleInstants = 64;

/// What `stressOverCycle` computes: the maximum (`CycleStress::peak`) needs all points of the mesh, the curve
/// only its witnesses.
enum class CycleParts { curve, curveAndPeak };

/// Goes through one cycle in `instants` steps, at least 1. Samples are of the first `witnesses` points.
/// Throws `Cancelled`, `DataError` for poses of another number of handles. Deterministic; for any thread.
/// O(instants x points x handles).
CycleStress stressOverCycle(const deformation::WitnessGradients& gradients, Eigen::Index witnesses,
                            const PosedCycle& cycle, int instants, CycleParts parts, Threads threads,
                            Progress& progress);

/// The quantity at one point of the mesh at each sample of a cycle, in its unit; not a number where it is
/// folded. `gradients` are those that the cycle was computed with. O(samples x handles).
std::vector<double> curveAt(const deformation::WitnessGradients& gradients, Eigen::Index point,
                            const CycleStress& cycle, const StressMeasure& measure);

/// The stress map of one organ at one instant, as it is drawn: made by `LiveStress` for the document that is
/// open, or evaluated by a movie. The pointers share ownership of their memory; points and map are updated in
/// place when the pose changes, and `revision` changes with them.
struct StressFrame {
  document::OrganId organ; ///< None: there is no map to draw.
  std::shared_ptr<const deformation::WitnessMesh>
      mesh; ///< The witnesses at rest; null before they are sampled.
  /// Carries from the mesh's points to the organ's vertices; null as long as `mesh` is.
  std::shared_ptr<const deformation::WitnessInterpolation> onSurface;
  std::shared_ptr<const Points> points;              ///< Of the mesh in the pose, `n x 3` mm; null unbound.
  std::shared_ptr<const deformation::StressMap> map; ///< At those points; null unbound.
  std::shared_ptr<const CycleStress> cycle;          ///< Null when it was not computed.
  /// The axes of the ellipsoid that a small ball at a point of the mesh becomes; empty unbound.
  std::function<deformation::PrincipalStretches(Eigen::Index point)> stretchesAt;
  std::uint64_t revision = 0;
};

/// What the quantity of map `a` exceeds that of map `b` by at every point of their mesh, in its unit; not a
/// number where one of them is folded. None unless both are of the same points. O(n).
std::optional<Values> differenceOf(const StressFrame& a, const StressFrame& b, const StressMeasure& measure);

/// A copy of an organ's stress computation with poses of its own, for recording a movie on another thread.
/// For one thread.
class StressCopy {
public:
  /// An empty copy, whose frames have no organ.
  StressCopy() = default;
  /// `start` with the derivatives and the coordinates at its points, `failures` being those that do not move.
  StressCopy(StressFrame start, std::shared_ptr<const deformation::WitnessGradients> gradients,
             std::shared_ptr<const coordinates::Binding> positions);

  /// The frame of a pose (`n x 3` mm of the handles it was bound to). O(points x handles).
  const StressFrame& at(const Points& pose);

private:
  StressFrame frame_;
  std::shared_ptr<const deformation::WitnessGradients> gradients_;
  std::shared_ptr<const coordinates::Binding> positions_;
  std::shared_ptr<Points> points_ = std::make_shared<Points>();
  std::shared_ptr<deformation::StressMap> map_ = std::make_shared<deformation::StressMap>();
};

} // namespace viscera::live
