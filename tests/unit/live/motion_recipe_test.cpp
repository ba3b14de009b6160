#include "viscera/live/motion_recipe.h"

#include <gtest/gtest.h>

#include "viscera/core/error.h"
#include "viscera/core/progress.h"

namespace viscera::live {

using sample_organs::Resolution;

TEST(MotionRecipe, OfTheSampleHeartNamesItsResolution) {
  EXPECT_EQ(sampleHeartOf(SampleMotion{"heartbeat", Resolution::high}), Resolution::high);
  EXPECT_FALSE(sampleHeartOf(SampleMotion{"peristalsis", Resolution::medium}));
  EXPECT_FALSE(sampleHeartOf(FittedMotion{"heartbeat", {}}));
  EXPECT_FALSE(sampleHeartOf({}));
}

TEST(MotionRecipe, NamesItsSequence) {
  EXPECT_EQ(sequenceOf(SampleMotion{"breathing", Resolution::low}), "breathing");
  EXPECT_EQ(sequenceOf(FittedMotion{"heartbeat", {}}), "heartbeat");
  EXPECT_EQ(sequenceOf({}), "");
}

TEST(MotionRecipe, OfWhichNothingIsKnownIsRefusedWithTheOrgan) {
  document::Organ organ;
  organ.name = "Heart of a patient";
  Progress progress;
  try {
    makeMotion({}, organ, sample_organs::standardLibrary(), progress);
    FAIL() << "accepted";
  } catch (const DataError& error) {
    EXPECT_EQ(error.problem().english() + " / " + error.where().english(),
              "The motion of an organ cannot be made again: nothing is known of how it was made / Heart of a "
              "patient");
  }
}

} // namespace viscera::live
