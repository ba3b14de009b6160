#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "viscera/strain/aha_segments.h"

namespace viscera::strain {
namespace {

using std::numbers::pi;

/// In a patient who lies straight (LPS), with the apex to the left of the picture's front: the right
/// ventricle to the patient's right.
TEST(AhaSegments, RunFromTheAnteriorInsertionThroughTheSeptumToTheInferiorWall) {
  // Base to apex: down. The septum's middle: to the patient's right (-x). In front is -y.
  const Vec3 base(0, 0, 90), apex(0, 0, 0);
  const Vec3 insertion(-std::cos(pi / 3), -std::sin(pi / 3), 0);
  const HeartAxes axes(base, apex, insertion);
  const auto at = [&](double x, double y, double height) {
    return segmentOf(axes, Vec3(20 * x, 20 * y, height));
  };
  const double half = std::sqrt(0.5);
  EXPECT_EQ(at(-0.94, -0.34, 80), 2) << "septum, in front";
  EXPECT_EQ(at(-0.94, 0.34, 80), 3) << "septum, behind";
  EXPECT_EQ(at(0, 1, 80), 4) << "behind and below: inferior";
  EXPECT_EQ(at(0.94, 0.34, 80), 5);
  EXPECT_EQ(at(0.94, -0.34, 80), 6);
  EXPECT_EQ(at(0, -1, 80), 1) << "in front: anterior";
  EXPECT_EQ(at(0, -1, 45), 7);
  EXPECT_EQ(at(-0.94, -0.34, 45), 8);
  EXPECT_EQ(at(-1, 0, 10), 14) << "septal";
  EXPECT_EQ(at(0, 1, 10), 15);
  EXPECT_EQ(at(1, 0, 10), 16);
  EXPECT_EQ(at(half, -half - 0.1, 10), 13);
  EXPECT_EQ(segmentOf(axes, Vec3(1, 1, -4)), 17);
  EXPECT_EQ(segmentOf(axes, Vec3(20, 0, 95)), 0) << "behind the annulus";
}

TEST(AhaSegments, AreSeventeenThatFillTheRings) {
  double covered[4] = {};
  for (const Segment& segment : segments())
    covered[segment.ring] += segment.toDegrees - segment.fromDegrees;
  for (const double degrees : covered)
    EXPECT_DOUBLE_EQ(degrees, 360);
  int septal = 0;
  for (const Segment& segment : segments()) {
    septal += segment.septal ? segment.number : 0;
    if (segment.septal) {
      EXPECT_NEAR(std::cos(0.5 * (segment.fromDegrees + segment.toDegrees) * pi / 180), -0.9, 0.11)
          << "the septum is drawn on the left";
    }
  }
  EXPECT_EQ(septal, 2 + 3 + 8 + 9 + 14);
}

} // namespace
} // namespace viscera::strain
