#pragma once

#include <memory>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::deformation {

/// The displacement of the rest space: bound at the nodes of a grid over the handles' hull, trilinear between
/// them, and faded to nothing outside of the hull. `InverseMap` says how.
class RestField {
public:
  /// Binds the nodes. Throws what binding throws, `Cancelled`.
  RestField(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
            const coordinates::BindOptions& options, double spacing, Progress& progress);

  /// Poses the nodes. O(nodes x handles).
  void setPose(const Points& pose);
  const Points& pose() const { return pose_; }

  struct Motion {
    Vec3 displacement = Vec3::Zero();
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero(); ///< Column j: its derivative along axis j.
  };
  Vec3 displacementAt(const Vec3& rest) const;
  Motion motionAt(const Vec3& rest) const;
  /// Whether a posed point is as far from the hull as nothing moves to.
  bool isStill(const Vec3& posed) const;
  /// Whether a rest point has coordinates.
  bool isInside(const Vec3& rest) const { return outsideBy(rest) <= 0; }

  /// Whether a posed point lies where the pose brings tissue that it turns inside out.
  bool isFolded(const Vec3& posed) const;

  double errorMm() const { return error_; }
  double spacing() const { return spacing_; }
  Eigen::Index boundPoints() const { return boundPoints_; }
  Bounds movedBox() const;

private:
  /// How a node's displacement follows from those of bound points: that of `first`, or beyond the hull
  /// 2 * first - second, which goes on straight.
  struct Node {
    std::int32_t first = -1, second = -1;
    bool outside = false; ///< Of the hull.
  };

  /// A node without coordinates, in the hull of a system that has none everywhere, gets its neighbours' mean.
  struct Mending {
    Eigen::Index node = 0;
    std::vector<Eigen::Index> neighbours;
  };

  void placeGrid(double spacing);
  void chooseNodes(std::vector<Vec3>& points);
  void chooseChecks(std::vector<Vec3>& points) const;
  void bindAll(const coordinates::CoordinateSystem& system, Progress& progress);
  void planMending();
  Vec3 nodePosition(Eigen::Index node) const;
  double outsideBy(const Vec3& point) const;
  void markInnerCells();
  Vec3 pulledIn(const Vec3& point) const;
  Vec3 trilinear(const Vec3& rest, Eigen::Matrix3d* gradient) const;
  double fade(double outside) const;
  void measureError(const Points& moved);
  void markFolds();
  std::vector<Eigen::Index> foldedCells() const;

  coordinates::HandleSet handles_;
  coordinates::BindOptions options_;
  geometry::ConvexHull hull_;
  Vec3 middle_ = Vec3::Zero();
  double spacing_ = 1;
  Vec3 origin_ = Vec3::Zero();
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
  std::vector<Node> nodes_;
  std::vector<std::uint8_t> inner_; ///< Whether the cell behind each node is in the hull as a whole.
  std::vector<Mending> mendings_;   ///< In their order.
  std::vector<std::unique_ptr<coordinates::Binding>> bindings_; ///< Of consecutive pieces of them.
  Points bound_;                                                ///< All of them, at rest.
  std::vector<std::uint8_t> failed_;                            ///< Of them.
  Eigen::Index boundPoints_ = 0, firstCheck_ = 0; ///< Checks are cells' centres in the hull, behind all else.
  Points pose_;
  Points displacements_; ///< One a node.
  double reach_ = 0;     ///< How far outside the hull anything moves, mm.
  double largest_ = 0;   ///< Displacement, mm.
  double error_ = 0;
  /// Cells of the posed space, as large as the grid's, that folded tissue comes to; empty for none.
  std::vector<std::uint8_t> folds_;
  Vec3 foldsOrigin_ = Vec3::Zero();
  Eigen::Vector3i foldsSize_ = Eigen::Vector3i::Zero();
};

} // namespace viscera::deformation
