#include "viscera/live/heart_blood.h"

#include <array>
#include <map>
#include <utility>

namespace viscera::live {
namespace {

using geometry::TriangleMesh;
using Rim = std::vector<Eigen::Index>;

/// The walls' vertex in the place of each vertex of a lumen; -1: none.
std::vector<Eigen::Index> sharedVertices(const Points& lumen, const Points& walls) {
  std::map<std::array<double, 3>, Eigen::Index> known;
  for (Eigen::Index v = 0; v < walls.rows(); ++v)
    known.emplace(std::array{walls(v, 0), walls(v, 1), walls(v, 2)}, v);
  std::vector<Eigen::Index> found(static_cast<std::size_t>(lumen.rows()), -1);
  for (Eigen::Index v = 0; v < lumen.rows(); ++v)
    if (const auto at = known.find({lumen(v, 0), lumen(v, 1), lumen(v, 2)}); at != known.end())
      found[static_cast<std::size_t>(v)] = at->second;
  return found;
}

using Corners = std::vector<std::array<Eigen::Index, 3>>;

/// The closed lines along which triangles are open, in the direction in which triangles close them.
std::vector<Rim> rimsOf(const Corners& triangles) {
  std::map<std::pair<Eigen::Index, Eigen::Index>, bool> edges;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      edges[{t[k], t[(k + 1) % 3]}] = true;
  std::multimap<Eigen::Index, Eigen::Index> next;
  for (const auto& edge : edges)
    if (edges.count({edge.first.second, edge.first.first}) == 0)
      next.emplace(edge.first.second, edge.first.first);
  std::vector<Rim> rims;
  while (!next.empty()) {
    Rim rim;
    for (auto step = next.begin(); step != next.end(); step = next.find(rim.back())) {
      if (rim.empty())
        rim.push_back(step->first);
      rim.push_back(step->second);
      next.erase(step);
      if (rim.back() == rim.front())
        break;
    }
    rim.pop_back();
    rims.push_back(std::move(rim));
  }
  return rims;
}

} // namespace

HeartBlood::HeartBlood(const TriangleMesh& lumen, const TriangleMesh& walls) {
  const std::vector<Eigen::Index> shared = sharedVertices(lumen.points, walls.points);
  std::map<Eigen::Index, Eigen::Index> numbers; // Of the vertices that stay.
  Corners triangles;
  for (const auto& t : lumen.triangles.rowwise()) {
    std::array<Eigen::Index, 3> corners{};
    bool stays = true;
    for (int k = 0; k < 3; ++k)
      stays = stays && shared[static_cast<std::size_t>(t[k])] >= 0;
    for (int k = 0; stays && k < 3; ++k) {
      const auto [number, fresh] = numbers.emplace(t[k], static_cast<Eigen::Index>(wall_.size()));
      if (fresh)
        wall_.push_back(shared[static_cast<std::size_t>(t[k])]);
      corners[static_cast<std::size_t>(k)] = number->second;
    }
    if (stays)
      triangles.push_back(corners);
  }
  rims_ = rimsOf(triangles);
  for (std::size_t end = 0; end < rims_.size(); ++end)
    for (std::size_t i = 0; i < rims_[end].size(); ++i)
      triangles.push_back({rims_[end][i], rims_[end][(i + 1) % rims_[end].size()],
                           static_cast<Eigen::Index>(wall_.size() + end)});
  TriangleMesh mesh;
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      mesh.triangles(static_cast<Eigen::Index>(t), k) =
          static_cast<Triangles::Scalar>(triangles[t][static_cast<std::size_t>(k)]);
  at(walls.points, mesh.points);
  mesh_ = std::make_shared<const TriangleMesh>(std::move(mesh));
}

void HeartBlood::at(const Points& walls, Points& out) const {
  const auto vertices = static_cast<Eigen::Index>(wall_.size());
  out.resize(vertices + static_cast<Eigen::Index>(rims_.size()), 3);
  for (Eigen::Index v = 0; v < vertices; ++v)
    out.row(v) = walls.row(wall_[static_cast<std::size_t>(v)]);
  for (std::size_t end = 0; end < rims_.size(); ++end) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (const Eigen::Index v : rims_[end])
      sum += out.row(v);
    out.row(vertices + static_cast<Eigen::Index>(end)) = sum / static_cast<double>(rims_[end].size());
  }
}

} // namespace viscera::live
