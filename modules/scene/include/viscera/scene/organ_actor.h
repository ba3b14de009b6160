#pragma once

#include <memory>

#include <vtkSmartPointer.h>

#include "viscera/core/parallel.h"
#include "viscera/geometry/normals.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/scene/color_map.h"

class vtkActor;
class vtkPlane;
class vtkPolyData;

namespace viscera::scene {

/// The style in which a surface's triangles are drawn: smooth or flat, with or without edges.
struct MeshLook {
  bool edges = false; ///< Their edges are drawn as thin lines over it.
  bool flat = false;  ///< Each has one shade, in place of a smooth surface.

  bool operator==(const MeshLook&) const = default;
};

/// What a surface is in a view for, where another one is drawn in its place.
enum class SurfaceRole {
  whole,   ///< Drawn, picked and named.
  picture, ///< Only drawn: rays go through it, it has no name and hides no label.
  body,    ///< Picked and named where it is, but not drawn.
  hollow,  ///< A body that is empty: where a cut opens it, one looks at its far wall from inside.
  filling, ///< A picture of what fills hollows: their names lie on it.
};

/// Draws the surface of one organ. VTK looks at the mesh's own memory: points, triangles, vertex colours,
/// normals and scalars are never copied on the processor's side. Belongs to the thread that renders.
///
/// An organ that is posed by a `deformation::Deformer` shows the deformer's points; the aliasing constructor
/// of `shared_ptr` keeps the deformer alive as long as they are drawn:
///
///     actor.setPoints(std::shared_ptr<const Points>(deformer, &deformer->points()));
///     deformer->setPose(pose);
///     actor.pointsChanged();
class OrganActor {
public:
  /// Draws `mesh`, with its vertex colours when it has some. O(n + m) once.
  explicit OrganActor(std::shared_ptr<const geometry::TriangleMesh> mesh, Threads threads = {});
  ~OrganActor();
  OrganActor(const OrganActor&) = delete;
  OrganActor& operator=(const OrganActor&) = delete;

  const geometry::TriangleMesh& mesh() const;

  /// Draws these points (`n x 3`, mm; as many as the mesh has) in place of the mesh's own, without a copy;
  /// null goes back to the mesh's own. Implies `pointsChanged`.
  void setPoints(std::shared_ptr<const Points> points);
  const Points& points() const;

  /// Computes the normals of the points as they are now, of the triangles that are drawn, and tells VTK that
  /// both have changed. Call after every change of the points, before the next render. Follows an array that
  /// has moved in memory. O(n + m), on several threads.
  void pointsChanged();

  /// The normals of the whole surface, `n x 3`, for the points as they were at the last `pointsChanged`:
  /// those that are drawn, unless the surface is coarse. While it is coarse, the first call after
  /// `pointsChanged` takes O(n + m).
  const geometry::Normals& normals() const;
  /// The box of the points that are drawn. O(n).
  Bounds bounds() const;

  /// One colour, red green blue, 0 to 1: used where neither vertex colours nor scalars are shown.
  void setColor(const Vec3& color);
  Vec3 color() const;
  /// Shows or hides the mesh's own vertex colours. Nothing happens when it has none.
  void setVertexColorsShown(bool shown);

  /// 0 to 1; below 1 the surface is drawn translucent and does not hide handles.
  void setOpacity(double opacity);
  double opacity() const;
  void setVisible(bool visible);
  bool visible() const;
  /// `whole` at first. A surface that is shown in place of others has the role of their picture, and they
  /// that of a body or, where they are cavities, of a hollow, so that clicks and names are as before.
  void setRole(SurfaceRole role);
  SurfaceRole role() const;
  /// Whether it is visible and drawn; whether it is visible, and picked and named.
  bool drawn() const;
  bool met() const;
  /// Selected organs are drawn a little lighter.
  void setSelected(bool selected);
  bool selected() const;

  /// Cuts away what lies on the negative side of a plane (`normal` need not be unit). Replaces an earlier
  /// plane.
  void setClipPlane(const Vec3& origin, const Vec3& normal);
  void clearClipPlane();
  bool isCut() const;
  /// Whether the clip plane cuts away a place. O(1).
  bool cutsAway(const Vec3& place) const;
  /// How far a place is behind the clip plane, on the side that stays, mm; infinite without one. O(1).
  double behindCut(const Vec3& place) const;

  /// Colours the surface by one number a vertex (an influence, a stress), without a copy. Throws `UsageError`
  /// when their count is not the mesh's.
  void showScalars(std::shared_ptr<const Values> values, const ColorMap& map, ValueRange range);
  /// Call when the numbers behind `showScalars` have changed. O(1).
  void scalarsChanged();
  void hideScalars();
  bool scalarsShown() const;

  /// Does not draw the inside of a closed, opaque, unclipped surface when the eye is outside its box, which
  /// saves a third of the time of a frame in software. `OrganView` calls it before every frame.
  void cullBackFaces(const Vec3& eye);
  /// Draws a translucent surface as its far walls and the nearest one over them, in the order of the
  /// renderer's props, and without depth peeling, which takes a fifth of the time of a frame in software.
  /// `OrganView` calls it while something moves.
  void setDrawnWithoutPeeling(bool unpeeled);

  /// Draws the surface with fewer triangles, between one in `part` of its vertices and no fewer than some
  /// hundreds; they follow its points, and have normals of their own. 1: all of it. `OrganView` calls it
  /// while something moves. O(n log n) for another part than the one before.
  void setCoarse(int part);
  /// Shows the triangles, to judge a mesh by. A coarse surface has other edges: it is for who says so to
  /// leave them out. Nothing happens when it is so already.
  void setMeshLook(const MeshLook& look);

  vtkActor* actor() const;
  vtkPolyData* polyData() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
