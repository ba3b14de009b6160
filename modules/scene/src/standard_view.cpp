#include "standard_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::scene {
namespace {

constexpr std::array<std::pair<StandardView, const char*>, 6> kViewNames = {
    {{StandardView::anterior, "anterior"},
     {StandardView::posterior, "posterior"},
     {StandardView::left, "left"},
     {StandardView::right, "right"},
     {StandardView::superior, "superior"},
     {StandardView::inferior, "inferior"}}};

} // namespace

StandardView standardViewFromName(const std::string& name) {
  for (const auto& [view, text] : kViewNames)
    if (name == text)
      return view;
  throw UsageError(misuse("there is no view of this name"), name,
                   misuse("use anterior, posterior, left, right, superior or inferior"));
}

std::string nameOf(StandardView view) {
  for (const auto& [named, text] : kViewNames)
    if (named == view)
      return text;
  return {};
}

ViewDirections directionsOf(StandardView view) {
  const Vec3 toLeft = Vec3::UnitX(), toBack = Vec3::UnitY(), toHead = Vec3::UnitZ();
  switch (view) {
  case StandardView::anterior:
    return {toBack, toHead};
  case StandardView::posterior:
    return {-toBack, toHead};
  case StandardView::left:
    return {-toLeft, toHead};
  case StandardView::right:
    return {toLeft, toHead};
  case StandardView::superior:
    return {-toHead, -toBack};
  case StandardView::inferior:
    return {toHead, -toBack};
  }
  return {toBack, toHead};
}

namespace {

/// Calls `use(height, depth)` for every corner of a box, seen from its middle: how much of the picture's half
/// height it needs (its half width counted by the aspect), and how much farther than the middle it is.
template <typename Use>
void forCorners(const Bounds& bounds, const ViewDirections& directions, double aspect, const Use& use) {
  const Vec3 right = directions.forward.cross(directions.up);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 point(corner & 1 ? bounds.high.x() : bounds.low.x(),
                     corner & 2 ? bounds.high.y() : bounds.low.y(),
                     corner & 4 ? bounds.high.z() : bounds.low.z());
    const Vec3 fromCenter = point - bounds.center();
    use(std::max(std::abs(fromCenter.dot(directions.up)), std::abs(fromCenter.dot(right)) / aspect),
        fromCenter.dot(directions.forward));
  }
}

} // namespace

double framingDistance(const Bounds& bounds, const ViewDirections& directions, double tangent, double aspect,
                       double margin) {
  double distance = 0;
  forCorners(bounds, directions, aspect, [&](double height, double depth) {
    // (distance + depth) tan >= margin height for every corner.
    distance = std::max(distance, margin * height / tangent - depth);
  });
  return distance;
}

double framingScale(const Bounds& bounds, const ViewDirections& directions, double aspect, double margin) {
  double scale = 0;
  forCorners(bounds, directions, aspect,
             [&](double height, double) { scale = std::max(scale, margin * height); });
  return scale;
}

} // namespace viscera::scene
