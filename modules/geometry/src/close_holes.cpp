#include "viscera/geometry/close_holes.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "viscera/core/error.h"

namespace viscera::geometry {
namespace {

using Loop = std::vector<std::int32_t>;

/// Open edges, each as the triangle that is missing beside it would run through it: from `first` to `second`.
using OpenEdges = std::multimap<std::int32_t, std::int32_t>;

OpenEdges openEdges(const Triangles& triangles) {
  struct Use {
    std::int32_t low, high;
    bool forward;
    bool operator<(const Use& other) const { return std::pair(low, high) < std::pair(other.low, other.high); }
  };
  std::vector<Use> uses;
  uses.reserve(static_cast<std::size_t>(triangles.size()));
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = triangles(t, k), b = triangles(t, (k + 1) % 3);
      uses.push_back({std::min(a, b), std::max(a, b), a < b});
    }
  std::sort(uses.begin(), uses.end());
  OpenEdges open;
  for (std::size_t begin = 0; begin < uses.size();) {
    std::size_t end = begin + 1;
    while (end < uses.size() && !(uses[begin] < uses[end]))
      ++end;
    const Use& use = uses[begin];
    if (end - begin == 1)
      open.emplace(use.forward ? use.high : use.low, use.forward ? use.low : use.high);
    begin = end;
  }
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
                      "vertex " + std::to_string(path.back()), "repair the surface in another program first");
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
  int holes = 0;
  for (; !open.empty(); ++holes)
    caps.add(takeLoop(open));
  return {holes > 0 ? caps.closed() : mesh, holes};
}

} // namespace viscera::geometry
