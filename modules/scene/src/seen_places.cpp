#include "seen_places.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace viscera::scene {
namespace {

constexpr double kCellPixels = 16;

std::size_t cellAlong(double pixels, std::size_t cells) {
  return std::min(static_cast<std::size_t>(std::max(0.0, pixels) / kCellPixels), cells - 1);
}

std::size_t cellsAlong(double pixels) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(pixels / kCellPixels)));
}

} // namespace

SeenPlaces::SeenPlaces(const ViewGeometry& view, std::vector<ScreenPlace> places)
    : view_(view), places_(std::move(places)), seen_(places_.size()), columns_(cellsAlong(2 * view.centerX)),
      rows_(cellsAlong(view.pixelHeight)), inCell_(columns_ * rows_) {
  for (std::size_t i = 0; i < places_.size(); ++i)
    inCell_[cellAlong(places_[i].y, rows_) * columns_ + cellAlong(places_[i].x, columns_)].push_back(i);
}

void SeenPlaces::look(const OrganActor& organ) {
  const Points& points = organ.points();
  std::vector<Corner> corners(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Vec3 point = points.row(i).transpose();
    const DisplayPoint place = view_.project(point);
    corners[static_cast<std::size_t>(i)] = {place.x, place.y, place.depth, organ.cutsAway(point)};
  }
  std::vector<Seen> own(places_.size());
  const Triangles& triangles = organ.mesh().triangles;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const auto corner = [&](int k) -> const Corner& {
      return corners[static_cast<std::size_t>(triangles(t, k))];
    };
    const Corner &a = corner(0), &b = corner(1), &c = corner(2);
    if ((a.away && b.away && c.away) || !(a.depth > 0) || !(b.depth > 0) || !(c.depth > 0))
      continue;
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [bottom, top] = std::minmax({a.y, b.y, c.y});
    if (!(right >= 0) || !(top >= 0))
      continue;
    for (std::size_t row = cellAlong(bottom, rows_); row <= cellAlong(top, rows_); ++row)
      for (std::size_t column = cellAlong(left, columns_); column <= cellAlong(right, columns_); ++column)
        for (const std::size_t place : inCell_[row * columns_ + column])
          meet(organ, a, b, c, place, own[place]);
  }
  for (std::size_t place = 0; place < own.size(); ++place) {
    if (own[place].isFace())
      own[place].depth = faceDepth(organ, places_[place]);
    if (own[place].depth < seen_[place].depth)
      seen_[place] = own[place];
  }
}

/// The plane's distance along a line of sight, along which the height over it is linear.
double SeenPlaces::faceDepth(const OrganActor& organ, const ScreenPlace& place) const {
  const double near = organ.behindCut(view_.unproject(place.x, place.y, 1));
  const double far = organ.behindCut(view_.unproject(place.x, place.y, 2));
  return 1 - near / (far - near);
}

void SeenPlaces::meet(const OrganActor& organ, const Corner& a, const Corner& b, const Corner& c,
                      std::size_t place, Seen& seen) const {
  const auto [x, y] = places_[place];
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  const double ofB = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area;
  const double ofC = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
  const double ofA = 1 - ofB - ofC;
  if (!(ofA >= 0) || !(ofB >= 0) || !(ofC >= 0))
    return;
  // What is linear on the display is the depth of a parallel projection, and one by the depth of another.
  const double depth = view_.parallel ? ofA * a.depth + ofB * b.depth + ofC * c.depth
                                      : 1 / (ofA / a.depth + ofB / b.depth + ofC / c.depth);
  const bool partlyAway = a.away || b.away || c.away;
  if (depth < seen.depth && !(partlyAway && organ.cutsAway(view_.unproject(x, y, depth))))
    seen = {depth, &organ, area < 0};
}

} // namespace viscera::scene
