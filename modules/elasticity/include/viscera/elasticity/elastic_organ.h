#pragma once

#include <memory>
#include <vector>

#include "viscera/core/progress.h"
#include "viscera/elasticity/elastic_body.h"
#include "viscera/elasticity/static_solution.h"
#include "viscera/geometry/triangle_mesh.h"

/// An organ as an elastic body that handles grip.
namespace viscera::elasticity {

/// The tetrahedra of an organ.
struct OrganOptions {
  int tetrahedra = 600;         ///< About so many; the surface is simplified to fit.
  double timeLimitSeconds = 60; ///< Of TetGen.
};

/// An organ filled with tetrahedra, and the vertices of its surface as places in them. Immutable,
/// thread-safe.
class ElasticOrgan {
public:
  /// Simplifies `surface` (closed, mm, LPS) or halves its long edges, fills it by TetGen and makes the
  /// tetrahedra quadratic, with straight edges. Throws what `deformation::tetrahedralise` throws, and
  /// `DataError` for an open surface.
  ElasticOrgan(const geometry::TriangleMesh& surface, const OrganOptions& options,
               std::shared_ptr<const Material> material, Progress& progress);

  const ElasticBody& body() const { return *body_; }
  /// The nodes on the boundary, ascending.
  const std::vector<std::int32_t>& skin() const { return skin_; }

  /// The displacements of the surface's vertices, `n x 3` mm, of those of the nodes. Vertices outside the
  /// tetrahedra take those of the nearest place in them.
  Points atSurface(const Points& nodeDisplacements) const;

private:
  struct Weights {
    std::array<std::int32_t, 10> nodes;
    Eigen::Matrix<double, 10, 1> shapes;
  };
  std::shared_ptr<const ElasticBody> body_;
  std::vector<std::int32_t> skin_;
  std::vector<Weights> vertices_;
};

/// How handles grip an organ.
struct GripOptions {
  /// What becomes of the patches of handles that the pose leaves at rest.
  enum class Others { held, free };
  Others others = Others::held;
  /// Rows of handles; if there are any, the patches of these are held, however near, and no others.
  std::vector<int> holding = {};
  double radius = 0.08; ///< Of a patch, by the diagonal of the organ's box.
};

/// The patches by which handles grip an organ.
struct Grips {
  std::vector<Prescribed> prescribed;
  int moved = 0;               ///< Patches of moved handles.
  int held = 0;                ///< Patches that are held at rest.
  double dragMm = 0;           ///< The largest displacement of a handle.
  std::vector<int> loose = {}; ///< The handles without a patch, ascending.
};

/// The nodes of the skin near each handle, prescribed to move as the handle does. A patch is what of the skin
/// is no farther from the place of the skin that is nearest to the handle than `radius`, three nodes at
/// least; a node of several belongs to the nearest. No patch is held whose middle is less than two radii from
/// a moved one. `rest` and `pose` are `handles x 3` mm. Throws `DataError` when no handle moves. O(handles x
/// skin).
Grips gripsOf(const ElasticOrgan& organ, const Points& rest, const Points& pose, const GripOptions& options);

} // namespace viscera::elasticity
