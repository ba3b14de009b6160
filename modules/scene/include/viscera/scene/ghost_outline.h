#pragma once

#include <memory>

#include "viscera/geometry/normals.h"
#include "viscera/geometry/triangle_mesh.h"

class vtkRenderer;

namespace viscera::scene {

/// Draws the outline of a surface as a thin translucent line that follows the camera: for the rest shape
/// behind a pose, or to mark the selected organ. Belongs to the thread that renders.
///
/// The line is where the interpolated normal is perpendicular to the line of sight (Hertzmann and Zorin,
/// "Illustrating Smooth Surfaces", 2000, DOI 10.1145/344779.345074), so it is smooth where the triangles are
/// coarse.
class GhostOutline {
public:
  explicit GhostOutline(std::shared_ptr<const geometry::TriangleMesh> mesh);
  ~GhostOutline();
  GhostOutline(const GhostOutline&) = delete;
  GhostOutline& operator=(const GhostOutline&) = delete;

  /// Outlines the surface with its vertices at these places (`n x 3` mm) and with these normals, in place of
  /// the mesh's own. Throws `UsageError` when they are not as many as the mesh has. O(n).
  void setPoints(const Points& points, const geometry::Normals& normals);
  /// Sets the renderer to draw in, whose camera it follows; null: none.
  void setRenderer(vtkRenderer* renderer);
  void setColor(const Vec3& color);
  void setOpacity(double opacity);
  /// Whether the part behind organs is drawn faintly, as at first; false: opaque organs hide the outline.
  void setSeenThrough(bool through);
  /// Clips the outline on the negative side of a plane (`normal` need not be unit), as `OrganActor` does.
  void setClipPlane(const Vec3& origin, const Vec3& normal);
  void clearClipPlane();
  void setVisible(bool visible);
  bool visible() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
