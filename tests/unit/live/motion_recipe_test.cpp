#include "viscera/live/motion_recipe.h"

#include <string>

#include <gtest/gtest.h>

#include "viscera/core/error.h"
#include "viscera/core/progress.h"

namespace viscera::live {
namespace {

using sample_organs::Resolution;

/// The error with which the motion of a recipe cannot be made.
std::string refusalOf(const std::string& recipe) {
  document::Organ organ;
  organ.name = "Heart of a patient";
  Progress progress;
  try {
    makeMotion(recipe, organ, sample_organs::standardLibrary(), progress);
  } catch (const DataError& error) {
    return error.problem().english() + " / " + error.where().english();
  }
  return "accepted";
}

} // namespace

TEST(MotionRecipe, OfTheSampleHeartNamesItsResolution) {
  EXPECT_EQ(sampleHeartOf(sampleRecipe("heartbeat", Resolution::medium)), Resolution::medium);
  EXPECT_FALSE(sampleHeartOf(sampleRecipe("peristalsis", Resolution::medium)));
  EXPECT_FALSE(sampleHeartOf(fittedRecipe("heartbeat", {})));
}

TEST(MotionRecipe, OfAnotherKindIsNoSampleHeart) {
  for (const char* other : {"", "no json", "[]", "7", "{}", R"({"sequence": 7, "resolution": "low"})",
                            R"({"sequence": "heartbeat", "resolution": 7})",
                            R"({"sequence": "heartbeat", "resolution": "huge"})"})
    EXPECT_FALSE(sampleHeartOf(other)) << other;
}

TEST(MotionRecipe, ThatIsDamagedIsRefusedWithTheOrgan) {
  for (const char* damaged :
       {"no json", "[]", "{}", R"({"sequence": 7, "resolution": "low"})", R"({"sequence": "heartbeat"})",
        R"({"sequence": "heartbeat", "resolution": 7})",
        R"({"sequence": "heartbeat", "landmarks": [{"role": "apex"}]})",
        R"({"sequence": "heartbeat", "landmarks": [{"role": "apex", "position": [1, 2]}]})",
        R"({"sequence": "heartbeat", "landmarks": {"apex": [1, 2, 3]}})"})
    EXPECT_EQ(refusalOf(damaged),
              "The motion of an organ cannot be made again: nothing is known of how it was "
              "made / Heart of a patient")
        << damaged;
}

} // namespace viscera::live
