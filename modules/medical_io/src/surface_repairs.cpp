#include "viscera/medical_io/surface_repairs.h"

#include <algorithm>

#include "viscera/core/error.h"
#include "viscera/geometry/clean_surface.h"
#include "viscera/geometry/close_holes.h"
#include "viscera/geometry/connected_pieces.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/medical_io/organ_norms.h"
#include "viscera/medical_io/surface_repair.h"

namespace viscera::medical_io {
namespace {

using geometry::TriangleMesh;

constexpr int kFewestTriangles = 500, kMostTriangles = 20'000;

/// A repair that takes no time worth reporting.
template <class Function>
SurfaceRepair quick(std::string id, std::string does, Function function) {
  return {std::move(id), std::move(does),
          [function](const TriangleMesh& mesh, Progress& progress, Threads) -> TriangleMesh {
            progress.throwIfCancelled();
            return function(mesh);
          }};
}

std::vector<SurfaceRepair> allRepairs() {
  std::vector<SurfaceRepair> list = {
      quick("orient", "turns triangles around so that all of them face outward",
            [](TriangleMesh mesh) {
              geometry::faceOutward(mesh);
              return mesh;
            }),
      quick("fill-holes", "fills every hole with a cap",
            [](const TriangleMesh& mesh) { return geometry::closeHoles(mesh).mesh; }),
      quick("keep-largest", "keeps the piece with the largest area and drops the others",
            [](const TriangleMesh& mesh) { return geometry::largestPiece(mesh); }),
      {"remesh", "makes a closed surface without intersections near this one; colours are lost",
       [](const TriangleMesh& mesh, Progress& progress, Threads threads) {
         return remeshed(mesh, 0, progress, threads);
       }},
      quick("mirror", "exchanges left and right", geometry::mirrored),
      quick("ras-to-lps", "turns the surface by half a turn, as from RAS to LPS", geometry::turnedHalf)};
  for (const LengthUnit& unit : lengthUnits())
    if (unit.mm != 1)
      list.push_back(quick("unit-" + std::string(unit.id),
                           "takes the coordinates as " + std::string(unit.name),
                           [mm = unit.mm](const TriangleMesh& mesh) { return geometry::scaled(mesh, mm); }));
  return list;
}

} // namespace

const std::vector<SurfaceRepair>& surfaceRepairs() {
  static const std::vector<SurfaceRepair> kRepairs = allRepairs();
  return kRepairs;
}

const SurfaceRepair& surfaceRepair(std::string_view id) {
  std::string known;
  for (const SurfaceRepair& repair : surfaceRepairs()) {
    if (repair.id == id)
      return repair;
    known += (known.empty() ? "" : ", ") + repair.id;
  }
  throw UsageError("there is no repair \"" + std::string(id) + "\"", {}, "there are " + known);
}

TriangleMesh remeshed(const TriangleMesh& mesh, int triangles, Progress& progress, Threads threads) {
  RepairOptions options;
  options.triangles =
      triangles > 0 ? triangles
                    : std::clamp(static_cast<int>(mesh.triangles.rows()), kFewestTriangles, kMostTriangles);
  return repairSurface(mesh, options, progress, threads);
}

} // namespace viscera::medical_io
