#include "implicit/tube.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "implicit/smooth_functions.h"

namespace viscera::sample_organs {
namespace {

using std::numbers::pi;

constexpr double kLumenEdgeScale = 0.45; // a wall of 2 mm wants shorter edges than the rest of an organ
constexpr double kLumenEdge = 1.0;       // mm; rounds the rim of a lumen ...
constexpr double kLumenCorner = 2.5;     // ... and the corner of its floor
// Beyond this many mm a relief's radial distance exceeds the true one by too much to be trusted.
constexpr double kReliefReach = 2.0;
// The constrictions are |sin| with its crease rounded: folds are sharper than pouches, but not edges.
constexpr double kCrease = 0.0036;
constexpr double kPouchPower = 0.3;

double pouch(double phase) {
  // ((sin^2 + c) / (1 + c))^0.3: |sin|^0.6, whose cusp at each constriction c rounds off; 1 in the middle of
  // a pouch.
  const double s = std::sin(pi * phase);
  return std::pow((s * s + kCrease) / (1 + kCrease), kPouchPower);
}

/// 1 between `from` and `to`, 0 outside, with slopes of `fade` mm inside.
double presence(double from, double to, double fade, double arc) {
  return std::min(smoothStep(from, from + fade, arc), 1 - smoothStep(to - fade, to, arc));
}

double foldedFactor(const Folds& f, double arc, double angle) {
  const double present = presence(f.from, f.to, f.wavelength, arc);
  if (present <= 0)
    return 1;
  // The noise runs on a circle round the tube, so that the folds close.
  const Vec3 place(1.5 * std::cos(angle), 1.5 * std::sin(angle), arc / f.wavelength);
  const double stray = f.wander * valueNoise(place, f.seed);
  const double strength = 0.6 + 0.4 * valueNoise(0.7 * place, f.seed + 1);
  // r / r_0 = 1 + depth cos(n angle + 2 pi stray), faded at the ends and uneven by noise.
  return 1 + present * strength * f.depth * std::cos(f.count * angle + 2 * pi * stray);
}

double haustralFactor(const Haustra& h, double arc, double angle) {
  const double present = presence(h.from, h.to, h.period, arc);
  if (present <= 0)
    return 1;
  // Between two taeniae r / r_0 = 1 - depth (1 - pouch), at one 1 - taeniaDepth; exp(-(a / width)^2) leads
  // from one to the other, a the angle from the nearest taenia.
  const double turn = angle / (2 * pi) - std::floor(angle / (2 * pi));
  const double row = std::floor(turn * h.taeniae);
  const double withinRow = turn * h.taeniae - row;
  const double fromTaenia = std::min(withinRow, 1 - withinRow) / h.taeniae * 2 * pi;
  const double taenia = std::exp(-std::pow(fromTaenia / h.taeniaWidth, 2));
  const double irregular =
      h.jitter * valueNoise({0.7 * arc / h.period + 17 * row, 7.3 * row, 0.5 * h.seed}, h.seed);
  const double phase = arc / h.period + h.stagger * row / h.taeniae + irregular;
  const double wall = 1 - h.depth * (1 - pouch(phase));
  const double factor = wall + taenia * (1 - h.taeniaDepth - wall);
  return 1 + (factor - 1) * present;
}

/// (I + (f - 1) n n^T) p
Vec3 scaledAlong(const Vec3& point, const Vec3& direction, double factor) {
  return point + (factor - 1) * point.dot(direction) * direction;
}

std::vector<AxisSample> roundAxis(std::vector<AxisPoint> points, const TubeShape& shape) {
  for (AxisPoint& point : points)
    point.position = scaledAlong(point.position, shape.flattenDirection, 1 / shape.flattenFactor);
  return sampleAxis(points, shape.step, -Vec3::UnitY());
}

Extent extentOf(const std::vector<AxisSample>& axis, const TubeShape& shape) {
  Extent extent;
  const double widest = std::max(1.0, shape.flattenFactor) * shape.relief.largestFactor();
  for (const AxisSample& sample : axis) {
    const Vec3 middle = scaledAlong(sample.position, shape.flattenDirection, shape.flattenFactor);
    extent.extend(grown(Extent(middle), widest * sample.radius + shape.beyond));
  }
  return extent;
}

class Tube final : public ImplicitNode {
public:
  Tube(std::vector<AxisSample> axis, const TubeShape& shape)
      : ImplicitNode(extentOf(axis, shape)), axis_(std::move(axis)), shape_(shape), tree_(axis_) {
    for (const AxisSample& sample : axis_)
      widest_ = std::max(widest_, sample.radius);
  }

  double distanceUpTo(const Vec3& world, double limit) const override {
    const Vec3 point = rounded(world);
    const NearestOnAxis nearest = tree_.nearest(point, searchLimit(limit));
    if (nearest.segment < 0)
      return limit;
    double result = shape_.relief.plain() ? nearest.distance : reliefDistance(point, nearest);
    const AxisSample& from = axis_[static_cast<std::size_t>(nearest.segment)];
    const AxisSample& to = axis_[static_cast<std::size_t>(nearest.segment) + 1];
    const double arc = from.arc + nearest.t * (to.arc - from.arc);
    for (int end = 0; end < 2; ++end)
      if (shape_.flatEnd[static_cast<std::size_t>(end)])
        result = cutFlat(end, point, arc, result);
    if (shape_.flattenFactor == 1)
      return result;
    return stretched(point - (from.position + nearest.t * (to.position - from.position)), result);
  }

private:
  Shade shadeUnfinished(const Vec3& point) const override {
    Shade shade{distance(point)};
    const Vec3 inside = rounded(point);
    if (isNearLumen(0, inside) || isNearLumen(1, inside))
      shade.edgeScale = kLumenEdgeScale;
    return shade;
  }

