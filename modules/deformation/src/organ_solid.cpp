#include "viscera/deformation/organ_solid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tetrahedron_faces.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

using SolidReason = TetrahedraError::Reason;

/// The tetrahedra fill the wall to this part of the organ's volume, or a cavity is not inside.
constexpr double kWallTolerance = 1e-6;

using Place = std::array<double, 3>;

Place placeOf(const Points& points, Eigen::Index row) {
  return {points(row, 0), points(row, 1), points(row, 2)};
}

/// All surfaces as one, the outer one outward and the cavities inward, and the wall of each of its points.
class Walls {
public:
  void add(const NamedWall& wall, bool outward) {
    const geometry::TriangleMesh& mesh = *wall.mesh;
    geometry::requireValid(mesh, wall.name);
    const geometry::SurfaceReport report = geometry::checkSurface(mesh);
    if (mesh.triangles.rows() == 0 || !report.closed())
      throw TetrahedraError(
          SolidReason::refused,
          phrase("the surface %1 is open (%2 boundary edges)", named(wall.name), report.boundaryEdges),
          "close its holes first");
    const double volume = geometry::volume(mesh.points, mesh.triangles);
    volumeMm3 += outward ? std::abs(volume) : -std::abs(volume);
    if (outward)
      outerMm3 = std::abs(volume);
    takePlaces(wall);
    const Eigen::Index points = all.points.rows(), triangles = all.triangles.rows();
    all.points.conservativeResize(points + mesh.points.rows(), 3);
    all.points.bottomRows(mesh.points.rows()) = mesh.points;
    all.triangles.conservativeResize(triangles + mesh.triangles.rows(), 3);
    auto added = all.triangles.bottomRows(mesh.triangles.rows());
    added = mesh.triangles.array() + static_cast<std::int32_t>(points);
    if ((volume > 0) != outward)
      added.col(1).swap(added.col(2));
    names_.push_back(wall.name);
  }

  /// The wall that a point of the solid is on; -1: it is within.
  int wallAt(const Place& place) const {
    const auto found = places_.find(place);
    return found == places_.end() ? -1 : found->second;
  }

  geometry::TriangleMesh all;
  double volumeMm3 = 0; ///< Between the walls.
  double outerMm3 = 0;

private:
  void takePlaces(const NamedWall& wall) {
    const int number = static_cast<int>(names_.size());
    for (Eigen::Index v = 0; v < wall.mesh->points.rows(); ++v) {
      const auto [entry, isNew] = places_.try_emplace(placeOf(wall.mesh->points, v), number);
      if (!isNew && entry->second != number)
        throw TetrahedraError(SolidReason::refused,
                              phrase("the surfaces %1 and %2 share points",
                                     named(names_[static_cast<std::size_t>(entry->second)]),
                                     named(wall.name)),
                              "move them apart: there is no tissue between them");
    }
  }

  std::map<Place, int> places_;
  std::vector<std::string> names_;
};

/// A face as it is found from both of its sides.
struct SolidFace {
  std::array<std::int32_t, 3> sorted;
  std::array<std::int32_t, 2> side; ///< The tetrahedron and its other corner.
};

/// The faces that belong to one tetrahedron only, in the order of their corners.
std::vector<SolidFace> boundaryOf(const Tetrahedra& tetrahedra) {
  std::vector<SolidFace> faces;
  faces.reserve(static_cast<std::size_t>(4 * tetrahedra.rows()));
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t)
    for (std::size_t other = 0; other < kFaces.size(); ++other) {
      SolidFace face;
      for (std::size_t k = 0; k < 3; ++k)
        face.sorted[k] = tetrahedra(t, kFaces[other][k]);
      std::sort(face.sorted.begin(), face.sorted.end());
      face.side = {static_cast<std::int32_t>(t), static_cast<std::int32_t>(other)};
      faces.push_back(face);
    }
  std::sort(faces.begin(), faces.end(),
            [](const SolidFace& a, const SolidFace& b) { return a.sorted < b.sorted; });
  std::vector<SolidFace> single;
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    for (end = begin + 1; end < faces.size() && faces[end].sorted == faces[begin].sorted;)
      ++end;
    if (end == begin + 1)
      single.push_back(faces[begin]);
  }
  return single;
}

/// Sorts the boundary into the walls.
void nameBoundary(OrganSolid& solid, const Walls& walls) {
  std::vector<bool> isOnWall(static_cast<std::size_t>(solid.points.rows()), false);
  for (const SolidFace& face : boundaryOf(solid.tetrahedra)) {
    const int wall = walls.wallAt(placeOf(solid.points, face.sorted[0]));
    for (const std::int32_t corner : face.sorted) {
      if (wall < 0 || walls.wallAt(placeOf(solid.points, corner)) != wall)
        throw TetrahedraError(SolidReason::unusable, phrase("TetGen's result does not fill this surface: %1",
                                                            diagnostic("a face of it is on no surface")));
      if (!isOnWall[static_cast<std::size_t>(corner)])
        solid.walls[static_cast<std::size_t>(wall)].nodes.push_back(corner);
      isOnWall[static_cast<std::size_t>(corner)] = true;
    }
    solid.walls[static_cast<std::size_t>(wall)].faces.push_back(face.side);
  }
  for (OrganSolid::Wall& wall : solid.walls) {
    std::sort(wall.nodes.begin(), wall.nodes.end());
    std::sort(wall.faces.begin(), wall.faces.end());
  }
}

} // namespace

OrganSolid fillOrgan(const NamedWall& outer, const std::vector<NamedWall>& cavities,
                     const TetrahedraOptions& options, Progress& progress) {
  Walls walls;
  OrganSolid solid;
  walls.add(outer, true);
  solid.walls.push_back({outer.name, {}, {}});
  for (const NamedWall& cavity : cavities) {
    walls.add(cavity, false);
    solid.walls.push_back({cavity.name, {}, {}});
  }
  WitnessMesh mesh = tetrahedralise(walls.all, options, progress);
  const double filled = tetrahedronVolumes(mesh.points, mesh.tetrahedra).sum();
  if (!(std::abs(filled - walls.volumeMm3) <= kWallTolerance * walls.outerMm3))
    throw TetrahedraError(SolidReason::unusable,
                          "a cavity is not wholly inside the organ, or inside another cavity",
                          "leave it out, or make it smaller");
  solid.points = std::move(mesh.points);
  solid.tetrahedra = std::move(mesh.tetrahedra);
  nameBoundary(solid, walls);
  return solid;
}

} // namespace viscera::deformation
