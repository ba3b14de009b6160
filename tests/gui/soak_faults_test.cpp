// What the soak finds wrong with what it measured.
#include <gtest/gtest.h>

#include "soak/soak_faults.h"

namespace viscera::tests {
namespace {

/// An hour in which all is well: the first tenth takes what caches need, each minute has a drag.
std::vector<SoakSample> calmHour() {
  std::vector<SoakSample> samples(3600);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const bool warm = i >= 360, drag = i % 60 < 3;
    samples[i] = {double(i + 1),
                  {380, warm ? 220.0 : 180.0, 105, drag ? 14 : 12, warm ? 25 : 19},
                  16,
                  drag ? 130.0 : 70.0,
                  {},
                  drag ? "a drag" : kPlaying};
  }
  return samples;
}

TEST(SoakFaults, AreNoneInACalmHour) {
  EXPECT_TRUE(soakFaults(calmHour()).empty());
}

TEST(SoakFaults, AreMemoryThatGrowsAndFramesThatComeLateButNotByTheMachine) {
  std::vector<SoakSample> samples = calmHour();
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i].use.ownMb *= 1 + 0.02 * double(i) / 3600;
  samples[1000].longestMs = 120;
  samples[1010].longestMs = 120;
  samples[1010].machine.pausedMs = 30;
  samples[2000].frames = 0;
  const std::vector<std::string> faults = soakFaults(samples);
  ASSERT_EQ(faults.size(), 3u);
  EXPECT_EQ(faults[0].rfind("memory grew from 22", 0), 0u) << faults[0];
  EXPECT_EQ(faults[1], "a frame came after 120 ms at 1001 s, of which the machine stood still 0 ms and was "
                       "slower for 0 ms");
  EXPECT_EQ(faults[2], "no frame was drawn in the second before 2001 s");
}

TEST(SoakFaults, AreNotFramesThatTheMachineDrewMoreSlowlyButOthersBesideThem) {
  std::vector<SoakSample> samples = calmHour();
  const auto isPlaying = [](const SoakSample& sample) { return sample.occupation == kPlaying; };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double slowness =
        i / 100 % 7 == 5 ? 1.5 : 1 + 0.05 * double(i % 2); // Of everything, in some times.
    samples[i].machine.workUs = 90 * slowness;
    if (isPlaying(samples[i]))
      samples[i].longestMs = 70 * slowness;
  }
  EXPECT_TRUE(soakFaults(samples).empty());

  samples[1250].longestMs = 150; // Slow, but not as slow as that.
  samples[1330].longestMs = 105; // At the usual speed.
  const std::vector<std::string> faults = soakFaults(samples);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].rfind("a frame came after 150 ms at 1251 s", 0), 0u) << faults[0];
  EXPECT_EQ(faults[1].rfind("a frame came after 105 ms at 1331 s", 0), 0u) << faults[1];
}

/// Half of the seconds follow a recording, with less memory: a few more at first, a few less at the end.
TEST(SoakFaults, AreNotTwoStatesOfMemoryThatEachStay) {
  std::vector<SoakSample> samples = calmHour();
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i].use.ownMb = i % 60 < (i < 1800 ? 29 : 33) ? 231 : 227;
  EXPECT_TRUE(soakFaults(samples).empty());
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i].use.allocatedMb *= 1 + 0.02 * double(i) / 3600;
  const std::vector<std::string> faults = soakFaults(samples);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].rfind("allocated memory grew from 105.", 0), 0u) << faults[0];
}

TEST(SoakFaults, AreFramesThatBecomeLateOnAMachineThatIsAsFastAsBefore) {
  std::vector<SoakSample> samples = calmHour();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].machine.workUs = 90 + 5 * double(i % 3);
    if (i > 3000 && samples[i].occupation == kPlaying)
      samples[i].longestMs = 110;
  }
  EXPECT_GT(soakFaults(samples).size(), 500u);
}

TEST(SoakFaults, AreDescriptorsThatStayOpenAndThreadsThatComeInTheSecondHalf) {
  std::vector<SoakSample> samples = calmHour();
  for (std::size_t i = 950; i < samples.size(); ++i)
    samples[i].use.threads += 1; // A worker's first parallel loop.
  EXPECT_TRUE(soakFaults(samples).empty());

  for (std::size_t i = 3100; i < samples.size(); ++i) {
    samples[i].use.threads += 1;
    samples[i].use.descriptors += 1;
  }
  EXPECT_EQ(soakFaults(samples), (std::vector<std::string>{"13 descriptors at 3101 s, 12 before",
                                                           "27 threads at 3101 s, at most 26 before"}));
}

TEST(SoakFaults, AreNotInALongerWarmUpOrLateWhereThatIsAllowed) {
  std::vector<SoakSample> samples = calmHour();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].use.ownMb += i < 1200 ? -6 : 0;
    samples[i].longestMs = 150;
  }
  EXPECT_EQ(soakFaults(samples, {0.1, true}).size(), 1u);
  EXPECT_TRUE(soakFaults(samples, {0.34, true}).empty());
  EXPECT_GT(soakFaults(samples, {0.34, false}).size(), 1000u);
}

TEST(SoakFaults, NeedMoreThanAFewSeconds) {
  EXPECT_EQ(soakFaults(std::vector<SoakSample>(5)).size(), 1u);
}

} // namespace
} // namespace viscera::tests
