#pragma once

#include <vector>

#include "viscera/geometry/normals.h"
#include "viscera/geometry/triangle_mesh.h"

#include "view_geometry.h"

namespace viscera::scene {

/// Fills `segments` with the contour of a surface as it is seen: six numbers a segment, two points in mm. It
/// is the line in which the interpolated normal is perpendicular to the line of sight, so each triangle holds
/// at most one segment. O(n + m).
void silhouette(const geometry::TriangleMesh& mesh, const geometry::Normals& normals,
                const ViewGeometry& view, std::vector<float>& segments);

/// A coarse depth picture of one surface, to tell which of its own contours it hides.
class DepthGrid {
public:
  /// `cells` along the longer side of the surface's rectangle on the display. O(n + m + covered cells).
  DepthGrid(const geometry::TriangleMesh& mesh, const ViewGeometry& view, int cells);

  /// Whether a point is visible, in its cell or in a cell beside it, because the edge of a surface belongs to
  /// both its sides. `tolerance` in mm.
  bool sees(const Vec3& point, double tolerance) const;

private:
  double& at(Eigen::Index column, Eigen::Index row) { return depths_[std::size_t(row * columns_ + column)]; }
  void draw(const DisplayPoint& a, const DisplayPoint& b, const DisplayPoint& c);

  ViewGeometry view_;
  double left_ = 0, bottom_ = 0; ///< Device pixels of the grid's lower left corner.
  double cell_ = 1;              ///< Device pixels a cell.
  Eigen::Index columns_ = 1, rows_ = 1;
  std::vector<double> depths_; ///< mm in front of the eye; infinite where there is nothing.
};

} // namespace viscera::scene
