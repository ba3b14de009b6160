#include "viscera/deformation/carve_witnesses.h"

#include <algorithm>

#include "viscera/geometry/winding_number.h"

namespace viscera::deformation {
namespace {

constexpr Eigen::Index kGrain = 1024;

/// Which tetrahedra have their middle inside a cavity.
std::vector<char> insideCavities(const WitnessMesh& mesh,
                                 const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& cavities,
                                 Threads threads) {
  std::vector<char> inside(static_cast<std::size_t>(mesh.tetrahedra.rows()), 0);
  for (const auto& cavity : cavities) {
    const geometry::WindingNumber winding(*cavity);
    const Bounds box = boundsOf(cavity->points);
    parallelRanges(mesh.tetrahedra.rows(), kGrain, threads, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index t = begin; t < end; ++t) {
        Vec3 middle = Vec3::Zero();
        for (int c = 0; c < 4; ++c)
          middle += 0.25 * mesh.points.row(mesh.tetrahedra(t, c)).transpose();
        const bool near =
            (middle.array() >= box.low.array()).all() && (middle.array() <= box.high.array()).all();
        if (near && winding.inside(middle))
          inside[static_cast<std::size_t>(t)] = 1;
      }
    });
  }
  return inside;
}

} // namespace

WitnessMesh withoutCavities(const WitnessMesh& mesh,
                            const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& cavities,
                            Threads threads) {
  const std::vector<char> inside = insideCavities(mesh, cavities, threads);
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
  std::int32_t points = 0;
  for (Eigen::Index point = 0; point < mesh.points.rows(); ++point) {
    if (number[static_cast<std::size_t>(point)] < 0)
      continue;
    number[static_cast<std::size_t>(point)] = points++;
    carved.witnesses += mesh.isWitness(point) ? 1 : 0;
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

} // namespace viscera::deformation
