#include "surface/join_sheets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include "surface/clip_sheet.h"
#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::sample_organs {
namespace {

using geometry::TriangleMesh;

// The rims of body and lumen are cut this many mm apart, so that the band between them has an area.
constexpr double kOffLumen = 0.25;
constexpr double kOffBody = 0.35;
constexpr double kNear = 10; // mm; farther from a rim only the sign matters
constexpr Eigen::Index kSampledAtOnce = 512;

Vec3 middleOf(const Rim& rim, const SheetParts& parts) {
  Vec3 sum = Vec3::Zero();
  for (const auto v : rim)
    sum += parts.point(v);
  return sum / static_cast<double>(rim.size());
}

/// Closes the gap between two rims that run in opposite directions, with the shorter diagonal at every step.
void addBand(const Rim& rim, const Rim& other, SheetParts& parts) {
  const auto between2 = [&](auto v, auto w) { return (parts.point(v) - parts.point(w)).squaredNorm(); };
  Rim back(other.rbegin(), other.rend());
  const auto nearest = std::min_element(
      back.begin(), back.end(), [&](auto v, auto w) { return between2(v, rim[0]) < between2(w, rim[0]); });
  std::rotate(back.begin(), nearest, back.end());
  std::size_t i = 0, j = 0;
  while (i < rim.size() || j < back.size()) {
    const auto a = rim[i % rim.size()], nextA = rim[(i + 1) % rim.size()];
    const auto b = back[j % back.size()], nextB = back[(j + 1) % back.size()];
    const bool alongRim = j == back.size() || (i < rim.size() && between2(nextA, b) <= between2(a, nextB));
    if (alongRim) {
      parts.addTriangle({nextA, a, b});
      ++i;
    } else {
      parts.addTriangle({b, nextB, a});
      ++j;
    }
  }
}

template <class Value>
std::vector<double> valuesAt(const Points& points, Threads threads, const Value& value) {
  std::vector<double> values(static_cast<std::size_t>(points.rows()));
  parallelRanges(points.rows(), kSampledAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index v = begin; v < end; ++v)
      values[static_cast<std::size_t>(v)] = value(points.row(v));
  });
  return values;
}

std::vector<Rim> addBody(const Sheet& body, const std::vector<Sheet>& lumina, Threads threads,
                         SheetParts& parts) {
  return clipSheet(*body.mesh,
                   valuesAt(body.mesh->points, threads,
                            [&](const Vec3& point) {
                              double least = std::numeric_limits<double>::infinity();
                              for (const Sheet& lumen : lumina)
                                least = std::min(least, lumen.node->distanceUpTo(point, kNear));
                              return least - kOffLumen;
                            }),
                   Facing::outward, parts);
}

std::vector<Rim> addLumina(const Sheet& body, const std::vector<Sheet>& lumina, Threads threads,
                           SheetParts& parts) {
  std::vector<Rim> rims;
  for (const Sheet& lumen : lumina) {
    std::vector<Rim> more = clipSheet(
        *lumen.mesh,
        valuesAt(lumen.mesh->points, threads,
                 [&](const Vec3& point) { return -kOffBody - body.node->distanceUpTo(point, kNear); }),
        Facing::inward, parts);
    std::move(more.begin(), more.end(), std::back_inserter(rims));
  }
  return rims;
}

/// Takes the rim whose middle is nearest out of `rims`.
Rim takeNearest(std::vector<Rim>& rims, const Vec3& middle, const SheetParts& parts) {
  const auto nearest = std::min_element(rims.begin(), rims.end(), [&](const Rim& x, const Rim& y) {
    return (middleOf(x, parts) - middle).squaredNorm() < (middleOf(y, parts) - middle).squaredNorm();
  });
  Rim found = std::move(*nearest);
  rims.erase(nearest);
  return found;
}

} // namespace

TriangleMesh joinSheets(const Sheet& body, const std::vector<Sheet>& lumina, Threads threads) {
  SheetParts parts;
  const std::vector<Rim> outer = addBody(body, lumina, threads, parts);
  std::vector<Rim> inner = addLumina(body, lumina, threads, parts);
  if (outer.size() != inner.size())
    throw DataError("body and lumina have different rims", {},
                    "let lumina leave the body only through the flat ends of vessels");
  for (const Rim& rim : outer)
    addBand(rim, takeNearest(inner, middleOf(rim, parts), parts), parts);
  TriangleMesh mesh = parts.mesh();
  const geometry::SurfaceReport report = geometry::checkSurface(mesh);
  if (!report.closed() || !report.manifold() || report.components != 1)
    throw DataError("a lumen does not leave the body cleanly", {},
                    "end vessels flat, and keep their rims apart from other parts");
  return mesh;
}

} // namespace viscera::sample_organs
