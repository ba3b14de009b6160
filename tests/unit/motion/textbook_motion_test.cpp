#include <gtest/gtest.h>

#include "measured_beat.h"
#include "viscera/core/error.h"
#include "viscera/motion/textbook_motion.h"

namespace viscera::motion {
namespace {

/// One image of the sample heart: its outer surface and both ventricles.
MotionSeries image(const Vec3& spacing) {
  static const tests::MeasuredBeat truth(1, sample_organs::Resolution::low);
  MotionSeries heart = spacing[0] > 0 ? truth.voxels(spacing) : truth.surfaces();
  heart.names = {"heart", "LV", "RV"};
  return heart;
}

TEST(TextbookSeries, MovesTheCavitiesOfOneImageByWhatIsWanted) {
  for (const double wanted : {0.58, 0.35}) {
    TextbookBeat beat;
    beat.ejectionFraction = wanted;
    beat.phases = 10;
    Progress progress;
    const MotionSeries series = textbookSeries(image(Vec3(2, 2, 2)), beat, progress);
    ASSERT_EQ(series.phases(), 10U);
    const PatientMotion found = trackMotion(series, {}, progress);
    EXPECT_NEAR(found.indices.at("LV").ejectionFraction, wanted, 0.02);
    EXPECT_NEAR(found.indices.at("LV").strokeVolumeMl / found.indices.at("RV").strokeVolumeMl, 1, 0.03)
        << "both eject as much";
    for (std::size_t phase = 0; phase < 10; ++phase) {
      EXPECT_EQ(found.phases[phase].quality.folded, 0) << "phase " << phase;
      EXPECT_LT(found.phases[phase].quality.meanMm, 1.5) << "phase " << phase;
      EXPECT_NEAR(found.tissueMl[phase] / found.tissueMl[0], 1, 1e-3) << "muscle keeps its volume";
      for (const tracking::SurfaceQuality& surface : found.phases[phase].quality.surfaces)
        EXPECT_EQ(surface.flipped, 0) << "phase " << phase;
    }
  }
}

TEST(TextbookSeries, SaysWhatItNeeds) {
  Progress progress;
  MotionSeries heart = image(Vec3::Zero());
  TextbookBeat beat;
  beat.ejectionFraction = 0.95;
  EXPECT_THROW(textbookSeries(heart, beat, progress), UsageError);
  heart.names = {"heart", "one", "two"};
  beat.ejectionFraction = 0.5;
  EXPECT_THROW(textbookSeries(heart, beat, progress), DataError);
}

} // namespace
} // namespace viscera::motion
