#include "viscera/deformation/witness_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

#include "tetrahedron_faces.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::deformation {
namespace {

/// A tetrahedron below this part of the box's volume is flat: its sign is a matter of rounding.
constexpr double kFlatTetrahedron = 1e-15;

struct Face {
  std::array<std::int32_t, 3> sorted;
  std::array<std::int32_t, 3> outward;
};

double signedVolume(const Points& points, const Tetrahedra& tetrahedra, Eigen::Index t) {
  const Eigen::RowVector3d a = points.row(tetrahedra(t, 0));
  return (points.row(tetrahedra(t, 1)) - a)
             .cross(points.row(tetrahedra(t, 2)) - a)
             .dot(points.row(tetrahedra(t, 3)) - a) /
         6;
}

constexpr int kHalvings = 24;

struct Nearest {
  int point = -1;
  double distance = std::numeric_limits<double>::infinity();
};

using Cells = std::unordered_map<std::int64_t, Nearest>;

/// The point nearest to the middle of each cell that holds some.
Cells cellsOf(const Points& points, Eigen::Index count, const Vec3& low, double edge) {
  Cells cells;
  constexpr std::int64_t kRow = std::int64_t{1} << 20;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vec3 at = (points.row(i).transpose() - low) / edge;
    const Vec3 cell = at.array().floor();
    const std::int64_t key =
        (static_cast<std::int64_t>(cell.z()) * kRow + static_cast<std::int64_t>(cell.y())) * kRow +
        static_cast<std::int64_t>(cell.x());
    Nearest& nearest = cells[key];
    const double distance = (at - cell - Vec3::Constant(0.5)).squaredNorm();
    if (distance < nearest.distance)
      nearest = {static_cast<int>(i), distance};
  }
  return cells;
}

} // namespace

Values tetrahedronVolumes(const Points& points, const Tetrahedra& tetrahedra) {
  Values volumes(tetrahedra.rows());
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t)
    volumes[t] = signedVolume(points, tetrahedra, t);
  return volumes;
}

Triangles skinOf(const Tetrahedra& tetrahedra) {
  std::vector<Face> faces;
  faces.reserve(static_cast<std::size_t>(4 * tetrahedra.rows()));
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t)
    for (const auto& corners : kFaces) {
      Face face;
      for (std::size_t k = 0; k < 3; ++k)
        face.outward[k] = tetrahedra(t, corners[k]);
      face.sorted = face.outward;
      std::sort(face.sorted.begin(), face.sorted.end());
      faces.push_back(face);
    }
  std::sort(faces.begin(), faces.end(), [](const Face& x, const Face& y) { return x.sorted < y.sorted; });
  std::vector<std::array<std::int32_t, 3>> skin;
  for (std::size_t begin = 0, end; begin < faces.size(); begin = end) {
    for (end = begin + 1; end < faces.size() && faces[end].sorted == faces[begin].sorted;)
      ++end;
    if (end == begin + 1)
      skin.push_back(faces[begin].outward);
  }
  Triangles triangles(static_cast<Eigen::Index>(skin.size()), 3);
  for (std::size_t i = 0; i < skin.size(); ++i)
    triangles.row(static_cast<Eigen::Index>(i)) << skin[i][0], skin[i][1], skin[i][2];
  return triangles;
}

void requireUsable(const WitnessMesh& mesh, const std::string& where) {
  if (mesh.witnesses < 1 || mesh.witnesses > mesh.points.rows())
    throw DataError("no witness point lies inside", where);
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
    if (!mesh.points.row(i).allFinite())
      throw DataError(misuse("witness point %1 has a coordinate that is not finite", i), where);
  const Bounds box = boundsOf(mesh.points);
  const double smallest = kFlatTetrahedron * (box.high - box.low).prod();
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t) {
    if (mesh.tetrahedra.row(t).minCoeff() < 0 || mesh.tetrahedra.row(t).maxCoeff() >= mesh.points.rows())
      throw DataError(misuse("tetrahedron %1 has a corner that does not exist", t), where);
    if (!(signedVolume(mesh.points, mesh.tetrahedra, t) > smallest))
      throw DataError(misuse("tetrahedron %1 is flat or turned around", t), where);
  }
}

std::vector<int> thinnedPoints(const Points& points, Eigen::Index count, int most) {
  std::vector<int> chosen;
  if (count <= most) {
    for (Eigen::Index i = 0; i < count; ++i)
      chosen.push_back(static_cast<int>(i));
    return chosen;
  }
  const Bounds box = boundsOf(points.topRows(count));
  const double size = std::max((box.high - box.low).maxCoeff(), std::numeric_limits<double>::min());
  // The finest grid that has no more occupied cells than wanted, found by halving an interval of edges. Below
  // the lower end every point would be alone.
  double fine = size / (4 * std::cbrt(static_cast<double>(count)) + 4), coarse = 2 * size;
  Cells best = cellsOf(points, count, box.low, coarse);
  for (int i = 0; i < kHalvings && coarse / fine > 1.02; ++i) {
    const double edge = std::sqrt(fine * coarse);
    Cells cells = cellsOf(points, count, box.low, edge);
    if (static_cast<int>(cells.size()) <= most) {
      coarse = edge;
      best = std::move(cells);
    } else {
      fine = edge;
    }
  }
  for (const auto& [key, nearest] : best)
    chosen.push_back(nearest.point);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

} // namespace viscera::deformation
