#include "viscera/sequences/centerline.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::sequences {
namespace {

constexpr double kSample = 1; ///< Between samples of the curve, mm.

void requireLine(const std::vector<Vec3>& points) {
  if (points.size() < 2)
    throw DataError("a centreline needs at least two points", "centreline");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Text where = phrase("centreline point %1", i + 1);
    if (!points[i].allFinite())
      throw DataError("the point is not finite", where);
    if (i > 0 && (points[i] - points[i - 1]).norm() < 1e-3 * kSample)
      throw DataError("the point is where the one before it is", where, "remove it");
  }
}

/// The point of the span between b and c at `t` in [0, 1], by Barry and Goldman's pyramid with knots at the
/// square roots of the distances: no loops and no overshoot where points are uneven.
Vec3 catmullRom(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double t) {
  // The knots are -|ab|^1/2, 0, |bc|^1/2 and |bc|^1/2 + |cd|^1/2: centripetal. Each `mix` is the line through
  // two points of the level before, over the knots that these two span.
  const double ab = std::sqrt((b - a).norm());
  const double bc = std::sqrt((c - b).norm());
  const double cd = std::sqrt((d - c).norm());
  const double x = t * bc;
  const auto mix = [](const Vec3& from, const Vec3& to, double part) {
    return Vec3((1 - part) * from + part * to);
  };
  const Vec3 first = mix(a, b, (x + ab) / ab);
  const Vec3 second = mix(b, c, x / bc);
  const Vec3 third = mix(c, d, (x - bc) / cd);
  const Vec3 left = mix(first, second, (x + ab) / (ab + bc));
  const Vec3 right = mix(second, third, x / (bc + cd));
  return mix(left, right, x / bc);
}

std::vector<Vec3> sampled(const std::vector<Vec3>& points) {
  const std::size_t last = points.size() - 1;
  const auto point = [&](std::ptrdiff_t i) -> Vec3 {
    if (i < 0)
      return 2 * points[0] - points[1];
    if (i > static_cast<std::ptrdiff_t>(last))
      return 2 * points[last] - points[last - 1];
    return points[static_cast<std::size_t>(i)];
  };
  std::vector<Vec3> samples;
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(last); ++i) {
    const int steps = std::max(1, static_cast<int>(std::ceil((point(i + 1) - point(i)).norm() / kSample)));
    for (int k = 0; k < steps; ++k)
      samples.push_back(
          catmullRom(point(i - 1), point(i), point(i + 1), point(i + 2), static_cast<double>(k) / steps));
  }
  samples.push_back(points.back());
  return samples;
}

} // namespace

Vec3 CrossSection::across(double angle) const {
  return std::cos(angle) * u + std::sin(angle) * v;
}

Centerline::Centerline(const std::vector<Vec3>& points) {
  requireLine(points);
  const std::vector<Vec3> samples = sampled(points);
  Vec3 u = (samples[1] - samples[0]).unitOrthogonal();
  double arc = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i > 0)
      arc += (samples[i] - samples[i - 1]).norm();
    const Vec3 before = samples[i > 0 ? i - 1 : 0];
    const Vec3 after = samples[std::min(i + 1, samples.size() - 1)];
    CrossSection section;
    section.center = samples[i];
    section.tangent = (after - before).normalized();
    // u less its part along the tangent: a frame that turns with the line only as far as the line bends.
    u = (u - u.dot(section.tangent) * section.tangent).normalized();
    section.u = u;
    section.v = section.tangent.cross(u);
    arcs_.push_back(arc);
    sections_.push_back(section);
  }
}

CrossSection Centerline::at(double s) const {
  s = std::clamp(s, 0.0, length());
  const auto after = std::upper_bound(arcs_.begin() + 1, arcs_.end() - 1, s);
  const auto i = static_cast<std::size_t>(after - arcs_.begin());
  const double part = (s - arcs_[i - 1]) / (arcs_[i] - arcs_[i - 1]);
  const CrossSection& a = sections_[i - 1];
  const CrossSection& b = sections_[i];
  CrossSection section;
  section.center = (1 - part) * a.center + part * b.center;
  section.tangent = ((1 - part) * a.tangent + part * b.tangent).normalized();
  section.u = (1 - part) * a.u + part * b.u;
  section.u = (section.u - section.u.dot(section.tangent) * section.tangent).normalized();
  section.v = section.tangent.cross(section.u);
  return section;
}

double Centerline::nearest(const Vec3& point) const {
  std::size_t best = 0;
  for (std::size_t i = 1; i < sections_.size(); ++i)
    if ((sections_[i].center - point).squaredNorm() < (sections_[best].center - point).squaredNorm())
      best = i;
  return arcs_[best];
}

} // namespace viscera::sequences
