#include "viscera/medical_io/surface_pieces.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "viscera/geometry/connected_pieces.h"

namespace viscera::medical_io {
namespace {

using Measure = FragmentLimit::Measure;

/// Names in the order of the enumeration.
constexpr std::array<std::string_view, 3> kMeasures = {"%", "mm", "ml"};

double measured(const PieceSize& piece, Measure measure) {
  switch (measure) {
  case Measure::percent:
    return piece.percent;
  case Measure::millimetres:
    return piece.longestMm;
  case Measure::milliliters:
    return piece.volumeMl;
  }
  return 0;
}

} // namespace

std::optional<FragmentLimit> fragmentLimit(std::string_view words) {
  double value = 0;
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), value);
  const std::string_view unit = words.substr(static_cast<std::size_t>(end - words.data()));
  const auto* known = std::find(kMeasures.begin(), kMeasures.end(), unit);
  if (error != std::errc() || known == kMeasures.end() || !(value >= 0) || !std::isfinite(value))
    return std::nullopt;
  return FragmentLimit{static_cast<Measure>(known - kMeasures.begin()), value};
}

std::string inWords(const FragmentLimit& limit) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), limit.value);
  return std::string(digits.data(), end) + std::string(kMeasures[static_cast<std::size_t>(limit.measure)]);
}

SurfacePieces::SurfacePieces(const geometry::TriangleMesh& mesh) : mesh_(mesh) {
  geometry::ConnectedPieces pieces = geometry::connectedPieces(mesh);
  const std::vector<double> areas = geometry::areasOf(pieces, mesh);
  ofVertex_ = std::move(pieces.ofVertex);
  sizes_.resize(static_cast<std::size_t>(pieces.count));
  std::vector<Bounds> boxes(sizes_.size(), {Vec3::Constant(INFINITY), Vec3::Constant(-INFINITY)});
  for (std::size_t v = 0; v < ofVertex_.size(); ++v) {
    if (ofVertex_[v] < 0)
      continue;
    Bounds& box = boxes[static_cast<std::size_t>(ofVertex_[v])];
    const Vec3 point = mesh.points.row(static_cast<Eigen::Index>(v)).transpose();
    box = {box.low.cwiseMin(point), box.high.cwiseMax(point)};
  }
  double whole = 0;
  for (const double area : areas)
    whole += area;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto piece = static_cast<std::size_t>(ofVertex_[static_cast<std::size_t>(mesh.triangles(t, 0))]);
    const Vec3 middle = boxes[piece].center(); // So that an open piece loses little.
    const auto corner = [&](int k) -> Vec3 {
      return mesh.points.row(mesh.triangles(t, k)).transpose() - middle;
    };
    sizes_[piece].volumeMl += corner(0).dot(corner(1).cross(corner(2))) / 6 / kMm3PerMl;
  }
  for (std::size_t p = 0; p < sizes_.size(); ++p) {
    sizes_[p].volumeMl = std::abs(sizes_[p].volumeMl);
    sizes_[p].percent = whole > 0 ? 100 * areas[p] / whole : 0;
    sizes_[p].longestMm = (boxes[p].high - boxes[p].low).maxCoeff();
  }
  largest_ = static_cast<std::size_t>(std::max_element(areas.begin(), areas.end()) - areas.begin());
}

bool SurfacePieces::isFragment(std::size_t piece, const FragmentLimit& limit) const {
  return piece != largest_ && measured(sizes_[piece], limit.measure) < limit.value;
}

std::size_t SurfacePieces::fragments(const FragmentLimit& limit) const {
  std::size_t count = 0;
  for (std::size_t piece = 0; piece < sizes_.size(); ++piece)
    count += isFragment(piece, limit) ? 1 : 0;
  return count;
}

geometry::TriangleMesh SurfacePieces::part(const FragmentLimit& limit, bool fragments) const {
  std::vector<Eigen::Index> vertices, triangles;
  std::vector<std::int32_t> names(ofVertex_.size(), -1);
  for (std::size_t v = 0; v < names.size(); ++v)
    if (ofVertex_[v] >= 0 && isFragment(static_cast<std::size_t>(ofVertex_[v]), limit) == fragments) {
      names[v] = static_cast<std::int32_t>(vertices.size());
      vertices.push_back(static_cast<Eigen::Index>(v));
    }
  for (Eigen::Index t = 0; t < mesh_.triangles.rows(); ++t)
    if (names[static_cast<std::size_t>(mesh_.triangles(t, 0))] >= 0)
      triangles.push_back(t);
  geometry::TriangleMesh part;
  part.points = mesh_.points(vertices, Eigen::all);
  part.triangles = mesh_.triangles(triangles, Eigen::all).unaryExpr([&](std::int32_t v) {
    return names[static_cast<std::size_t>(v)];
  });
  if (mesh_.colors.rows() > 0)
    part.colors = mesh_.colors(vertices, Eigen::all);
  return part;
}

Text describeFragments(const SurfacePieces& pieces, const FragmentLimit& limit) {
  PieceSize largest;
  std::size_t count = 0;
  for (std::size_t p = 0; p < pieces.sizes().size(); ++p)
    if (pieces.isFragment(p, limit)) {
      ++count;
      largest.longestMm = std::max(largest.longestMm, pieces.sizes()[p].longestMm);
      largest.volumeMl = std::max(largest.volumeMl, pieces.sizes()[p].volumeMl);
    }
  if (count == 0)
    return phrase("none of the %1 pieces is as small as that", pieces.sizes().size());
  return phrase("%n of %2 pieces {goes|go}, of %3 mm and %4 ml at most", count, pieces.sizes().size(),
                inDigits(largest.longestMm, 2), inDigits(largest.volumeMl, 2));
}

} // namespace viscera::medical_io
