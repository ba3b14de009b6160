#include "viscera/strain/wall_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "open_surface.h"
#include "viscera/deformation/witness_mesh.h"

namespace viscera::strain {
namespace {

/// The height from which thickness counts: at the annulus the nearest place is beside the wall.
constexpr double kThicknessFrom = 0.08;
/// The rings of the twist, as parts of the long axis.
constexpr double kBaseRing[2] = {0.05, 0.2}, kApexRing[2] = {0.75, 0.92};
constexpr Eigen::Index kVerticesATime = 64;
constexpr double kDegrees = 180 / std::numbers::pi;

} // namespace

std::vector<bool> verticesOf(Eigen::Index vertices, const Triangles& triangles,
                             const std::vector<bool>& leftOut) {
  std::vector<bool> used(static_cast<std::size_t>(vertices), false);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    if (leftOut.empty() || !leftOut[static_cast<std::size_t>(t)])
      for (const std::int32_t corner : triangles.row(t))
        used[static_cast<std::size_t>(corner)] = true;
  return used;
}

ThicknessGauge::ThicknessGauge(const Points& rest, const Triangles& triangles, const std::vector<bool>& cap,
                               const HeartAxes& axes, int most) {
  const std::vector<bool> onWall = verticesOf(rest.rows(), triangles, cap);
  for (const int row : deformation::thinnedPoints(rest, rest.rows(), most)) {
    const Vec3 place = rest.row(row).transpose();
    if (!onWall[static_cast<std::size_t>(row)] || axes.heightOf(place) < kThicknessFrom)
      continue;
    if (const int segment = segmentOf(axes, place); segment > 0)
      vertices_.emplace_back(row, segment);
  }
}

std::array<double, kSegments + 1> ThicknessGauge::at(const Points& cavity, const std::vector<Bound>& around,
                                                     Threads threads) const {
  std::vector<OpenSurface> surfaces;
  for (const Bound& bound : around)
    surfaces.emplace_back(*bound.points, *bound.triangles,
                          bound.leftOut ? *bound.leftOut : std::vector<bool>());
  Values nearest =
      Values::Constant(static_cast<Eigen::Index>(vertices_.size()), std::numeric_limits<double>::infinity());
  parallelRanges(nearest.size(), kVerticesATime, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i)
      for (const OpenSurface& surface : surfaces) {
        const std::int32_t row = vertices_[static_cast<std::size_t>(i)].first;
        nearest[i] = std::min(nearest[i], surface.distanceTo(cavity.row(row).transpose()));
      }
  });
  std::array<double, kSegments + 1> sums{};
  std::array<int, kSegments + 1> counts{};
  for (Eigen::Index i = 0; i < nearest.size(); ++i) {
    for (const int place : {vertices_[static_cast<std::size_t>(i)].second, 0}) {
      sums[static_cast<std::size_t>(place)] += nearest[i];
      ++counts[static_cast<std::size_t>(place)];
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    sums[i] = counts[i] > 0 ? sums[i] / counts[i] : std::numeric_limits<double>::quiet_NaN();
  return sums;
}

TwistGauge::TwistGauge(const Points& rest, const std::vector<bool>& onWall, const HeartAxes& axes)
    : down_(axes.down()) {
  for (Eigen::Index row = 0; row < rest.rows(); ++row) {
    if (!onWall[static_cast<std::size_t>(row)])
      continue;
    const double height = axes.heightOf(rest.row(row).transpose());
    if (height >= kBaseRing[0] && height <= kBaseRing[1])
      base_.push_back(static_cast<std::int32_t>(row));
    if (height >= kApexRing[0] && height <= kApexRing[1])
      apex_.push_back(static_cast<std::int32_t>(row));
  }
}

Vec3 TwistGauge::middleOf(const std::vector<std::int32_t>& ring, const Points& points) const {
  Vec3 sum = Vec3::Zero();
  for (const std::int32_t row : ring)
    sum += points.row(row).transpose();
  return sum / static_cast<double>(ring.size());
}

double TwistGauge::turnOf(const std::vector<std::int32_t>& ring, const Points& reference,
                          const Points& now) const {
  const Vec3 before = middleOf(ring, reference), after = middleOf(ring, now);
  double sine = 0, cosine = 0;
  for (const std::int32_t row : ring) {
    Vec3 from = reference.row(row).transpose() - before, to = now.row(row).transpose() - after;
    from -= from.dot(down_) * down_;
    to -= to.dot(down_) * down_;
    sine += down_.dot(from.cross(to));
    cosine += from.dot(to);
  }
  return kDegrees * std::atan2(sine, cosine);
}

TwistGauge::Twist TwistGauge::between(const Points& reference, const Points& now) const {
  return {turnOf(base_, reference, now), turnOf(apex_, reference, now)};
}

double TwistGauge::distanceMm(const Points& points) const {
  return std::abs((middleOf(apex_, points) - middleOf(base_, points)).dot(down_));
}

} // namespace viscera::strain
