#include <gtest/gtest.h>

#include "viscera/circulation/response.h"
#include "viscera/core/error.h"

namespace viscera::circulation {

TEST(CirculationResponse, FrankAndStarlingsCurveRisesAndFlattens) {
  Progress progress;
  const auto points = responseTo({}, "stressedVolume", {600, 800, 1000, 1200, 1400}, progress);
  ASSERT_EQ(points.size(), 5u);
  double steepest = 1e9;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const ChamberIndices& before = points[i - 1].indices.of(Compartment::lv);
    const ChamberIndices& now = points[i].indices.of(Compartment::lv);
    EXPECT_GT(now.edvMl, before.edvMl);
    EXPECT_GT(now.svMl, before.svMl);
    // Stroke volume against filling pressure: ever less for each mmHg.
    const double slope = (now.svMl - before.svMl) / (now.edpMmHg - before.edpMmHg);
    EXPECT_LT(slope, steepest);
    steepest = slope;
  }
}

TEST(CirculationResponse, AStrongerHeartEjectsMoreFromTheSameFilling) {
  Progress progress;
  const auto points = responseTo({}, "lvEes", {1.2, 2.25, 4}, progress);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const ChamberIndices& before = points[i - 1].indices.of(Compartment::lv);
    const ChamberIndices& now = points[i].indices.of(Compartment::lv);
    EXPECT_GT(now.ef, before.ef);
    EXPECT_LT(now.esvMl, before.esvMl);
    EXPECT_LT(points[i].indices.couplingRatio, points[i - 1].indices.couplingRatio);
  }
}

TEST(CirculationResponse, AfterloadRaisesPressureAndEndSystolicVolumeAndLowersTheStroke) {
  Progress progress;
  const auto points = responseTo({}, "systemicResistance", {0.6, 0.9, 1.3, 1.8, 2.5}, progress);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Indices& before = points[i - 1].indices;
    const Indices& now = points[i].indices;
    EXPECT_GT(now.aorta.mean, before.aorta.mean);
    EXPECT_GT(now.of(Compartment::lv).esvMl, before.of(Compartment::lv).esvMl);
    EXPECT_LT(now.of(Compartment::lv).svMl, before.of(Compartment::lv).svMl);
    EXPECT_GT(now.arterialElastance, before.arterialElastance);
    // The ventricle fills more, which gives back a part of what afterload takes.
    EXPECT_GT(now.of(Compartment::lv).edvMl, before.of(Compartment::lv).edvMl);
  }
}

TEST(CirculationResponse, RefusesUnknownNamesAndCanBeCancelled) {
  Progress progress;
  EXPECT_THROW(responseTo({}, "preload", {1}, progress), UsageError);
  progress.cancel();
  EXPECT_THROW(responseTo({}, "rate", {60}, progress), Cancelled);
}

} // namespace viscera::circulation
