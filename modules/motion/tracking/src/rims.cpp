#include "viscera/tracking/rims.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace viscera::tracking {
namespace {

/// A rim shorter than this part of the diagonal of its surface is a fault of the mesh.
constexpr double kShortestRim = 0.2;

Points edgesOf(const Points& rim) {
  Points edges(rim.rows(), 3);
  for (Eigen::Index i = 0; i < rim.rows(); ++i)
    edges.row(i) = rim.row((i + 1) % rim.rows()) - rim.row(i);
  return edges;
}

struct PlacedRim {
  const Rim* rim = nullptr;
  Vec3 middle;
};

std::vector<PlacedRim> valvesOf(const RimmedSurface& surface) {
  const double shortest = kShortestRim * boundsOf(surface.mesh->points).diagonal();
  std::vector<PlacedRim> valves;
  for (const Rim& rim : *surface.rims) {
    const Points points = pointsOf(rim, surface.mesh->points);
    const Values lengths = lengthsAlong(points);
    if (lengths.sum() >= shortest)
      valves.push_back({&rim, (lengths.transpose() * points).transpose() / lengths.sum()});
  }
  return valves;
}

/// Puts rims in the order of those before them: the nearest pair first.
std::vector<PlacedRim> inOrderOf(const std::vector<PlacedRim>& before, std::vector<PlacedRim> rims) {
  std::vector<PlacedRim> ordered(before.size());
  for (std::size_t left = before.size(); left > 0; --left) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t to = 0, from = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
      for (std::size_t k = 0; k < rims.size(); ++k)
        if (const double apart = (rims[k].middle - before[i].middle).norm();
            !ordered[i].rim && apart < least) {
          least = apart;
          to = i;
          from = k;
        }
    ordered[to] = rims[from];
    rims.erase(rims.begin() + static_cast<std::ptrdiff_t>(from));
  }
  return ordered;
}

} // namespace

std::vector<std::vector<Rim>> commonRims(const std::vector<RimmedSurface>& phases) {
  std::vector<std::vector<Rim>> common;
  std::vector<PlacedRim> before;
  for (const RimmedSurface& phase : phases) {
    std::vector<PlacedRim> valves = valvesOf(phase);
    if (valves.empty() || (!common.empty() && valves.size() != before.size()))
      return {};
    before = common.empty() ? std::move(valves) : inOrderOf(before, std::move(valves));
    std::vector<Rim>& rims = common.emplace_back();
    for (const PlacedRim& valve : before)
      rims.push_back(*valve.rim);
  }
  return common;
}

Points pointsOf(const Rim& rim, const Points& points) {
  Points result(static_cast<Eigen::Index>(rim.size()), 3);
  for (std::size_t i = 0; i < rim.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) = points.row(rim[i]);
  return result;
}

Values lengthsAlong(const Points& rim) {
  const Values edges = edgesOf(rim).rowwise().norm();
  Values lengths(rim.rows());
  for (Eigen::Index i = 0; i < rim.rows(); ++i)
    lengths[i] = (edges[i] + edges[(i + rim.rows() - 1) % rim.rows()]) / 2;
  return lengths;
}

PlaceOnRim nearestOnRim(const Points& rim, const Vec3& point) {
  PlaceOnRim place{rim.row(0), Vec3::Zero()};
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < rim.rows(); ++i) {
    const Vec3 from = rim.row(i), edge = rim.row((i + 1) % rim.rows()).transpose() - from;
    const double squared = edge.squaredNorm();
    if (!(squared > 0))
      continue;
    const Vec3 at = from + std::clamp((point - from).dot(edge) / squared, 0.0, 1.0) * edge;
    if (const double apart = (point - at).squaredNorm(); apart < least) {
      least = apart;
      place = {at, edge.normalized()};
    }
  }
  return place;
}

} // namespace viscera::tracking
