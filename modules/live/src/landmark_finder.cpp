#include "landmark_finder.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/tube_axis.h"
#include "viscera/heart/heart_fit.h"
#include "viscera/sequences/stomach_fit.h"

namespace viscera::live {
namespace {

/// Parts of the organ's diagonal: a landmark may lie that far outside the surface, and two of them that
/// near to each other.
constexpr double kOutside = 0.1;
constexpr double kAtOnePlace = 0.05;

/// Points of the centreline that are kept: enough for its bends, few enough to be smooth.
constexpr int kLinePoints = 15;
constexpr int kSmoothings = 3;
/// Part of the organ's diagonal: points of the line lie that deep inside where there is room.
constexpr double kLeastLineDepth = 0.02;

/// Part of the length: the line leads at least that far beyond the pylorus, so that rings fit around it.
constexpr double kBeyondPylorus = 0.035;

Text millimeters(double mm) {
  return phrase("%1 mm", inDigits(mm));
}

std::vector<double> arcsOf(const std::vector<Vec3>& points) {
  std::vector<double> arcs{0};
  for (std::size_t i = 1; i < points.size(); ++i)
    arcs.push_back(arcs.back() + (points[i] - points[i - 1]).norm());
  return arcs;
}

void smooth(std::vector<Vec3>& points) {
  for (int round = 0; round < kSmoothings; ++round) {
    const std::vector<Vec3> before = points;
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
      points[i] = 0.25 * before[i - 1] + 0.5 * before[i] + 0.25 * before[i + 1];
  }
}

Vec3 alongLine(const std::vector<Vec3>& points, const std::vector<double>& arcs, double s) {
  const auto after = std::upper_bound(arcs.begin() + 1, arcs.end() - 1, s);
  const auto i = static_cast<std::size_t>(after - arcs.begin());
  const double part = std::clamp((s - arcs[i - 1]) / (arcs[i] - arcs[i - 1]), 0.0, 1.0);
  return (1 - part) * points[i - 1] + part * points[i];
}

} // namespace

LandmarkFinder::LandmarkFinder(std::string sequence, const document::Organ& organ)
    : sequence_(std::move(sequence)), name_(organ.name), mesh_(organ.mesh),
      size_(boundsOf(organ.mesh->points).diagonal()) {
  const geometry::SurfaceReport report = geometry::checkSurface(*mesh_);
  if (!report.closed())
    throw DataError(
        phrase("the organ is open: %n boundary {edge|edges}", report.boundaryEdges), named(name_),
        "close its holes, as viscera convert IN OUT --fill-holes does; an open surface has no volume to "
        "keep");
  if (report.components != 1)
    throw DataError(phrase("the organ is in %1 pieces", report.components), named(name_),
                    "keep the largest, as viscera convert IN OUT --keep-largest does");
  if (!report.outward())
    throw DataError("the organ is inside out or flat", named(name_),
                    "turn its triangles around, as viscera convert IN OUT --orient does");
  distance_ = std::make_shared<geometry::SignedDistance>(mesh_);
}

Landmarks LandmarkFinder::complete(const Landmarks& given) const {
  const std::vector<LandmarkRole>& roles = landmarkRoles(sequence_);
  for (const Landmark& landmark : given.points) {
    if (std::none_of(roles.begin(), roles.end(),
                     [&](const LandmarkRole& role) { return role.role == landmark.role; }))
      throw UsageError(misuse("\"%1\" is not a landmark of the sequence %2", landmark.role, sequence_),
                       named(name_));
    requireNear(landmark);
  }
  if (sequence_ == "heartbeat")
    return heart(given);
  return sequence_ == "peristalsis" ? stomach(given) : given;
}

void LandmarkFinder::requireNear(const Landmark& landmark) const {
  if (!landmark.position.allFinite())
    throw DataError("the landmark's position is not a finite number",
                    phrase("%1, %2", named(name_), named(landmark.role)));
  const double outside = depth(landmark.position);
  if (outside > kOutside * size_)
    throw DataError(phrase("the landmark lies %1 outside the organ", millimeters(outside)),
                    phrase("%1, %2", named(name_), named(landmark.role)),
                    "choose it on the organ; check the axes (RAS or LPS) too");
}

void LandmarkFinder::requireBothOrNone(const Landmarks& given, const std::string& one,
                                       const std::string& other) const {
  const bool first = given.find(one) != nullptr;
  const bool second = given.find(other) != nullptr;
  if (first != second)
    throw DataError(
        phrase("too few landmarks: there is %1 but no %2", first ? one : other, first ? other : one),
        named(name_), "give both, or none to have them computed");
}

void LandmarkFinder::requireApart(const Landmark& one, const Landmark& other) const {
  const double distance = (one.position - other.position).norm();
  if (distance < kAtOnePlace * size_)
    throw DataError(
        phrase("%1 and %2 are at one place: %3 from each other", one.role, other.role, millimeters(distance)),
        named(name_), "choose the two ends of the organ");
}

Landmarks LandmarkFinder::heart(Landmarks landmarks) const {
  requireBothOrNone(landmarks, "apex", "base");
  if (landmarks.find("right") && !landmarks.find("apex"))
    throw DataError("too few landmarks: there is right but neither apex nor base", named(name_),
                    "give apex and base too");
  if (landmarks.find("apex"))
    requireApart(*landmarks.find("apex"), *landmarks.find("base"));
  if (landmarks.find("right"))
    return landmarks;
  const heart::HeartLandmarks found =
      heart::estimateHeartLandmarks([this](const Vec3& p) { return depth(p); }, boundsOf(mesh_->points));
  if (landmarks.find("apex")) {
    // The side is asked for around the axis that is given.
    const Vec3 base = landmarks.find("base")->position;
    const Vec3 axis = (landmarks.find("apex")->position - base).normalized();
    Vec3 side = found.right - base;
    side -= side.dot(axis) * axis;
    const double reach = kAtOnePlace * size_;
    if (side.norm() < reach)
      side = axis.unitOrthogonal() * reach;
    landmarks.points.push_back({"right", base + side, true});
    return landmarks;
  }
  landmarks.points.push_back({"apex", found.apex, true});
  landmarks.points.push_back({"base", found.base, true});
  landmarks.points.push_back({"right", found.right, true});
  return landmarks;
}

int LandmarkFinder::vertexNear(const Vec3& point) const {
  Eigen::Index vertex = 0;
  (mesh_->points.rowwise() - point.transpose()).rowwise().squaredNorm().minCoeff(&vertex);
  return static_cast<int>(vertex);
}

Landmarks LandmarkFinder::stomach(Landmarks landmarks) const {
  requireBothOrNone(landmarks, "fundus", "pylorus");
  for (const char* role : {"centreline", "body"})
    if (landmarks.find(role) && !landmarks.find("fundus"))
      throw DataError(phrase("too few landmarks: there is %1 but neither fundus nor pylorus", role),
                      named(name_), "give fundus and pylorus too");
  if (landmarks.find("fundus"))
    requireApart(*landmarks.find("fundus"), *landmarks.find("pylorus"));
  for (const Vec3& place : landmarks.all("centreline"))
    if (depth(place) >= 0)
      throw DataError(
          phrase("a point of the centreline lies %1 outside the organ", millimeters(depth(place))),
          named(name_), "put it into the middle of the stomach");
  if (!landmarks.find("centreline"))
    addCenterline(landmarks);
  return landmarks;
}

Vec3 LandmarkFinder::drawnInside(const Vec3& place) const {
  const double deep = kLeastLineDepth * size_;
  if (depth(place) < -deep)
    return place;
  const Vec3 wall = distance_->nearest(place);
  const Vec3 away = (depth(place) < 0 ? Vec3(place - wall) : Vec3(wall - place)).stableNormalized();
  // Go at most as deep as the organ is thick there.
  for (double step = deep; step > 0.1 * deep; step *= 0.7)
    if (depth(wall + step * away) < -0.7 * step)
      return wall + step * away;
  if (depth(place) >= 0)
    throw DataError("the computed centreline leaves the organ", named(name_),
                    "give points of the centreline yourself");
  return place;
}

void LandmarkFinder::addCenterline(Landmarks& landmarks) const {
  geometry::TubeEnds ends;
  if (const Landmark* fundus = landmarks.find("fundus")) {
    ends.wide = vertexNear(fundus->position);
    ends.narrow = geometry::tipBeyond(*mesh_, vertexNear(landmarks.find("pylorus")->position), ends.wide);
  } else {
    ends = geometry::tubeEnds(*mesh_);
  }
  geometry::TubeAxis axis = geometry::tubeAxis(*mesh_, ends.wide, ends.narrow);
  smooth(axis.points);
  const std::vector<double> arcs = arcsOf(axis.points);
  if (!landmarks.find("fundus")) {
    landmarks.points.push_back({"fundus", axis.points.front(), true});
    const double pylorus = sequences::pylorusAlong(arcs, axis.areas);
    landmarks.points.push_back({"pylorus", alongLine(axis.points, arcs, pylorus), true});
  }
  for (int k = 1; k <= kLinePoints; ++k) {
    const Vec3 place = alongLine(axis.points, arcs, k * arcs.back() / (kLinePoints + 0.5));
    landmarks.points.push_back({"centreline", drawnInside(place), true});
  }
}

StomachLine stomachLine(const Landmarks& landmarks, const std::string& where) {
  StomachLine line;
  line.points.push_back(landmarks.find("fundus")->position);
  for (const Vec3& place : landmarks.all("centreline"))
    line.points.push_back(place);
  const Vec3 pylorus = landmarks.find("pylorus")->position;
  const Vec3 last = line.points.back();
  const Vec3 onwards =
      line.points.size() > 1 ? Vec3(last - line.points[line.points.size() - 2]) : Vec3(pylorus - last);
  if ((pylorus - last).dot(onwards) > 0 && (pylorus - last).norm() > 0.1 * onwards.norm())
    line.points.push_back(pylorus);
  const sequences::Centerline whole(line.points);
  line.pylorus = std::min(whole.nearest(pylorus), (1 - kBeyondPylorus) * whole.length());
  const Landmark* body = landmarks.find("body");
  line.midBody = body ? whole.nearest(body->position) : sequences::kStandardMidBody * line.pylorus;
  if (!(line.midBody > 0.15 * line.pylorus && line.midBody < 0.8 * line.pylorus))
    throw DataError("the landmarks are not in order along the stomach", where,
                    "fundus, centreline from the fundus down, body in between, pylorus");
  return line;
}

} // namespace viscera::live
