#include "viscera/strain/material_contour.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace viscera::strain {
namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;

/// The places where a plane crosses edges, and for each the one or two next ones through a triangle.
struct Crossings {
  std::vector<MaterialContour::Place> places;
  std::vector<std::array<std::int32_t, 2>> next;

  void join(std::int32_t a, std::int32_t b) {
    for (const auto& [one, other] : {Edge(a, b), Edge(b, a)})
      for (std::int32_t& place : next[static_cast<std::size_t>(one)])
        if (place < 0) {
          place = other;
          break;
        }
  }
};

Crossings crossingsOf(const Points& points, const Triangles& triangles, const std::vector<bool>& leftOut,
                      const geometry::Plane& plane) {
  const Values heights = (points.rowwise() - plane.origin.transpose()) * plane.normal;
  std::map<Edge, std::int32_t> number;
  Crossings found;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    if (!leftOut.empty() && leftOut[static_cast<std::size_t>(t)])
      continue;
    std::array<std::int32_t, 2> crossed{};
    int count = 0;
    for (int k = 0; k < 3 && count < 2; ++k) {
      const Edge edge = std::minmax(triangles(t, k), triangles(t, (k + 1) % 3));
      const double a = heights[edge.first], b = heights[edge.second];
      if ((a >= 0) == (b >= 0))
        continue;
      const auto [entry, fresh] = number.try_emplace(edge, static_cast<std::int32_t>(found.places.size()));
      if (fresh) {
        found.places.push_back({edge.first, edge.second, a / (a - b)});
        found.next.push_back({-1, -1});
      }
      crossed[static_cast<std::size_t>(count++)] = entry->second;
    }
    if (count == 2)
      found.join(crossed[0], crossed[1]);
  }
  return found;
}

/// Follows a line from a place until it ends or comes back.
MaterialContour follow(const Crossings& crossings, std::int32_t start, std::vector<bool>& seen) {
  MaterialContour line;
  std::int32_t at = start, before = -1;
  while (at >= 0 && !seen[static_cast<std::size_t>(at)]) {
    seen[static_cast<std::size_t>(at)] = true;
    line.places.push_back(crossings.places[static_cast<std::size_t>(at)]);
    const auto& next = crossings.next[static_cast<std::size_t>(at)];
    const std::int32_t onward = next[0] != before ? next[0] : next[1];
    before = at;
    at = onward;
  }
  line.closed = at == start && line.places.size() > 2;
  return line;
}

} // namespace

MaterialContour MaterialContour::through(const std::vector<std::int32_t>& vertices, bool closed) {
  MaterialContour contour;
  contour.closed = closed;
  for (const std::int32_t vertex : vertices)
    contour.places.push_back({vertex, vertex, 0});
  return contour;
}

Points MaterialContour::at(const Points& points) const {
  Points result(static_cast<Eigen::Index>(places.size()), 3);
  for (std::size_t i = 0; i < places.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) =
        (1 - places[i].part) * points.row(places[i].from) + places[i].part * points.row(places[i].to);
  return result;
}

double MaterialContour::lengthAt(const Points& points) const {
  const Points line = at(points);
  double length = 0;
  for (Eigen::Index i = 1; i < line.rows(); ++i)
    length += (line.row(i) - line.row(i - 1)).norm();
  if (closed && line.rows() > 1)
    length += (line.row(0) - line.row(line.rows() - 1)).norm();
  return length;
}

std::vector<MaterialContour> cutContours(const Points& points, const Triangles& triangles,
                                         const std::vector<bool>& leftOut, const geometry::Plane& plane) {
  const Crossings crossings = crossingsOf(points, triangles, leftOut, plane);
  std::vector<bool> seen(crossings.places.size(), false);
  std::vector<MaterialContour> lines;
  const auto followAll = [&](bool ends) {
    for (std::size_t i = 0; i < seen.size(); ++i)
      if (!seen[i] && (!ends || crossings.next[i][1] < 0))
        lines.push_back(follow(crossings, static_cast<std::int32_t>(i), seen));
  };
  followAll(true); // Open lines from one of their ends; what is left is closed.
  followAll(false);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < lines.size(); ++i)
    order.emplace_back(-lines[i].lengthAt(points), i);
  std::sort(order.begin(), order.end());
  std::vector<MaterialContour> sorted;
  for (const auto& [length, i] : order)
    sorted.push_back(std::move(lines[i]));
  return sorted;
}

MaterialContour partFrom(const MaterialContour& contour, std::size_t place) {
  MaterialContour part;
  part.places.assign(contour.places.begin() + static_cast<std::ptrdiff_t>(place), contour.places.end());
  return part;
}

MaterialContour partUpTo(const MaterialContour& contour, std::size_t place) {
  MaterialContour part;
  part.places.assign(contour.places.begin(), contour.places.begin() + static_cast<std::ptrdiff_t>(place) + 1);
  return part;
}

} // namespace viscera::strain
