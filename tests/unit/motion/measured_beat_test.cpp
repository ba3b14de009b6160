#include <gtest/gtest.h>

#include "measured_beat.h"

namespace viscera::motion {
namespace {

/// Section by section what docs/patient_motion.md promises, in fewer phases than a scanner gives.
class MeasuredBeatTest : public testing::Test {
protected:
  static const tests::MeasuredBeat& truth() {
    static const tests::MeasuredBeat beat(6, sample_organs::Resolution::low);
    return beat;
  }
  static PatientMotion track(const MotionSeries& series) {
    Progress progress;
    return trackMotion(series, {}, progress);
  }
};

TEST_F(MeasuredBeatTest, ComesBackFromSurfaces) {
  const PatientMotion found = track(truth().surfaces());
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(truth().distanceTo(found, i), 0.6) << i;
  for (std::size_t i = 1; i < 3; ++i)
    EXPECT_NEAR(found.indices.at(truth().truth[i].name).ejectionFraction, truth().trueEjection(i), 1e-3);
  for (const TrackedPhase& phase : found.phases)
    EXPECT_EQ(phase.quality.folded, 0);
}

TEST_F(MeasuredBeatTest, ComesBackFromThickSlices) {
  const PatientMotion found = track(truth().voxels(Vec3(1.5, 1.5, 8)));
  double dice = 0;
  for (const TrackedPhase& phase : found.phases)
    for (const tracking::SurfaceQuality& surface : phase.quality.surfaces) {
      EXPECT_GT(surface.dice.value_or(0), 0.94);
      EXPECT_NEAR(surface.fittedMl / surface.measuredMl, 1, 1e-4);
      dice += *surface.dice / (3.0 * static_cast<double>(found.phases.size()));
    }
  EXPECT_GT(dice, 0.96);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(truth().distanceTo(found, i), 0.8) << i;
  for (std::size_t i = 1; i < 3; ++i)
    EXPECT_NEAR(found.indices.at(truth().truth[i].name).ejectionFraction, truth().trueEjection(i), 0.015);
}

TEST_F(MeasuredBeatTest, ComesBackFromFineVoxels) {
  const PatientMotion found = track(truth().voxels(Vec3(1, 1, 1)));
  double dice = 0;
  for (const TrackedPhase& phase : found.phases)
    for (const tracking::SurfaceQuality& surface : phase.quality.surfaces)
      dice += *surface.dice / (3.0 * static_cast<double>(found.phases.size()));
  EXPECT_GT(dice, 0.975);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(truth().distanceTo(found, i), 0.4) << i;
  for (std::size_t i = 1; i < 3; ++i)
    EXPECT_NEAR(found.indices.at(truth().truth[i].name).ejectionFraction, truth().trueEjection(i), 0.002);
}

} // namespace
} // namespace viscera::motion
