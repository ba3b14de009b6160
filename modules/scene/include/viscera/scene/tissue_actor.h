#pragma once

#include <array>
#include <memory>
#include <optional>

#include "viscera/core/arrays.h"
#include "viscera/scene/color_map.h"
#include "viscera/scene/surface_pick.h"

class vtkActor;
class vtkRenderer;

/// Draws the inside of an organ as coloured tetrahedra that a plane can cut open.
namespace viscera::scene {

/// `t x 4` corner indices of tetrahedra, row major; the first three corners are counter-clockwise seen from
/// the fourth or clockwise, whichever.
using Tetrahedra = Eigen::Matrix<std::int32_t, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// A plane that cuts tissue open; the side to which `normal` points stays.
struct CutPlane {
  Vec3 origin = Vec3::Zero();  ///< mm.
  Vec3 normal = Vec3::UnitX(); ///< Unit.
  bool operator==(const CutPlane&) const = default;
};

/// How a plane cuts tissue.
enum class CutStyle {
  smooth, ///< Straight through the tetrahedra; the cut stays in the plane while the tissue moves.
  crinkle ///< Whole tetrahedra stay, the same ones while the tissue moves.
};

/// The place at which a line of sight meets the drawn tissue.
struct TissuePick {
  int tetrahedron = -1;
  int point = -1;                  ///< The nearest corner of that tetrahedron.
  Vec3 position = Vec3::Zero();    ///< mm.
  std::array<double, 4> weights{}; ///< Barycentric, of the tetrahedron's corners.
  double distance = 0;             ///< From the ray's origin, mm.
};

/// Draws the inside of an organ: tetrahedra coloured by one number a point, cut open by a plane, optionally
/// only those in a range of values. The neighbours of tetrahedra are found once; for a new pose, VTK reads
/// the moved points without a copy, and only the cut is computed anew. Belongs to the thread that renders.
class TissueActor {
public:
  /// `points` (`n x 3`, mm) as they are now. O(t log t) once. Throws `UsageError` for a corner that is no
  /// point.
  TissueActor(std::shared_ptr<const Tetrahedra> tetrahedra, std::shared_ptr<const Points> points);
  ~TissueActor();
  TissueActor(const TissueActor&) = delete;
  TissueActor& operator=(const TissueActor&) = delete;

  const Tetrahedra& tetrahedra() const;
  const Points& points() const;

  /// Sets the renderer to draw in; null: none.
  void setRenderer(vtkRenderer* renderer);

  /// Sets the points, or the same array with other contents, without a copy. O(1); O(t) while a cut or a
  /// range is set.
  void setPoints(std::shared_ptr<const Points> points);

  /// Sets one number for each point; NaN marks points with a colour of their own (`ColorMap::missing`), which
  /// are never left out. Without a copy, O(1) unless a shown range is set. Throws `UsageError` when their
  /// count is not that of the points.
  void setValues(std::shared_ptr<const Values> values);
  void setColors(const ColorMap& map, ValueRange range);
  /// Draws the tissue in a pale translucent colour instead of the numbers, so that glyphs inside are visible.
  void setGhost(bool ghost);

  void setCut(const CutPlane& plane, CutStyle style);
  void clearCut();

  /// Draws only tetrahedra whose corners' mean value lies in `range`.
  void setShownRange(ValueRange range);
  void clearShownRange();

  /// Whether the outside of the organ is drawn; off when its own surface is drawn in its place.
  void setOutsideShown(bool shown);
  void setVisible(bool visible);
  bool visible() const;

  /// Updates the drawn geometry now instead of before the next frame.
  void update();
  /// Tetrahedra that are drawn, cut ones included; up to date after `update`.
  int shownTetrahedra() const;
  /// Triangles of the smooth cut; up to date after `update`.
  int cutTriangles() const;

  /// The tissue as drawn at the next frame under a line of sight. O(triangles).
  std::optional<TissuePick> pick(const Ray& ray);

  /// The actors: the faces of tetrahedra, and the smooth cut.
  vtkActor* faces() const;
  vtkActor* cut() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
