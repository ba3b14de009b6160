#include "viscera/core/progress.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera {

TEST(Progress, ReportsClampedFractionsAndKeepsTheStep) {
  std::vector<std::pair<double, std::string>> heard;
  Progress progress([&](double fraction, const Text& step) { heard.emplace_back(fraction, step.english()); });
  progress.report(-1, "binding");
  progress.report(0.5);
  progress.report(2);
  ASSERT_EQ(heard.size(), 3u);
  EXPECT_EQ(heard[0], std::make_pair(0.0, std::string("binding")));
  EXPECT_EQ(heard[1], std::make_pair(0.5, std::string("binding")));
  EXPECT_EQ(heard[2], std::make_pair(1.0, std::string("binding")));
}

TEST(Progress, DoesNotFloodTheListener) {
  int calls = 0;
  Progress progress([&](double, const Text&) { ++calls; });
  for (int i = 0; i < 1'000'000; ++i)
    progress.report(i * 1e-6);
  EXPECT_LE(calls, 1002);
  EXPECT_GE(calls, 500);
}

TEST(Progress, ThrowsOnceCancelled) {
  Progress progress;
  EXPECT_NO_THROW(progress.throwIfCancelled());
  progress.cancel();
  EXPECT_TRUE(progress.cancelled());
  EXPECT_THROW(progress.throwIfCancelled(), Cancelled);
}

TEST(Progress, LetsTheWaitingSideActWhenTheJobLooks) {
  Progress* whole = nullptr;
  int looks = 0;
  Progress progress({}, [&] {
    if (++looks == 3)
      whole->cancel();
  });
  whole = &progress;
  progress.throwIfCancelled();
  EXPECT_THROW(runPart(progress, 0, 1,
                       [](Progress& part) {
                         part.throwIfCancelled();
                         ADD_FAILURE() << "The waiting side has cancelled.";
                       }),
               Cancelled);
  EXPECT_EQ(looks, 3) << "two of the whole, one of its part";
}

TEST(Progress, APartThatReportsNothingSeesThatTheWholeIsCancelled) {
  Progress whole;
  EXPECT_THROW(runPart(whole, 0, 0.5,
                       [&whole](Progress& part) {
                         whole.cancel();
                         EXPECT_TRUE(part.cancelled());
                       }),
               Cancelled);
}

} // namespace viscera
