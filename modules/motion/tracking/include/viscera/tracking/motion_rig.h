#pragma once

#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::tracking {

/// The options for placing the handles of a tracked motion.
struct RigOptions {
  int handles = 0;       ///< All, the eight corners of the box included; 0: 60 for one surface, else 120.
  double offsetMm = 0;   ///< Of a handle from its wall; 0: 2.5 % of the outer surface's diagonal.
  double locality = 3;   ///< Of the S-celestial coordinates.
  double softness = 1.5; ///< Of the S-celestial coordinates, in median distances to the nearest handle.
};

/// The handles of a tracked motion and the surface that each belongs to.
struct RigHandles {
  Points rest;                ///< `n x 3` mm: the corners of the box first, then surface by surface.
  std::vector<int> ofSurface; ///< One for each handle: its surface, or -1 for a corner of the box.
};

/// Places handles around `surfaces`, of which `outer` holds the others (cavities): the corners of a box grown
/// by 15 % of its diagonal, then farthest-point samples of every surface, a share of 0.4 on the outer one and
/// the rest split evenly over the cavities, off the wall by the offset: outward from the outer surface, into
/// the blood from a cavity's wall. Handles outside alone cannot move a cavity's wall by 10 mm and the outside
/// by 2 mm. Deterministic. Throws `DataError` for fewer handles than eight and four a surface, for surfaces
/// that have no room for them. O(n handles).
RigHandles placeMotionHandles(const std::vector<geometry::TriangleMesh>& surfaces, std::size_t outer,
                              const RigOptions& options);

/// The softness for handles, mm: `spacings` times the median distance from a handle to its nearest one, the
/// first `corners` left out.
double softnessFor(const Points& handles, Eigen::Index corners, double spacings);

/// Surfaces at rest bound to one set of handles by S-celestial coordinates, as one matrix for the fits.
/// Immutable; may be called from several threads.
class MotionRig {
public:
  /// Binds all `surfaces` to `handles` (`n x 3`). Throws `deformation::UnboundVertices` for vertices outside
  /// their hull, what binding throws, `Cancelled`.
  MotionRig(std::vector<geometry::TriangleMesh> surfaces, Points handles, double locality, double softnessMm,
            Progress& progress, Threads threads = {});

  const Points& rest() const { return rest_; } ///< Handles, `n x 3`.
  Eigen::Index handles() const { return rest_.rows(); }
  const std::vector<geometry::TriangleMesh>& surfaces() const { return surfaces_; } ///< At rest.
  double locality() const { return locality_; }
  double softnessMm() const { return softnessMm_; }

  /// The weights of all surfaces below each other, `m x n`.
  const Eigen::MatrixXd& weights() const { return weights_; }
  /// The rows of one surface in it.
  Eigen::Index firstRow(std::size_t surface) const { return first_[surface]; }
  Eigen::Index rows(std::size_t surface) const { return surfaces_[surface].points.rows(); }
  /// The weight of each vertex in a fit, `m` numbers: its area, normalised so that all surfaces have the same
  /// sum and the total is 1.
  const Values& shares() const { return shares_; }
  /// Projects out affine motion, `n x n`: `|R (h - H)|^2` is the part of a pose's displacement that is not
  /// affine.
  const Eigen::MatrixXd& bending() const { return bending_; }

  /// The vertices of all surfaces at a pose, `m x 3`.
  Points vertices(const Points& pose) const { return weights_ * pose; }
  /// The vertices of one of them.
  Points vertices(const Points& pose, std::size_t surface) const;
  /// The volume of every surface, ml, given the vertices of all.
  Values volumesMl(const Points& vertices) const;

private:
  std::vector<geometry::TriangleMesh> surfaces_;
  Points rest_;
  double locality_;
  double softnessMm_;
  std::vector<Eigen::Index> first_;
  Eigen::MatrixXd weights_;
  Values shares_;
  Eigen::MatrixXd bending_;
};

} // namespace viscera::tracking
