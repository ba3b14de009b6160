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

double corner(double fraction) {
  return std::abs(fraction - 0.5);
}

/// Evenly, or nearer to one another towards the middle of the cycle.
std::vector<double> instants(int pieces, bool gathered = false) {
  std::vector<double> all;
  for (int i = 0; i <= pieces; ++i) {
    const double from = 2.0 * i / pieces - 1;
    all.push_back(gathered ? 0.5 + 0.5 * from * from * from : 0.5 + 0.5 * from);
  }
  return all;
}

Course through(double (*curve)(double), const std::vector<double>& at, CourseEnd end) {
  Table values(static_cast<Eigen::Index>(at.size()), 1);
  for (std::size_t i = 0; i < at.size(); ++i)
    values(static_cast<Eigen::Index>(i), 0) =
        curve(end == CourseEnd::cycles && i + 1 == at.size() ? 0 : at[i]);
  return splineThrough(at, values, end);
}

double worst(double (*curve)(double), const Course& course, CourseEnd end) {
  double largest = 0;
  for (int i = 0; i <= 2000; ++i) {
    const double fraction = std::min(i / 2000.0, end == CourseEnd::cycles ? 0.9995 : 1.0);
    largest = std::max(largest, std::abs(valueAt(course, fraction)[0] - curve(fraction)));
  }
  return largest;
}

double worstOfWave(int pieces) {
  return worst(wave, through(wave, instants(pieces), CourseEnd::cycles), CourseEnd::cycles);
}

} // namespace

TEST(Course, RunsThroughItsInstants) {
  for (const bool gathered : {false, true}) {
    const std::vector<double> at = instants(17, gathered);
    const Course course = through(ramp, at, CourseEnd::stops);
    for (const double fraction : at)
      EXPECT_NEAR(valueAt(course, fraction)[0], ramp(fraction), 1e-12) << fraction;
  }
}

TEST(Course, FollowsASmoothCycleToTheFourthOrder) {
  EXPECT_LT(worstOfWave(48), 1e-4);
  EXPECT_GT(worstOfWave(24) / worstOfWave(48), 12);
}

TEST(Course, GoesOnSmoothlyFromTheEndToTheBeginning) {
  const Course course = through(wave, instants(24), CourseEnd::cycles);
  const double step = 1e-4;
  const double before = (valueAt(course, 1)[0] - valueAt(course, 1 - step)[0]) / step;
  const double behind = (valueAt(course, step)[0] - valueAt(course, 0)[0]) / step;
  EXPECT_NEAR(before, behind, 0.05);
}

TEST(Course, MeetsACornerWhereInstantsGather) {
  const auto off = [](bool gathered) {
    return worst(corner, through(corner, instants(25, gathered), CourseEnd::stops), CourseEnd::stops);
  };
  EXPECT_LT(off(true), 1e-3);
  EXPECT_GT(off(false), 5e-3);
}

TEST(Course, OfAMotionThatStopsDoesNotLeadBack) {
  EXPECT_LT(worst(ramp, through(ramp, instants(48), CourseEnd::stops), CourseEnd::stops), 1e-3);
  EXPECT_GT(worst(ramp, through(ramp, instants(48), CourseEnd::cycles), CourseEnd::cycles), 0.1)
      << "the jump is taken for a cycle";
}

} // namespace viscera::lesson
