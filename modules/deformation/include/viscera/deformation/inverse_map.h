#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/core/progress.h"

namespace viscera::deformation {

/// Whether the place at rest of a point of the posed space is known.
enum class RestState : std::uint8_t {
  still,  ///< No handle has an effect there: the place at rest is the point itself.
  moved,  ///< The place is known.
  folded, ///< The tissue at this point is folded: the place is one of several, or a guess.
};

/// The rest positions of some points of the posed space, and the state of each.
struct RestPoints {
  Points points;                 ///< `n x 3`, mm.
  std::vector<RestState> states; ///< One for each point.
};

/// A grid of points on a plane: sample (c, r) is at `corner + c * columnStep + r * rowStep`.
struct SamplePlane {
  Vec3 corner = Vec3::Zero();      ///< mm.
  Vec3 columnStep = Vec3::UnitX(); ///< mm.
  Vec3 rowStep = Vec3::UnitY();    ///< mm.
  Eigen::Index columns = 0, rows = 0;

  Vec3 at(Eigen::Index column, Eigen::Index row) const {
    return corner + static_cast<double>(column) * columnStep + static_cast<double>(row) * rowStep;
  }
};

/// How far rest positions are refined beyond the accuracy of the grid.
struct Refinement {
  double toleranceMm = 0.02; ///< Largest distance of F(x) from the sample.
  /// The largest number of samples to refine, the roughest first. One costs about two bindings of a point.
  Eigen::Index mostPoints = std::numeric_limits<Eigen::Index>::max();
};

/// The accuracy of an inverse map and the limit of its memory.
struct InverseMapOptions {
  double accuracyMm = 0.1;  ///< Largest error of the motion between bound points; spacings are halved until
                            ///< it is met.
  double mostWeights = 3e6; ///< Bound points times handles are no more: eight bytes of memory each. What lies
                            ///< around them takes at most 50 MB, however far a handle is dragged.
};

/// The inverse of a deformation: finds where tissue was at rest, so that images can be deformed with the
/// handles.
///
/// A pose moves a rest point x to F(x) = x + u(x). Within the handles' hull u follows from the handles'
/// motion by the system's coordinates. Outside it is the motion where the line to the hull's middle enters
/// the hull, times a smooth step that falls to zero at a distance that grows with the motion there (at least
/// three times as far as the hull's border moves), so that u is continuous and far places do not move.
///
/// u is bound once at the nodes of a regular grid, on which it is trilinear; a new pose takes one sum a node.
/// F(x) = y is solved by Newton's method with the grid's own gradients, from the answer of a neighbour.
/// The grid is so fine that u is off by no more than `accuracyMm` between nodes for the first pose, if
/// `mostWeights` allows it, at 99 of 100 places: next to a handle motions have a kink at any spacing.
/// `errorMm` measures it for each pose.
///
/// Immutable but for `setPose`; results do not depend on the number of threads.
class InverseMap {
public:
  /// Binds the grid for `handles`, fine enough for `pose`, and takes that pose. Throws what binding throws,
  /// `Cancelled`. As long as binding some ten or hundred thousand points.
  InverseMap(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
             const Points& pose, const coordinates::BindOptions& options, const InverseMapOptions& map,
             Progress& progress);
  ~InverseMap();
  InverseMap(const InverseMap&) = delete;
  InverseMap& operator=(const InverseMap&) = delete;

  /// Takes another pose of the same handles (`n x 3`, mm). Throws `DataError` for a pose of another size or
  /// that is not finite. O(nodes x handles), a few milliseconds; not while another thread uses the map.
  void setPose(const Points& pose);

  /// F of rest points, `n x 3` mm.
  Points posedPoints(const Points& rest) const;
  /// Where posed points, `n x 3` mm, were at rest. About a microsecond a point on one core.
  RestPoints restPoints(const Points& posed) const;
  /// The same for all samples of a plane, into `result`, row by row, whose memory is used again: solved at
  /// some and between them linear wherever that is exact to a quarter of `accuracyMm`.
  void restPlane(const SamplePlane& plane, RestPoints& result) const;

  /// Refines the result of `restPlane` where the error of the grid may be more than half of the tolerance (by
  /// the second differences of u between its nodes): uses the system itself, by Broyden's iteration from the
  /// grid's gradient. The grid's error at the border of the hull fades within two cells outside of it. Folded
  /// samples stay as they are. `system` is the one of the constructor. Throws what binding throws,
  /// `Cancelled`.
  void refinePlane(const coordinates::CoordinateSystem& system, const SamplePlane& plane,
                   const Refinement& refinement, RestPoints& result, Progress& progress) const;

  /// The error of u between the nodes, compared with the system itself, mm: the 99th percentile of two
  /// thousand places in the hull.
  double errorMm() const;
  /// The error of `rest`, the results for `posed`, compared with the system itself, mm: the largest |F(rest)
  /// - posed| among those that lie in the hull and are not folded. As long as binding them.
  double residualMm(const coordinates::CoordinateSystem& system, const Points& posed, const RestPoints& rest,
                    Progress& progress) const;
  /// Whether binding anew for this pose would be more exact: it is farther from rest than the first one was.
  bool wantsFinerGrid() const;
  double spacingMm() const; ///< Of the grid.
  /// The volume of folded tissue, at rest, ml; in whole cells of the grid.
  double foldedMl() const;
  Eigen::Index boundPoints() const; ///< The number of points that the constructor has bound in its last step.
  Bounds movedBox() const;          ///< The box, mm, outside of which nothing moves.

private:
  class Field;
  double room() const; ///< Times as many points may be bound.

  std::unique_ptr<Field> field_;
  coordinates::HandleSet handles_;
  coordinates::BindOptions options_;
  InverseMapOptions wanted_;
};

} // namespace viscera::deformation
