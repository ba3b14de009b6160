#include <memory>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "viscera/core/error.h"
#include "viscera/live/cine_reading.h"
#include "viscera/live/measured_record.h"

namespace viscera::live {
namespace {

using nlohmann::ordered_json;
using tracking::FitLight;

/// A motion of four phases, of which two are labelled, as two planes told it.
MeasuredRecord imagesRecord(bool estimate = false) {
  auto images = std::make_shared<CineRecord>();
  images->request.images = "patient1";
  images->request.labels = {{0, {"ed/EPI.obj", "ed/RV.obj"}}, {2, {"es"}}};
  images->request.surfaces = {{"EPI", {"1", "2"}}, {"RV", {"2"}}};
  images->request.periodSeconds = 0.8;
  images->request.leftOutSeries = {3};
  images->request.firstPhase = 1;
  images->request.corrections = {{1, std::size_t{4}, std::nullopt, "RV", Points::Ones(3, 3)}};
  images->study = "0123456789abcdef";
  images->handles = 60;
  images->keepVolumes = false;
  CineMotion& found = images->found;
  found.labelled = estimate ? std::vector<std::size_t>{0} : std::vector<std::size_t>{0, 2};
  found.estimate = estimate;
  found.endSystole = found.emptiest = 2;
  for (const bool longAxis : {false, true}) {
    CinePlaneUse& plane = found.planes.emplace_back();
    plane.source = {longAxis ? 4U : 1U, 7, phrase("series %1, %2", 7, named("4-chamber")),
                    medical_io::CinePlane::fourChamber};
    plane.longAxis = longAxis;
    plane.states = {PlaneState::labelled, PlaneState::used, PlaneState::labelled,
                    longAxis ? PlaneState::leavesPlane : PlaneState::noImage};
    plane.shares = {{}, {0.62, 0.8, 1.5, 0.4, 40}, {}, {0.03, 0.5, 8.4, 0.9, 30}};
    plane.weight = 0.3;
    plane.light = longAxis ? FitLight::amber : FitLight::good;
    if (longAxis)
      plane.reason =
          phrase("its tissue leaves the plane: it arrives %1 mm from the next label", inFixed(8.4, 1));
  }
  found.findings = {
      {FitLight::amber, "its images are hardly alike around the wall", std::nullopt, std::size_t{1}}};
  MeasuredRecord record;
  record.organs = {{7}, {9}};
  record.series.names = {"EPI", "RV"};
  record.series.times = tracking::PhaseTimes::even(4, 0.8);
  for (std::size_t phase = 0; phase < 4; ++phase) {
    TrackedPhase& tracked = record.motion.phases.emplace_back();
    tracked.seconds = record.series.times.seconds[phase];
    const double cavity = phase == 2 ? 60 : 100, wall = phase == 1 ? 125 : phase == 3 ? 115 : 100;
    tracked.quality.surfaces.resize(2);
    tracked.quality.surfaces[0].measuredMl = tracked.quality.surfaces[0].fittedMl = cavity + wall;
    tracked.quality.surfaces[1].measuredMl = tracked.quality.surfaces[1].fittedMl = cavity;
    record.motion.tissueMl.push_back(wall);
  }
  record.motion.phases[3].verdict = {FitLight::red, {"the images hardly show how the wall moved"}};
  record.images = images;
  return record;
}

TEST(CineRecord, ComesBackFromASessionWithRequestPlanesAndVerdicts) {
  const MeasuredRecord record = imagesRecord();
  const ordered_json written = toJson(record);
  const MeasuredRecord back = measuredRecordFrom(ordered_json::parse(written.dump()));
  ASSERT_TRUE(back.images);
  const CineRequest& request = back.images->request;
  EXPECT_EQ(request.images, "patient1");
  ASSERT_EQ(request.labels.size(), 2U);
  EXPECT_EQ(request.labels[0].files, record.images->request.labels[0].files);
  EXPECT_EQ(request.labels[1].phase, 2U);
  EXPECT_EQ(request.surfaces[0].labels, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(request.periodSeconds, 0.8);
  EXPECT_EQ(request.leftOutSeries, std::vector<int>{3});
  EXPECT_EQ(request.firstPhase, 1U);
  EXPECT_EQ(request.corrections, record.images->request.corrections);
  EXPECT_EQ(back.images->study, "0123456789abcdef");
  EXPECT_FALSE(back.images->keepVolumes);
  const CineMotion& found = back.images->found;
  EXPECT_TRUE(found.isLabelled(2));
  EXPECT_FALSE(found.isLabelled(1));
  ASSERT_EQ(found.planes.size(), 2U);
  EXPECT_EQ(found.planes[1].source.name, record.images->found.planes[1].source.name);
  EXPECT_EQ(found.planes[1].reason, record.images->found.planes[1].reason);
  EXPECT_EQ(found.planes[0].states[3], PlaneState::noImage);
  EXPECT_EQ(found.planes[0].shares[1].weight, 0.62);
  EXPECT_EQ(back.motion.phases[3].verdict.light, FitLight::red);
  EXPECT_EQ(back.motion.phases[3].verdict.reasons, record.motion.phases[3].verdict.reasons);
  EXPECT_EQ(back.motion.indices.count("RV"), 1U);
  EXPECT_EQ(toJson(back), written);
}

TEST(CineRecord, GivesNoNumberOfAnEstimatedRightVentricle) {
  const MeasuredRecord back = measuredRecordFrom(toJson(imagesRecord(true)));
  EXPECT_TRUE(back.images->found.estimate);
  EXPECT_EQ(back.motion.indices.count("RV"), 0U);
}

TEST(CineRecord, RefusesPlanesThatDoNotFitItsPhases) {
  const ordered_json written = toJson(imagesRecord());
  ordered_json fewer = written, later = written, unknown = written, nothing = written;
  fewer["images"]["planes"][0]["phases"].erase(0);
  later["images"]["labelled"] = {0, 4};
  unknown["images"]["planes"][1]["phases"][1]["state"] = "guessed";
  nothing["images"] = ordered_json::object();
  for (const ordered_json& item : {fewer, later, unknown, nothing})
    EXPECT_THROW(measuredRecordFrom(item), DataError) << item["images"];
}

TEST(CineReading, SaysWhatAPlaneSaysOfAPhase) {
  const MeasuredRecord record = imagesRecord();
  const CineMotion& found = record.images->found;
  EXPECT_EQ(wordsOf(found.planes[0], 0).english(), "labelled");
  EXPECT_EQ(wordsOf(found.planes[0], 1).english(), "weight 62 %");
  EXPECT_EQ(wordsOf(found.planes[0], 3).english(), "no image");
  EXPECT_EQ(wordsOf(found.planes[1], 3).english(), "left its plane by 8.4 mm, weight 3 %");
  EXPECT_THROW(wordsOf(found.planes[0], 4), UsageError);
  EXPECT_EQ(lightOf(PlaneState::used), FitLight::good);
  EXPECT_EQ(lightOf(PlaneState::leavesPlane), FitLight::amber);
  EXPECT_EQ(planeOfSlice(found, 4), std::size_t{1});
  EXPECT_FALSE(planeOfSlice(found, 0));
}

TEST(CineReading, ChecksTheWallAgainstThatOfTheLabels) {
  const MeasuredRecord record = imagesRecord();
  const CineMotion* found = &record.images->found;
  EXPECT_EQ(wallAt(record.motion, found, 0)->light, FitLight::good);
  EXPECT_EQ(wallAt(record.motion, found, 3)->light, FitLight::amber) << "115 ml in place of 100";
  const auto red = wallAt(record.motion, found, 1);
  ASSERT_TRUE(red);
  EXPECT_EQ(red->light, FitLight::red);
  EXPECT_EQ(red->reason.english(), "the tissue has 125.0 ml, in the labelled phases 100.0 to 100.0 ml");
  EXPECT_EQ(wallAt(record.motion, nullptr, 1)->light, FitLight::good) << "all phases are measured";
  EXPECT_FALSE(wallAt({}, found, 0));
}

} // namespace
} // namespace viscera::live
