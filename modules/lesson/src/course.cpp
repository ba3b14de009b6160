#include "viscera/lesson/course.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace viscera::lesson {
namespace {

constexpr Eigen::Index kReach = 40; ///< Samples behind which nothing of one is left: 0.27^40 < 1e-22.

/// The sample that stands for place `i`, which may lie before the first or behind the last.
Eigen::Index placeOf(Eigen::Index i, Eigen::Index samples, CourseEnd end) {
  if (end == CourseEnd::cycles || samples == 1)
    return (i % samples + samples) % samples;
  const Eigen::Index period = 2 * (samples - 1);
  const Eigen::Index inside = (i % period + period) % period;
  return inside < samples ? inside : period - inside;
}

} // namespace

double fractionOf(Eigen::Index sample, Eigen::Index samples, CourseEnd end) {
  const Eigen::Index steps = end == CourseEnd::cycles ? samples : std::max<Eigen::Index>(1, samples - 1);
  return static_cast<double>(sample) / static_cast<double>(steps);
}

Course splineThrough(const Course& samples, CourseEnd end) {
  // A recursive filter forth and back; begun so far outside that its beginning is forgotten.
  static const double pole = std::sqrt(3.0) - 2;
  const Eigen::Index count = samples.rows();
  Course forth(count + 2 * kReach, samples.cols());
  forth.row(0) = samples.row(placeOf(-kReach, count, end));
  for (Eigen::Index i = 1; i < forth.rows(); ++i)
    forth.row(i) = samples.row(placeOf(i - kReach, count, end)) + pole * forth.row(i - 1);
  Course spline(count, samples.cols());
  Eigen::RowVectorXd last = Eigen::RowVectorXd::Zero(samples.cols());
  for (Eigen::Index i = forth.rows() - 1; i >= kReach; --i) {
    last = pole * (last - forth.row(i));
    if (i - kReach < count)
      spline.row(i - kReach) = 6 * last;
  }
  return spline;
}

Eigen::VectorXd valueAt(const Course& spline, CourseEnd end, double fraction) {
  const Eigen::Index count = spline.rows();
  const double place = fraction / fractionOf(1, count, end);
  const auto before = static_cast<Eigen::Index>(std::floor(place));
  const double u = place - static_cast<double>(before), v = 1 - u;
  const std::array<double, 4> weights = {v * v * v / 6, (4 - 3 * u * u * (2 - u)) / 6,
                                         (4 - 3 * v * v * (2 - v)) / 6, u * u * u / 6};
  Eigen::VectorXd value = Eigen::VectorXd::Zero(spline.cols());
  for (Eigen::Index i = 0; i < 4; ++i)
    value +=
        weights[static_cast<std::size_t>(i)] * spline.row(placeOf(before - 1 + i, count, end)).transpose();
  return value;
}

} // namespace viscera::lesson
