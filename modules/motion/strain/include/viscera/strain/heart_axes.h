#pragma once

#include <optional>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/geometry/triangle_mesh.h"

/// Strain of the heart's wall (docs/strain.md). Positions are mm, LPS or any other right-handed axes.
namespace viscera::strain {

/// The axes of a left ventricle: the long axis from the mitral annulus to the apex, and the anterior
/// insertion of the right ventricle, from which segments count. Immutable; thread-safe.
class HeartAxes {
public:
  /// `base` is the middle of the mitral annulus, `apex` the tip of the cavity, `towardsInsertion` any
  /// direction from the axis towards the anterior insertion: its part along the axis is removed. Throws
  /// `DataError` for points that coincide or a direction along the axis.
  HeartAxes(const Vec3& base, const Vec3& apex, const Vec3& towardsInsertion);

  const Vec3& base() const { return base_; }
  const Vec3& apex() const { return apex_; }
  double length() const { return length_; }               ///< From base to apex, mm.
  const Vec3& down() const { return down_; }              ///< Unit, from base to apex.
  const Vec3& towardsInsertion() const { return first_; } ///< Unit, across the axis.
  /// The unit vector across the axis at `angle` rad behind the insertion, towards the septum.
  Vec3 across(double angle) const;

  /// The place along the axis: 0 at the annulus, 1 at the tip of the cavity.
  double heightOf(const Vec3& point) const { return (point - base_).dot(down_) / length_; }
  /// The angle around the axis, rad, 0 to 2 pi: 0 at the anterior insertion, growing through the septum to
  /// the inferior wall and on through the lateral one.
  double angleOf(const Vec3& point) const;
  /// The distance from the axis, mm.
  double distanceOf(const Vec3& point) const;

private:
  Vec3 base_, apex_;
  double length_ = 0;
  Vec3 down_, first_, second_;
};

/// Points that a user has clicked; those that are missing are found.
struct AxisLandmarks {
  std::optional<Vec3> base;      ///< Middle of the mitral annulus.
  std::optional<Vec3> apex;      ///< Tip of the left ventricle's cavity.
  std::optional<Vec3> insertion; ///< Where the right ventricle meets the left one in front.

  bool operator==(const AxisLandmarks&) const = default;
};

/// Axes that were found, with what they were found from.
struct FoundAxes {
  HeartAxes axes;
  std::vector<bool> cap; ///< For each triangle of the left ventricle's cavity, whether it closes a valve.
  /// Whether the place of the right ventricle is known: from its surface or from a click. Without it the
  /// numbers of segments mean nothing.
  bool oriented = false;
  double septumDegrees =
      0; ///< Between both insertions, where the right ventricle's surface is given; else 0.
};

/// Finds the axes of the closed surface of a left ventricle's cavity (outward triangles), at the end of
/// diastole. The base is the middle of its largest valve cap (`valveCaps`), the apex the vertex farthest from
/// the base; the insertions are the ends of the right ventricle's cavity as seen from the axis, in its middle
/// third. `rightCavity` may be null. Throws `DataError` for a surface of less than four triangles or without
/// volume. O(n + m).
FoundAxes findAxes(const geometry::TriangleMesh& leftCavity, const geometry::TriangleMesh* rightCavity,
                   const AxisLandmarks& given = {});

} // namespace viscera::strain
