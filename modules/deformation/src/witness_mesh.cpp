#include "viscera/deformation/witness_mesh.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "viscera/core/error.h"

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

} // namespace

Values tetrahedronVolumes(const Points& points, const Tetrahedra& tetrahedra) {
  Values volumes(tetrahedra.rows());
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t)
    volumes[t] = signedVolume(points, tetrahedra, t);
  return volumes;
}

Edges edgesOf(const Tetrahedra& tetrahedra) {
  std::vector<std::array<std::int32_t, 2>> all;
  all.reserve(static_cast<std::size_t>(6 * tetrahedra.rows()));
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t)
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        all.push_back(
            {std::min(tetrahedra(t, i), tetrahedra(t, j)), std::max(tetrahedra(t, i), tetrahedra(t, j))});
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  Edges edges(static_cast<Eigen::Index>(all.size()), 2);
  for (std::size_t e = 0; e < all.size(); ++e)
    edges.row(static_cast<Eigen::Index>(e)) << all[e][0], all[e][1];
  return edges;
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

} // namespace viscera::deformation
