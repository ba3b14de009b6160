#include "viscera/motion/volume_record.h"

#include <gtest/gtest.h>

namespace viscera::motion {
namespace {

TEST(CycleTrace, KeepsInstantsInOrderWhateverTheOrderInWhichTheyAreSeen) {
  CycleTrace trace(10);
  trace.add(0.75, 3);
  trace.add(0.15, 1);
  trace.add(0.45, 2);
  EXPECT_EQ(trace.fractions(), (std::vector<double>{0.15, 0.45, 0.75}));
  EXPECT_EQ(trace.values(), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(trace.seen(), 3u);
}

TEST(CycleTrace, AnInstantThatIsSeenAgainTakesThePlaceOfTheOldOne) {
  CycleTrace trace(10);
  trace.add(0.31, 5);
  trace.add(0.39, 7);
  EXPECT_EQ(trace.fractions(), std::vector<double>{0.39});
  EXPECT_EQ(trace.values(), std::vector<double>{7});
  EXPECT_EQ(trace.seen(), 1u);
}

TEST(CycleTrace, BothEndsOfTheCycleAreInside) {
  CycleTrace trace(4);
  trace.add(0, 1);
  trace.add(1, 2);
  EXPECT_EQ(trace.values(), (std::vector<double>{1, 2}));
  trace.clear();
  EXPECT_EQ(trace.seen(), 0u);
  EXPECT_TRUE(trace.values().empty());
}

} // namespace
} // namespace viscera::motion
