#include "implicit/tube_axis.h"

#include <algorithm>
#include <utility>

namespace viscera::sample_organs {
namespace {

constexpr double kTiny = 1e-9;     // mm; keeps quotients finite where two points coincide
constexpr double kParallel = 1e-3; // below this a direction is too near the tangent to be a normal

constexpr int kLeafSize = 6;
constexpr double kSteepest = 0.9;  // radius per mm of axis; a ball that swallows its neighbour has no cone
constexpr double kShortest = 1e-9; // mm

/// Weights of a cubic Hermite segment at t: value and slope at its start, value and slope at its end.
struct Hermite {
  explicit Hermite(double t)
      : v0((2 * t - 3) * t * t + 1), s0(((t - 2) * t + 1) * t), v1((3 - 2 * t) * t * t), s1((t - 1) * t * t) {
  }
  double v0, s0, v1, s1;
};

double knotInterval(const Vec3& a, const Vec3& b) {
  return std::sqrt((b - a).norm()) + kTiny;
}

/// The harmonic mean, 0 at a turn: radii rise and fall where the given ones do, and never beyond them.
double limitedSlope(double before, double after) {
  return before * after <= 0 ? 0.0 : 2 * before * after / (before + after);
}

/// One piece of the spline, between two given points.
class Piece {
public:
  Piece(const std::vector<AxisPoint>& points, std::size_t i) : from_(points[i]), to_(points[i + 1]) {
    const bool first = i == 0, last = i + 2 == points.size();
    const Vec3 before = first ? Vec3(2 * from_.position - to_.position) : points[i - 1].position;
    const Vec3 after = last ? Vec3(2 * to_.position - from_.position) : points[i + 2].position;
    const double a = knotInterval(before, from_.position);
    const double b = knotInterval(from_.position, to_.position);
    const double c = knotInterval(to_.position, after);
    // Catmull and Rom's slopes over the knots before, from, to and after, a, b and c apart, times b for the
    // parameter 0 to 1: b ((p_1 - p_0) / a - (p_2 - p_0) / (a + b) + (p_2 - p_1) / b), and likewise at the
    // other end.
    const Vec3 chord = (to_.position - from_.position) / b;
    fromSlope_ = b * ((from_.position - before) / a - (to_.position - before) / (a + b) + chord);
    toSlope_ = b * (chord - (after - from_.position) / (b + c) + (after - to_.position) / c);
    const double rise = to_.radius - from_.radius;
    fromRise_ = first ? rise : limitedSlope(from_.radius - points[i - 1].radius, rise);
    toRise_ = last ? rise : limitedSlope(rise, points[i + 2].radius - to_.radius);
  }

