#include "viscera/lesson/course.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace viscera::lesson {
namespace {

double wave(double fraction) {
  return std::sin(2 * std::numbers::pi * fraction) + 0.3 * std::cos(6 * std::numbers::pi * fraction);
}

double ramp(double fraction) {
  return fraction * fraction * (3 - 2 * fraction);
}

Course sampled(double (*curve)(double), Eigen::Index samples, CourseEnd end) {
  Course course(samples, 1);
  for (Eigen::Index i = 0; i < samples; ++i)
    course(i, 0) = curve(fractionOf(i, samples, end));
  return course;
}

double worstBetween(double (*curve)(double), Eigen::Index samples, CourseEnd end) {
  const Course spline = splineThrough(sampled(curve, samples, end), end);
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double fraction = std::min(i / 1000.0, end == CourseEnd::cycles ? 0.999 : 1.0);
    worst = std::max(worst, std::abs(valueAt(spline, end, fraction)[0] - curve(fraction)));
  }
  return worst;
}

} // namespace

TEST(Course, RunsThroughItsSamples) {
  for (const CourseEnd end : {CourseEnd::cycles, CourseEnd::stops}) {
    const Course samples = sampled(end == CourseEnd::cycles ? wave : ramp, 17, end);
    const Course spline = splineThrough(samples, end);
    for (Eigen::Index i = 0; i < 17; ++i)
      EXPECT_NEAR(valueAt(spline, end, fractionOf(i, 17, end))[0], samples(i, 0), 1e-12) << i;
  }
}

TEST(Course, FollowsASmoothCycleToTheFourthOrder) {
  const double coarse = worstBetween(wave, 24, CourseEnd::cycles);
  const double fine = worstBetween(wave, 48, CourseEnd::cycles);
  EXPECT_LT(fine, 1e-4);
  EXPECT_GT(coarse / fine, 12);
}

TEST(Course, OfAMotionThatStopsDoesNotLeadBack) {
  EXPECT_LT(worstBetween(ramp, 48, CourseEnd::stops), 1e-4);
  EXPECT_GT(worstBetween(ramp, 48, CourseEnd::cycles), 0.1) << "the jump is taken for a cycle";
}

} // namespace viscera::lesson
