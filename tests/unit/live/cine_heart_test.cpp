#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "cine_heart.h"
#include "viscera/live/cine_motion.h"

namespace viscera::live {
namespace {

// The outside with both ventricles in it, labelled at the ends of diastole and systole; few phases and coarse
// pixels, because rendering takes the time. bench_tracking has 25 phases.
TEST(CineHeart, HasThreeSurfacesThatNeverFold) {
  const tests::MeasuredBeat beat(8, sample_organs::Resolution::low);
  const tests::CineHeart heart(beat);
  const LabelledStudy study = heart.study({.pixelMm = 3});
  Progress progress;
  const CineMotion found = trackCine(study, {}, progress);
  EXPECT_EQ(found.endDiastole, heart.diastole());
  EXPECT_EQ(found.endSystole, heart.systole());
  EXPECT_EQ(found.planes.size(), 9U);
  ASSERT_EQ(found.motion.phases.size(), 8U);
  double largest[3] = {};
  for (std::size_t phase = 0; phase < 8; ++phase) {
    const tracking::PhaseQuality& quality = found.motion.phases[phase].quality;
    EXPECT_EQ(quality.folded, 0) << phase;
    ASSERT_EQ(quality.surfaces.size(), 3U);
    for (std::size_t surface = 0; surface < 3; ++surface) {
      const double part = (quality.surfaces[surface].fittedMl - beat.trueMl(phase, surface)) /
                          beat.trueMl(heart.diastole(), surface);
      if (found.isLabelled(phase)) {
        EXPECT_NEAR(part, 0, 1e-6) << phase << ", surface " << surface;
      }
      largest[surface] = std::max(largest[surface], std::abs(part));
    }
  }
  std::printf("outer %.3f, left %.3f, right %.3f\n", largest[0], largest[1], largest[2]);
  EXPECT_LT(largest[1], 0.05) << "left ventricle";
  EXPECT_LT(largest[2], 0.06) << "right ventricle";
}

} // namespace
} // namespace viscera::live
