#pragma once

#include <span>
#include <vector>

#include "viscera/geometry/median_tree.h"

#include "implicit/implicit_node.h"

namespace viscera::sample_organs {

/// A point of a tube's axis as a definition gives it.
struct AxisPoint {
  Vec3 position;     ///< mm
  double radius = 0; ///< mm
};

/// A point of the sampled axis, with a frame that turns as little as possible along it.
struct AxisSample {
  Vec3 position = Vec3::Zero();
  Vec3 tangent = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
  Vec3 binormal = Vec3::Zero();
  double radius = 0; ///< mm
  double arc = 0;    ///< Length of the axis up to here, mm.
};

/// Samples a smooth axis through `points` (at least two, neighbours apart) about every `step` mm: a
/// centripetal Catmull-Rom spline (Yuksel et al. 2011, 10.1016/j.cad.2010.08.008), which neither loops nor
/// overshoots between uneven points; the radius is interpolated without overshoot. The first normal lies as
/// near `firstNormal` as it can.
std::vector<AxisSample> sampleAxis(const std::vector<AxisPoint>& points, double step,
                                   const Vec3& firstNormal);

/// The place on a sampled axis at which the tube's surface is nearest.
struct NearestOnAxis {
  int segment = -1;    ///< Between samples `segment` and `segment + 1`; -1 for none.
  double t = 0;        ///< 0 at its start, 1 at its end.
  double distance = 0; ///< From the surface of the round cone, mm, negative inside.
};

/// A bounding-volume tree over the round cones between the samples of an axis. Immutable; thread-safe.
class SegmentTree {
public:
  /// Takes two samples or more.
  explicit SegmentTree(const std::vector<AxisSample>& samples);

  /// The round cone whose surface is nearest (deepest, when inside): O(log n) for points near the tube.
  /// None when all are at least `limit` mm away.
  NearestOnAxis nearest(const Vec3& point, double limit) const;

private:
  /// The hull of two balls, with what its distance needs.
  struct RoundCone {
    int segment;
    Vec3 start;
    Vec3 direction; ///< Unit.
    double length;
    double radius; ///< At the start.
    double rise;   ///< Change of the radius from start to end.
    double shift;  ///< Foot of the nearest point moves along the axis by this much per mm away from the axis.
  };
  struct Reach {
    Extent box;        ///< Of the axis.
    double radius = 0; ///< Largest within.
  };

  static Reach reachOf(const std::vector<RoundCone>& cones, std::span<const int> items);
  /// Whether nothing in the branch can be nearer than `distance` mm to the point.
  static bool isFarther(const Reach& branch, double axisDistance2, double distance) {
    const double reach = distance + branch.radius;
    return reach <= 0 || axisDistance2 >= reach * reach;
  }
  void searchLeaf(int begin, int end, const Vec3& point, NearestOnAxis& best) const;

  std::vector<RoundCone> cones_; ///< In the order of the leaves.
  geometry::MedianTree<Reach> reaches_;
};

} // namespace viscera::sample_organs
