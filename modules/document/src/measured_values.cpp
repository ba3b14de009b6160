#include "viscera/document/measured_values.h"

#include <cmath>
#include <limits>
#include <utility>

#include "viscera/document/document.h"
#include "viscera/document/scan_item.h"

namespace viscera::document {
namespace {

constexpr double kDegreesPerRadian = 180 / M_PI;

/// The mean, or NaN where nothing was measured.
double meanOf(const std::optional<medical_io::RegionStatistics>& region) {
  return region && region->count > 0 ? region->mean : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

Vec3 placeNow(const MeasuredPoint& point, const DocumentState& state, const PointsOf& pointsOf,
              const TissueMotion& tissue) {
  if (!point.organ)
    return tissue ? tissue(point.rest) : point.rest;
  const auto organ = state.organ(point.organ);
  if (!organ)
    return point.rest;
  const Points& points = pointsOf(point.organ);
  Vec3 place = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    place += point.weights[k] * points.row(organ->mesh->triangles(point.triangle, k)).transpose();
  return place;
}

std::vector<Vec3> placesNow(const Measurement& measurement, const DocumentState& state,
                            const PointsOf& pointsOf, const TissueMotion& tissue) {
  std::vector<Vec3> places;
  for (const MeasuredPoint& point : measurement.points)
    if (!tissue || !isRegion(measurement.kind) || places.empty())
      places.push_back(placeNow(point, state, pointsOf, tissue));
    else
      places.push_back(places.front() + (point.rest - measurement.points.front().rest));
  return places;
}

std::optional<medical_io::RegionStatistics> MeasuringMemory::of(const Measurement& measurement,
                                                                const DocumentState& state) {
  const auto region = regionOf(measurement);
  if (!region || !state.scan)
    return std::nullopt;
  const auto known = kept_.find(measurement.id);
  if (known != kept_.end() && known->second.scan == state.scan->scan) {
    Measurement renamed = known->second.measurement;
    renamed.name = measurement.name;
    if (renamed == measurement)
      return known->second.statistics;
  }
  const medical_io::RegionStatistics statistics = medical_io::statisticsOf(*state.scan->scan, *region);
  kept_[measurement.id] = {measurement, state.scan->scan, statistics};
  return statistics;
}

/// The arranged surface of an organ, in the place of these points. Nothing is done where it is there already:
/// comparing is faster than fitting boxes.
const geometry::SurfaceBoxes& MeasuringMemory::follow(const Organ& organ, const Points& points) {
  Follower& follower = followers_[organ.id];
  if (follower.mesh != organ.mesh)
    follower = {organ.mesh, organ.mesh->points,
                std::make_unique<geometry::SurfaceBoxes>(organ.mesh->points, organ.mesh->triangles)};
  if (follower.points != points) {
    follower.points = points;
    follower.boxes->follow(points);
  }
  return *follower.boxes;
}

std::optional<MeasuringMemory::Gap>
MeasuringMemory::gapOf(const Measurement& measurement, const DocumentState& state, const PointsOf& pointsOf) {
  const auto from = state.organ(measurement.points.at(0).organ);
  const auto to = state.organ(measurement.points.at(1).organ);
  if (!from || !to)
    return std::nullopt;
  KeptGap& kept = gaps_[measurement.id];
  if (kept.from != from->mesh || kept.to != to->mesh) {
    kept.last = geometry::gapBetween(follow(*from, from->mesh->points), follow(*to, to->mesh->points));
    kept = {from->mesh, to->mesh, kept.last.mm, kept.last};
  }
  kept.last =
      geometry::gapBetween(follow(*from, pointsOf(from->id)), follow(*to, pointsOf(to->id)), kept.last);
  return Gap{kept.restMm, kept.last};
}

double measuredValue(const std::vector<Vec3>& places) {
  if (places.size() == 2)
    return (places[1] - places[0]).norm();
  const Vec3 a = places.at(0) - places.at(1);
  const Vec3 b = places.at(2) - places.at(1);
  // Exact to rounding also near 0 and 180 degrees, where the arc cosine is not.
  return kDegreesPerRadian * std::atan2(a.cross(b).norm(), a.dot(b));
}

MeasuredValues measure(const Measurement& measurement, const DocumentState& state, const PointsOf& pointsOf,
                       MeasuringMemory* memory, const TissueMotion& tissue) {
  MeasuredValues values;
  values.places = placesNow(measurement, state, pointsOf, tissue);
  std::vector<Vec3> rest;
  for (const MeasuredPoint& point : measurement.points)
    rest.push_back(point.rest);
  MeasuringMemory none;
  if (isRegion(measurement.kind)) {
    values.region = (memory ? *memory : none).of(measurement, state);
    values.rest = values.now = meanOf(values.region);
    return values;
  }
  if (measurement.kind == MeasurementKind::gap)
    if (const auto gap = (memory ? *memory : none).gapOf(measurement, state, pointsOf)) {
      values.rest = gap->restMm;
      values.now = gap->now.mm;
      values.places = {gap->now.from, gap->now.to};
      return values;
    }
  values.rest = measuredValue(rest);
  values.now = measuredValue(values.places);
  return values;
}

std::optional<medical_io::Region> regionOf(const Measurement& measurement) {
  if (!isRegion(measurement.kind))
    return std::nullopt;
  const Vec3 first = measurement.points.at(0).rest, second = measurement.points.at(1).rest;
  if (measurement.kind == MeasurementKind::sphere)
    return medical_io::SphereRegion{first, (second - first).norm()};
  const Eigen::Index along = (measurement.axis + 1) % 3, across = (measurement.axis + 2) % 3;
  return medical_io::RectangleRegion{first, (second - first)[along] * Vec3::Unit(along),
                                     (second - first)[across] * Vec3::Unit(across)};
}

std::string unitOf(const Measurement& measurement, const DocumentState& state) {
  if (isRegion(measurement.kind))
    return state.scan ? state.scan->scan->unit : std::string();
  return isLength(measurement.kind) ? "mm" : "deg";
}

} // namespace viscera::document