  bool isNearLumen(int end, const Vec3& point) const {
    const auto& lumen = shape_.lumen[static_cast<std::size_t>(end)];
    if (!lumen)
      return false;
    const AxisSample& last = end == 0 ? axis_.front() : axis_.back();
    const double margin = lumen->wall;
    return (point - last.position).norm() < std::hypot(last.radius, lumen->depth) + margin &&
           std::abs((point - last.position).dot(last.tangent)) < lumen->depth + margin;
  }

  Vec3 rounded(const Vec3& point) const {
    if (shape_.flattenFactor == 1)
      return point;
    return scaledAlong(point, shape_.flattenDirection, 1 / shape_.flattenFactor);
  }

  double searchLimit(double limit) const {
    const double swelling = (shape_.relief.largestFactor() - 1) * widest_;
    return std::max(limit, 0.0) / std::min(shape_.flattenFactor, 1.0) + swelling + shape_.beyond;
  }

  double reliefDistance(const Vec3& point, const NearestOnAxis& nearest) const {
    const AxisSample& from = axis_[static_cast<std::size_t>(nearest.segment)];
    const AxisSample& to = axis_[static_cast<std::size_t>(nearest.segment) + 1];
    const Vec3 away = point - (from.position + nearest.t * (to.position - from.position));
    const double radius = from.radius + nearest.t * (to.radius - from.radius);
    const double beyond = away.norm() - radius * shape_.relief.largestFactor();
    const double trusted = 1 - smoothStep(0, kReliefReach, beyond);
    if (trusted <= 0)
      return beyond;
    const Vec3 normal = from.normal + nearest.t * (to.normal - from.normal);
    const Vec3 binormal = from.binormal + nearest.t * (to.binormal - from.binormal);
    const double arc = from.arc + nearest.t * (to.arc - from.arc);
    const double angle = std::atan2(away.dot(binormal), away.dot(normal));
    // |a| - r factor(arc, angle) in the tube's own polar coordinates: zero on the wall, and near it the
    // distance but for the relief's slope.
    const double radial = away.norm() - radius * shape_.relief.factor(arc, angle);
    return beyond + trusted * (radial - beyond);
  }

  double cutFlat(int end, const Vec3& point, double arc, double distance) const {
    const AxisSample& last = end == 0 ? axis_.front() : axis_.back();
    const double fromEnd = end == 0 ? arc : axis_.back().arc - arc;
    if (fromEnd > 1.2 * last.radius + 1)
      return distance;
    const Vec3 outward = end == 0 ? Vec3(-last.tangent) : last.tangent;
    const double above = (point - last.position).dot(outward);
    const double radial = (point - last.position - above * outward).norm();
    // Beyond the end the tube goes on as a cylinder, which the plane then cuts.
    const double side = (above > 0 ? radial - last.radius : distance) + shape_.rim;
    const double top = above - shape_.beyond + shape_.rim;
    // The corner of the quarter plane side <= 0, top <= 0, rounded: both are moved inwards by the rim before,
    // and d = |max(., 0)| + min(max(side, top), 0) - rim moves them out again.
    const double outside = std::hypot(std::max(side, 0.0), std::max(top, 0.0));
    double result = std::min(std::max(side, top), 0.0) + outside - shape_.rim;
    if (const auto& lumen = shape_.lumen[static_cast<std::size_t>(end)]) {
      // The hole is what is within the wall and above the floor, and -hole is taken from the tube:
      // max(d, -hole).
      const double hole =
          smoothMax(radial - (last.radius - lumen->wall), -(above + lumen->depth), kLumenCorner);
      result = smoothMax(result, -hole, kLumenEdge);
    }
    return result;
  }

  double stretched(const Vec3& away, double distance) const {
    const double factor = shape_.flattenFactor;
    const double length2 = away.squaredNorm();
    if (length2 <= 0)
      return distance * factor;
    // Let F = I + (f - 1) n n^T: the stretched field is d(F^-1 p), whose gradient F^-T a is
    // sqrt(1 - (a.n)^2 + (a.n)^2 / f^2) long for the unit vector a away from the axis: d / |grad d| to first
    // order.
    const double along2 = std::pow(away.dot(shape_.flattenDirection), 2) / length2;
    return distance / std::sqrt(1 - along2 + along2 / (factor * factor));
  }

  std::vector<AxisSample> axis_; ///< In the space where the tube is round.
  TubeShape shape_;
  SegmentTree tree_;
  double widest_ = 0; ///< Largest radius of the axis, mm.
};

} // namespace

double TubeRelief::factor(double arc, double angle) const {
  double result = 1;
  if (waves)
    result *= 1 + waves->amplitude * std::sin(2 * pi * (arc / waves->period + waves->phase));
  if (haustra)
    result *= haustralFactor(*haustra, arc, angle);
  if (folds)
    result *= foldedFactor(*folds, arc, angle);
  return result;
}

NewNode makeTube(std::vector<AxisPoint> points, const TubeShape& shape) {
  return std::make_shared<Tube>(roundAxis(std::move(points), shape), shape);
}

} // namespace viscera::sample_organs