  AxisPoint at(double t) const {
    const Hermite w(t);
    return {w.v0 * from_.position + w.s0 * fromSlope_ + w.v1 * to_.position + w.s1 * toSlope_,
            w.v0 * from_.radius + w.s0 * fromRise_ + w.v1 * to_.radius + w.s1 * toRise_};
  }

private:
  AxisPoint from_, to_;
  Vec3 fromSlope_, toSlope_;
  double fromRise_ = 0, toRise_ = 0;
};

std::vector<AxisSample> samplePositions(const std::vector<AxisPoint>& points, double step) {
  std::vector<AxisSample> samples;
  const auto add = [&](const AxisPoint& point) {
    AxisSample sample;
    sample.position = point.position;
    sample.radius = point.radius;
    if (!samples.empty())
      sample.arc = samples.back().arc + (point.position - samples.back().position).norm();
    samples.push_back(sample);
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Piece piece(points, i);
    const double chord = (points[i + 1].position - points[i].position).norm();
    const int count = std::max(2, static_cast<int>(std::ceil(chord / step)));
    for (int k = 0; k < count; ++k)
      add(piece.at(static_cast<double>(k) / count));
  }
  add(points.back());
  return samples;
}

} // namespace

std::vector<AxisSample> sampleAxis(const std::vector<AxisPoint>& points, double step,
                                   const Vec3& firstNormal) {
  std::vector<AxisSample> samples = samplePositions(points, step);
  const std::size_t last = samples.size() - 1;
  for (std::size_t i = 0; i <= last; ++i)
    samples[i].tangent =
        (samples[std::min(i + 1, last)].position - samples[i == 0 ? 0 : i - 1].position).normalized();

  const Vec3& start = samples.front().tangent;
  Vec3 normal = firstNormal - firstNormal.dot(start) * start;
  if (normal.norm() < kParallel * firstNormal.norm())
    normal = start.unitOrthogonal();
  // n less its part along the tangent: the frame turns only as far as the axis bends.
  for (AxisSample& sample : samples) {
    normal = (normal - normal.dot(sample.tangent) * sample.tangent).normalized();
    sample.normal = normal;
    sample.binormal = sample.tangent.cross(normal);
  }
  return samples;
}

SegmentTree::SegmentTree(const std::vector<AxisSample>& samples) {
  std::vector<RoundCone> cones;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const AxisSample &from = samples[i], &to = samples[i + 1];
    RoundCone cone;
    cone.segment = static_cast<int>(i);
    cone.start = from.position;
    cone.length = std::max((to.position - from.position).norm(), kShortest);
    cone.direction = (to.position - from.position) / cone.length;
    cone.radius = from.radius;
    cone.rise = to.radius - from.radius;
    // Let k = rise / length: sqrt(away^2 + (along - x)^2) - (r + k x) is least at
    // x = along + away k / sqrt(1 - k^2): the foot is shifted towards the wide end.
    const double slope = std::clamp(cone.rise / cone.length, -kSteepest, kSteepest);
    cone.shift = slope / std::sqrt(1 - slope * slope);
    cones.push_back(cone);
  }
  const auto summarise = [&cones](std::span<const int> items, Vec3& sides) {
    const Reach reach = reachOf(cones, items);
    sides = reach.box.sizes();
    return reach;
  };
  // Along space, not along the tube: the loops of a bowel lie side by side.
  const auto before = [&cones](int a, int b, Eigen::Index axis) {
    return std::pair(cones[static_cast<std::size_t>(a)].start[axis], a) <
           std::pair(cones[static_cast<std::size_t>(b)].start[axis], b);
  };
  reaches_ = geometry::MedianTree<Reach>(static_cast<int>(cones.size()), kLeafSize, summarise, before);
  for (const int segment : reaches_.order())
    cones_.push_back(cones[static_cast<std::size_t>(segment)]);
}

SegmentTree::Reach SegmentTree::reachOf(const std::vector<RoundCone>& cones, std::span<const int> items) {
  Reach reach;
  for (const int segment : items) {
    const RoundCone& cone = cones[static_cast<std::size_t>(segment)];
    reach.box.extend(cone.start);
    reach.box.extend(Vec3(cone.start + cone.length * cone.direction));
    reach.radius = std::max({reach.radius, cone.radius, cone.radius + cone.rise});
  }
  return reach;
}

void SegmentTree::searchLeaf(int begin, int end, const Vec3& point, NearestOnAxis& best) const {
  for (int i = begin; i < end; ++i) {
    const RoundCone& cone = cones_[static_cast<std::size_t>(i)];
    const Vec3 offset = point - cone.start;
    const double along = offset.dot(cone.direction);
    const double away2 = std::max(offset.squaredNorm() - along * along, 0.0);
    const double t = std::clamp((along + std::sqrt(away2) * cone.shift) / cone.length, 0.0, 1.0);
    const double side = along - t * cone.length;
    const double distance = std::sqrt(away2 + side * side) - (cone.radius + t * cone.rise);
    if (distance < best.distance)
      best = {cone.segment, t, distance};
  }
}

NearestOnAxis SegmentTree::nearest(const Vec3& point, double limit) const {
  NearestOnAxis best{-1, 0, limit};
  reaches_.searchNearestFirst([&point](const Reach& reach) { return distance2(reach.box, point); },
                              [&best](const Reach& reach, double axisDistance2) {
                                return isFarther(reach, axisDistance2, best.distance);
                              },
                              [&](int begin, int end) { searchLeaf(begin, end, point, best); });
  return best;
}

} // namespace viscera::sample_organs
