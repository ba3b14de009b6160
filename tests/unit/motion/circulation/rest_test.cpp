#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "solved.h"

namespace viscera::circulation {

/// A healthy adult at rest: the numbers that the default parameters were fitted to.
class CirculationAtRest : public testing::Test {
protected:
  const Solved rest_ = solve("rest");
  const Indices& at_ = rest_.indices;
};

TEST_F(CirculationAtRest, AorticPressureIs120Over80) {
  ASSERT_TRUE(rest_.state.converged) << rest_.state.failureReason;
  EXPECT_NEAR(at_.aorta.systolic, 120, 5);
  EXPECT_NEAR(at_.aorta.diastolic, 80, 5);
  EXPECT_GT(at_.aorta.mean, at_.aorta.diastolic + 10);
  EXPECT_LT(at_.aorta.mean, at_.aorta.systolic - 10);
}

TEST_F(CirculationAtRest, LeftVentricleHoldsAndEjectsWhatTheSampleHeartDoes) {
  const ChamberIndices& lv = at_.of(Compartment::lv);
  EXPECT_NEAR(lv.edvMl, 130, 3);
  EXPECT_NEAR(lv.ef, 0.58, 0.02);
  EXPECT_GT(lv.edpMmHg, 4);
  EXPECT_LT(lv.edpMmHg, 12);
  EXPECT_GT(lv.dpdtMax, 1000);
  EXPECT_LT(lv.dpdtMax, 1800);
}

TEST_F(CirculationAtRest, AtriaAndPulmonaryArteryAreInTheirRanges) {
  EXPECT_GT(at_.of(Compartment::la).meanMmHg, 6);
  EXPECT_LT(at_.of(Compartment::la).meanMmHg, 12);
  EXPECT_GT(at_.of(Compartment::ra).meanMmHg, 1);
  EXPECT_LT(at_.of(Compartment::ra).meanMmHg, 6);
  EXPECT_NEAR(at_.pulmonaryArtery.systolic, 25, 5);
  EXPECT_NEAR(at_.pulmonaryArtery.diastolic, 10, 5);
}

TEST_F(CirculationAtRest, OutputIsFiveToSixLitresAndTheSameOnBothSides) {
  EXPECT_GT(at_.cardiacOutputLMin, 5);
  EXPECT_LT(at_.cardiacOutputLMin, 6);
  const auto& lungs = rest_.state.beat.flowOf(Valve::pulmonic);
  const double right =
      std::accumulate(lungs.begin(), lungs.end() - 1, 0.0) / static_cast<double>(lungs.size() - 1);
  EXPECT_NEAR(right * 60 / 1000, at_.cardiacOutputLMin, 1e-6);
}

TEST_F(CirculationAtRest, ValvesOpenAndShutInTheirOrder) {
  const auto& mitral = at_.valves[0];
  const auto& aortic = at_.valves[1];
  ASSERT_TRUE(mitral && aortic);
  EXPECT_LT(mitral->shuts, aortic->opens);
  EXPECT_LT(mitral->shuts, 0.05);
  EXPECT_LT(aortic->opens, aortic->shuts);
  EXPECT_LT(aortic->shuts, mitral->opens);
  EXPECT_GT(1000 * at_.isovolumicContractionSeconds, 20); // Copenhagen study, 40 +- 10 ms.
  EXPECT_LT(1000 * at_.isovolumicContractionSeconds, 60);
  EXPECT_DOUBLE_EQ(at_.isovolumicContractionSeconds, aortic->opens - mitral->shuts);
  EXPECT_DOUBLE_EQ(at_.ejectionSeconds, aortic->shuts - aortic->opens);
  // Weissler's ejection time of men, 413 - 1.7 rate, whose spread is about 10 ms.
  EXPECT_NEAR(1000 * at_.ejectionSeconds, 413 - 1.7 * 72, 15);
  // Isovolumic relaxation of the Copenhagen study, 96 +- 19 ms.
  EXPECT_NEAR(1000 * (mitral->opens - aortic->shuts), 96, 38);
}

TEST_F(CirculationAtRest, BloodFillsTheVentricleTwiceABeatAndFasterTheFirstTime) {
  const Beat& beat = rest_.state.beat;
  const auto& flow = beat.flowOf(Valve::mitral);
  const auto sample = [&](double seconds) {
    return flow.begin() +
           static_cast<std::ptrdiff_t>(seconds / beat.period * static_cast<double>(flow.size() - 1));
  };
  const double atrial = beat.period - rest_.parameters.conduction;
  const double early = *std::max_element(sample(at_.valves[0]->opens), sample(atrial));
  const double late = *std::max_element(sample(atrial), flow.end());
  const double between = *std::min_element(sample(atrial - 0.05), sample(atrial + 0.02));
  EXPECT_GT(early / late, 0.8);
  EXPECT_LT(early / late, 2.5);
  EXPECT_LT(between, 0.5 * late);
}

TEST_F(CirculationAtRest, ShutValvesLetNothingThrough) {
  EXPECT_LT(at_.mitralRegurgitationMl, 1);
  EXPECT_LT(at_.aorticRegurgitationMl, 4); // What the leaflets sweep while they close.
  EXPECT_LT(at_.aorticMeanGradient, 5);
}

} // namespace viscera::circulation
