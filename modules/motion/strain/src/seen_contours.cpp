#include "seen_contours.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "viscera/strain/wall_measures.h"

namespace viscera::strain {
namespace {

/// The part by which a line may differ from the followed one: a fit is wrong by less.
constexpr double kSameLine = 0.15;

/// The long axis in a phase, by what the fit does to the annulus and to the apex.
HeartAxes movedAxes(const HeartSurface& left, const FoundAxes& axes, const Points& fitted) {
  std::vector<bool> wall = axes.cap;
  wall.flip();
  const std::vector<bool> onCap = verticesOf(left.rest.rows(), left.triangles, wall);
  Vec3 base = Vec3::Zero();
  for (std::size_t i = 0; i < onCap.size(); ++i)
    if (const auto row = static_cast<Eigen::Index>(i); onCap[i])
      base += (fitted.row(row) - left.rest.row(row)).transpose();
  base /= static_cast<double>(std::max<std::ptrdiff_t>(1, std::count(onCap.begin(), onCap.end(), true)));
  Eigen::Index tip = 0;
  (left.rest.rowwise() - axes.axes.apex().transpose()).rowwise().squaredNorm().minCoeff(&tip);
  const Vec3 apex = (fitted.row(tip) - left.rest.row(tip)).transpose();
  return {axes.axes.base() + base, axes.axes.apex() + apex, axes.axes.towardsInsertion()};
}

/// Those that end at a valve's ring: the fit sees how wide a ring around the axis is.
const HeartContour* named(const HeartContours& contours, const HeartContour& like) {
  for (const auto* some : {&contours.longitudinal, &contours.reservoir})
    for (const HeartContour& contour : *some)
      if (contour.name == like.name && contour.surface.rest == like.surface.rest)
        return &contour;
  return contours.rightFreeWall && contours.rightFreeWall->name == like.name ? &*contours.rightFreeWall
                                                                             : nullptr;
}

} // namespace

SeenContours::SeenContours(const HeartSurfaces& rest, const FoundAxes& axes, const HeartPhases& phases,
                           Threads threads)
    : phases_(phases), surfaces_(phases.seen.size()), cut_(phases.seen.size()) {
  parallelRanges(static_cast<Eigen::Index>(cut_.size()), 1, threads, [&](Eigen::Index begin, Eigen::Index) {
    const auto phase = static_cast<std::size_t>(begin);
    const HeartAxes moved = movedAxes(*rest.left, axes, phases.left[phase]);
    surfaces_[phase] = withCaps(phases.seen[phase], moved);
    cut_[phase] = findContours(surfaces_[phase], moved, {});
  });
}

std::optional<std::vector<double>> SeenContours::lengthsOf(const HeartContour& contour) const {
  if (cut_.empty() || contour.listed)
    return std::nullopt;
  std::vector<double> lengths;
  for (std::size_t phase = 0; phase < cut_.size(); ++phase) {
    const HeartContour* found = named(cut_[phase], contour);
    if (!found)
      return std::nullopt;
    lengths.push_back(found->line.lengthAt((surfaces_[phase].*found->surface.rest)->rest));
    const double followed = contour.line.lengthAt((phases_.*contour.surface.phases)[phase]);
    if (std::abs(lengths.back() - followed) > kSameLine * followed)
      return std::nullopt;
  }
  return lengths;
}

} // namespace viscera::strain
