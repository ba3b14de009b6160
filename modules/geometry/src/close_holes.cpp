#include "viscera/geometry/close_holes.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "edge_uses.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::geometry {
namespace {

using Loop = std::vector<std::int32_t>;

/// Open edges, each as the triangle that is missing beside it would run through it: from `first` to `second`.
using OpenEdges = std::multimap<std::int32_t, std::int32_t>;

OpenEdges openEdges(const Triangles& triangles) {
  OpenEdges open;
  forEachEdge(triangles, [&](std::span<const EdgeUse> uses) {
    const auto low = static_cast<std::int32_t>(uses[0].edge >> 32);
    const auto high = static_cast<std::int32_t>(uses[0].edge);
    if (uses.size() == 1)
      open.emplace(uses[0].forward ? high : low, uses[0].forward ? low : high);
  });
  return open;
}

/// Takes the edges of one walk along the rim, from its lowest vertex back to where it meets itself. What
/// hangs before the meeting point goes back to the open edges: it belongs to another loop.
Loop takeLoop(OpenEdges& open) {
  Loop path = {open.begin()->first};
  for (;;) {
    const auto next = open.find(path.back());
    if (next == open.end())
      throw DataError("the triangles beside a hole do not all run the same way round, so it cannot be closed",
                      phrase("vertex %1", path.back()), "repair the surface in another program first");
    const std::int32_t vertex = next->second;
    open.erase(next);
    const auto met = std::find(path.begin(), path.end(), vertex);
    if (met == path.end()) {
      path.push_back(vertex);
      continue;
    }
    for (auto before = path.begin(); before != met; ++before)
      open.emplace(*before, *(before + 1));
    return {met, path.end()};
  }
}

/// Collects points, triangles and colours that are added to a mesh.
class Caps {
public:
  explicit Caps(const TriangleMesh& mesh) : mesh_(mesh) {}

  void add(const Loop& loop) {
    if (loop.size() == 3) {
      triangles_.emplace_back(loop[0], loop[1], loop[2]);
      return;
    }
    const auto middle =
        static_cast<std::int32_t>(mesh_.points.rows() + static_cast<Eigen::Index>(points_.size()));
    addMiddle(loop);
    for (std::size_t i = 0; i < loop.size(); ++i)
      triangles_.emplace_back(loop[i], loop[(i + 1) % loop.size()], middle);
  }

  TriangleMesh closed() const {
    TriangleMesh result = mesh_;
    const Eigen::Index points = mesh_.points.rows(), triangles = mesh_.triangles.rows();
    result.points.conservativeResize(points + static_cast<Eigen::Index>(points_.size()), 3);
    for (std::size_t i = 0; i < points_.size(); ++i)
      result.points.row(points + static_cast<Eigen::Index>(i)) = points_[i].transpose();
    result.triangles.conservativeResize(triangles + static_cast<Eigen::Index>(triangles_.size()), 3);
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      result.triangles.row(triangles + static_cast<Eigen::Index>(i)) = triangles_[i].transpose();
    if (mesh_.colors.rows() == points) {
      result.colors.conservativeResize(result.points.rows(), 3);
      for (std::size_t i = 0; i < colors_.size(); ++i)
        result.colors.row(points + static_cast<Eigen::Index>(i)) =
            colors_[i].array().round().cast<std::uint8_t>().matrix().transpose();
    }
    return result;
  }

private:
  void addMiddle(const Loop& loop) {
    // (sum |e| (a + b) / 2) / sum |e| over the edges e = b - a of the rim: the centroid of a wire along it.
    Vec3 point = Vec3::Zero(), color = Vec3::Zero(), evenly = Vec3::Zero();
    double length = 0;
    const bool colored = mesh_.colors.rows() == mesh_.points.rows();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3 a = mesh_.points.row(loop[i]), b = mesh_.points.row(loop[(i + 1) % loop.size()]);
      const double edge = (b - a).norm();
      point += edge * 0.5 * (a + b);
      length += edge;
      evenly += a;
      if (colored)
        color += mesh_.colors.row(loop[i]).transpose().cast<double>();
    }
    const auto count = static_cast<double>(loop.size());
    points_.push_back(length > 0 ? Vec3(point / length) : Vec3(evenly / count));
    colors_.push_back(color / count);
  }

  const TriangleMesh& mesh_;
  std::vector<Vec3> points_;
  std::vector<Vec3> colors_;
  std::vector<Eigen::Vector3i> triangles_;
};

} // namespace

ClosedSurface closeHoles(const TriangleMesh& mesh) {
  OpenEdges open = openEdges(mesh.triangles);
  Caps caps(mesh);
  std::vector<Loop> rims;
  while (!open.empty()) {
    rims.push_back(takeLoop(open));
    caps.add(rims.back());
  }
  const auto holes = static_cast<int>(rims.size());
  return {holes > 0 ? caps.closed() : mesh, holes, std::move(rims)};
}

} // namespace viscera::geometry
