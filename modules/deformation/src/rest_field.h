#pragma once

#include <array>
#include <memory>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/geometry/convex_hull.h"

/// The displacement field of the space at rest, on which `InverseMap` works.
namespace viscera::deformation {

/// Distance from the hull's facets, as a fraction of its diagonal, within which a point does not count as
/// inside.
inline constexpr double kWithinHull = 1e-6;

/// Points in rows and layers, x first, and a vector at each.
struct VectorGrid {
  Vec3 origin = Vec3::Zero();
  double spacing = 1;
  Eigen::Vector3i size = Eigen::Vector3i::Zero();
  Points vectors;

  Eigen::Index count() const { return size.cast<Eigen::Index>().prod(); }
  Vec3 position(Eigen::Index node) const;
  bool contains(const Vec3& point) const;
  /// Trilinear; column j of `gradient`, where it is wanted, is the derivative along axis j. A point outside
  /// gets the value of the nearest one on the border.
  Vec3 at(const Vec3& point, Eigen::Matrix3d* gradient) const;
  /// The eight nodes around a point and their weights.
  struct Corners {
    std::array<std::int32_t, 8> nodes = {};
    std::array<float, 8> weights = {};
  };
  Corners cornersAt(const Vec3& point) const;
  Vec3 sum(const Corners& corners) const;
};

/// The displacement of the rest space: bound at the nodes of a grid over the handles' hull, and faded to zero
/// outside of the hull (see `InverseMap`). It is trilinear on that grid, and on a coarser one around it,
/// without a jump between the two.
class RestField {
public:
  /// Binds the nodes. Throws what binding throws, `Cancelled`.
  RestField(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
            const coordinates::BindOptions& options, double spacing, Progress& progress);

  /// Poses the nodes. O(nodes x handles).
  void setPose(const Points& pose);
  const Points& pose() const { return pose_; }
  const coordinates::HandleSet& handles() const { return handles_; }
  const coordinates::BindOptions& options() const { return options_; }

  struct Motion {
    Vec3 displacement = Vec3::Zero();
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero(); ///< Column j: its derivative along axis j.
  };
  Vec3 displacementAt(const Vec3& rest) const;
  Motion motionAt(const Vec3& rest) const;
  /// Whether a point is its own place at rest.
  bool isStill(const Vec3& posed) const { return displacementAt(posed).isZero(0); }
  /// Whether a rest point has coordinates.
  bool isInside(const Vec3& rest) const { return hull_.signedDistance(rest) <= 0; }
  /// Whether the tissue at a posed point is folded.
  bool isFolded(const Vec3& posed) const;

  /// An estimate of the grid's error around a rest point, mm, by the second differences of the motion; zero
  /// where no exact motion is known (`exactPart`).
  double roughnessAt(const Vec3& rest) const;
  /// 1 in the hull, where the system itself gives the motion of a rest point; falls to 0 a few cells outside.
  double exactPart(const Vec3& rest) const;
  /// The point itself in the hull, else where the line to the hull's middle enters it.
  Vec3 pulledIn(const Vec3& point) const;

  /// The volume of folded tissue, at rest, mm3.
  double foldedMm3() const;
  double errorMm() const { return error_; }
  double spacing() const { return inner_.spacing; }
  Eigen::Index boundPoints() const { return bound_.rows(); }
  Bounds movedBox() const;

private:
  /// A node in the hull or next to it. Its displacement is that of the bound point `first`, or beyond the
  /// hull 2 * first - second, which goes on straight: cells on the border are as exact as those inside.
  struct BoundNode {
    std::int32_t node = 0, first = 0, second = -1;
    bool outside = false; ///< Of the hull.
  };
  /// A node farther out: the motion where the line to the middle enters the hull, faded by the distance.
  struct ExtrapolatedNode {
    std::int32_t node = 0;
    float distance = 0;
    VectorGrid::Corners entry;
  };
  /// A node without coordinates, in the hull of a system that has none everywhere, gets its neighbours' mean.
  struct NeighbourMeanNode {
    Eigen::Index node = 0;
    std::vector<Eigen::Index> neighbours;
  };

  void placeInner(double spacing);
  void placeOuter(double reach);
  void chooseNodes(std::vector<Vec3>& points);
  void chooseChecks(std::vector<Vec3>& points) const;
  void bindAll(const coordinates::CoordinateSystem& system, const std::vector<Vec3>& points,
               Progress& progress);
  void planMending();
  void markWholeCells();
  Points boundDisplacements() const;
  double setBoundNodes(const Points& moved);
  void extrapolateNodes(VectorGrid& grid, const std::vector<ExtrapolatedNode>& nodes) const;
  void joinGrids();
  ExtrapolatedNode extrapolatedNode(Eigen::Index node, const Vec3& position) const;
  void measureError(const Points& moved);
  void measureRoughness();
  void spreadRoughness(const std::array<Eigen::Index, 3>& strides);
  std::vector<Eigen::Index> findFoldedCells() const;
  void markFolds();

  coordinates::HandleSet handles_;
  coordinates::BindOptions options_;
  geometry::ConvexHull hull_;
  Vec3 middle_ = Vec3::Zero();
  VectorGrid inner_, outer_;
  std::vector<BoundNode> boundNodes_;
  std::vector<ExtrapolatedNode> innerFaded_, outerFaded_;
  std::vector<std::uint8_t> wholeCells_; ///< Of the inner grid: whether a cell has bound corners only.
  std::vector<NeighbourMeanNode> neighbourMeans_;               ///< In their order.
  std::vector<std::unique_ptr<coordinates::Binding>> bindings_; ///< Of consecutive pieces of `bound_`.
  Points bound_;                     ///< Points at rest: for nodes, then cells' centres to check.
  std::vector<std::uint8_t> failed_; ///< Of them.
  Eigen::Index firstCheck_ = 0;
  Points pose_;
  double reach_ = 0;      ///< How far outside of the hull anything moves, mm.
  double reachBuilt_ = 0; ///< How far the outer grid goes.
  double error_ = 0;
  std::vector<float> roughness_; ///< Of the inner grid's nodes.
  std::size_t foldedCount_ = 0;  ///< Of the inner grid.
  VectorGrid folds_;             ///< The places of folded tissue in the pose; its vectors are not used.
  std::vector<std::uint8_t> foldCells_;
};

} // namespace viscera::deformation
