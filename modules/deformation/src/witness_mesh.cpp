#include "viscera/deformation/witness_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/geometry/winding_number.h"

namespace viscera::deformation {
namespace {

/// A tetrahedron below this part of the box's volume is flat: its sign is a matter of rounding.
constexpr double kFlat = 1e-15;

/// The corners of the four faces, outward in a positive tetrahedron.
constexpr std::array<std::array<int, 3>, 4> kFaces = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

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

constexpr Eigen::Index kGrain = 1024;

/// Which of the points are inside a cavity.
std::vector<char> insideCavities(const Points& points,
                                 const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& cavities,
                                 Threads threads) {
  std::vector<char> inside(static_cast<std::size_t>(points.rows()), 0);
  for (const auto& cavity : cavities) {
    const geometry::WindingNumber winding(*cavity);
    const Bounds box = boundsOf(cavity->points);
    parallelRanges(points.rows(), kGrain, threads, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index i = begin; i < end; ++i) {
        const Vec3 at = points.row(i).transpose();
        const bool near = (at.array() >= box.low.array()).all() && (at.array() <= box.high.array()).all();
        if (near && winding.inside(at))
          inside[static_cast<std::size_t>(i)] = 1;
      }
    });
  }
  return inside;
}

Points middlesOf(const WitnessMesh& mesh) {
  Points middles = Points::Zero(mesh.tetrahedra.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t)
    for (int c = 0; c < 4; ++c)
      middles.row(t) += 0.25 * mesh.points.row(mesh.tetrahedra(t, c));
  return middles;
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
      throw DataError("witness point " + std::to_string(i) + " has a coordinate that is not finite", where);
  const Bounds box = boundsOf(mesh.points);
  const double smallest = kFlat * (box.high - box.low).prod();
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t) {
    if (mesh.tetrahedra.row(t).minCoeff() < 0 || mesh.tetrahedra.row(t).maxCoeff() >= mesh.points.rows())
      throw DataError("tetrahedron " + std::to_string(t) + " has a corner that does not exist", where);
    if (!(signedVolume(mesh.points, mesh.tetrahedra, t) > smallest))
      throw DataError("tetrahedron " + std::to_string(t) + " is flat or turned around", where);
  }
}

WitnessMesh withoutCavities(const WitnessMesh& mesh,
                            const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& cavities,
                            Threads threads) {
  const std::vector<char> inside = insideCavities(middlesOf(mesh), cavities, threads);
  const auto left = static_cast<Eigen::Index>(std::count(inside.begin(), inside.end(), 0));
  WitnessMesh carved;
  carved.tetrahedra.resize(left, 4);
  std::vector<std::int32_t> number(static_cast<std::size_t>(mesh.points.rows()), -1);
  Eigen::Index row = 0;
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t) {
    if (inside[static_cast<std::size_t>(t)] != 0)
      continue;
    carved.tetrahedra.row(row++) = mesh.tetrahedra.row(t);
    for (int c = 0; c < 4; ++c)
      number[static_cast<std::size_t>(mesh.tetrahedra(t, c))] = 0;
  }
  // Corners that stick out into a cavity close the solid, as those on the organ's surface do.
  const std::vector<char> inBlood = insideCavities(mesh.points, cavities, threads);
  std::int32_t points = 0;
  for (const bool wanted : {true, false})
    for (Eigen::Index point = 0; point < mesh.points.rows(); ++point) {
      const auto at = static_cast<std::size_t>(point);
      if (number[at] >= 0 && (mesh.isWitness(point) && inBlood[at] == 0) == wanted) {
        number[at] = points++;
        carved.witnesses += wanted ? 1 : 0;
      }
    }
  if (left == mesh.tetrahedra.rows() || carved.witnesses == 0)
    return mesh;
  carved.points.resize(points, 3);
  for (Eigen::Index point = 0; point < mesh.points.rows(); ++point)
    if (number[static_cast<std::size_t>(point)] >= 0)
      carved.points.row(number[static_cast<std::size_t>(point)]) = mesh.points.row(point);
  for (Eigen::Index i = 0; i < carved.tetrahedra.size(); ++i)
    carved.tetrahedra.data()[i] = number[static_cast<std::size_t>(carved.tetrahedra.data()[i])];
  return carved;
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
