#include <algorithm>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "phantom_scan.h"
#include "report_scene.h"
#include "viscera/core/error.h"
#include "viscera/core/text.h"
#include "viscera/document/scan_item.h"
#include "viscera/document/stress_mark_commands.h"
#include "viscera/live/cycle_curves.h"
#include "viscera/live/strain_reading.h"
#include "words.h"

namespace viscera::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Report, TellsVolumesAtRestNowChangeAndLockAndWhatIsMeasured) {
  ReportedSession session;
  document::MeasuredPoint from, to;
  to.rest = {30, 40, 0};
  session.undo.perform(document::addMeasurement({from, to}, "Long axis"));
  session.undo.perform(document::setVolumeLocked(session.organ(), true));
  session.pose();
  const live::OrganVolume volume = session.live.volume(session.organ());
  ASSERT_GT(volume.changeMl(), 1);
  const report::Report report = session.report(session.source());
  const report::Section* section = sectionOf(report, "Volumes");
  ASSERT_NE(section, nullptr);
  const std::vector<std::string> row = tablesOf(*section).at(0).rows.at(0);
  EXPECT_EQ(row[0], "Ball");
  EXPECT_EQ(row[1], fixed(volume.restMl, 1));
  EXPECT_EQ(row[2], fixed(volume.nowMl, 1));
  EXPECT_EQ(row[3][0], '+');
  EXPECT_EQ(row[4], "+" + fixed(100 * volume.relativeChange(), 1));
  EXPECT_EQ(row[5], "locked");
  const report::Section* measured = sectionOf(report, "Measurements");
  ASSERT_NE(measured, nullptr);
  EXPECT_THAT(tablesOf(*measured).at(0).rows.at(0),
              ElementsAre("Long axis", "distance", "-", "50.0 mm", "50.0 mm", "0.0"));
}

TEST(Report, NamesThePatientAndTheDateOfTheStudyWhereTheScanDoes) {
  ReportedSession session;
  const auto rowsOf = [&](const std::string& name, const std::string& date) {
    medical_io::Scan scan = tests::phantomScan({9, 9, 9}, Vec3(10, 10, 10), Vec3(-40, -40, -40),
                                               tests::ballValue(Vec3::Zero(), 30));
    scan.patientName = name;
    scan.studyDate = date;
    session.undo.perform(document::openScan(document::scanItem(std::move(scan), {})));
    const report::Report report = session.report(session.source());
    return std::get<report::Table>(report.sections.front().blocks.front()).rows;
  };
  const auto known = rowsOf("Doe, Jane", "20240301");
  EXPECT_THAT(known.at(0), ElementsAre("Patient", "Doe, Jane"));
  EXPECT_EQ(known.at(1).at(0), "Study date");
  EXPECT_NE(known.at(1).at(1).find("2024"), std::string::npos) << known.at(1).at(1);
  EXPECT_EQ(rowsOf("", "spring").at(0), (std::vector<std::string>{"Study date", "spring"}));
  EXPECT_EQ(rowsOf("", "").at(0).at(0), "Organs");
}

TEST(Report, WritesTheNamesOfMeasuredOrgansAsPeopleDo) {
  ReportedSession session({"small_bowel"});
  const document::Organ& organ = *session.document.organs().back();
  session.undo.perform(document::addMeasurement(
      {document::surfacePoint(organ, 0, Vec3(1, 0, 0)), document::surfacePoint(organ, 5, Vec3(1, 0, 0))},
      "Width"));
  const report::Report report = session.report(session.source());
  EXPECT_EQ(tablesOf(*sectionOf(report, "Measurements")).at(0).rows.at(0).at(2), "Small bowel");
}

TEST(Report, TakesTheMotionOfTheWarpedScanForWhatIsMeasuredOnIt) {
  ReportedSession session;
  document::MeasuredPoint from, to;
  to.rest = {30, 40, 0};
  session.undo.perform(document::addMeasurement({from, to}, "Long axis"));
  report::ReportSource source = session.source();
  source.tissue = [](const Vec3& rest) { return Vec3(2 * rest); };
  const report::Report report = session.report(source);
  EXPECT_THAT(tablesOf(*sectionOf(report, "Measurements")).at(0).rows.at(0),
              ElementsAre("Long axis", "distance", "-", "50.0 mm", "100.0 mm", "+50.0"));
}

TEST(Report, DrawsSixSidesAndTheViewAndLeavesOutWhatThereIsNot) {
  ReportedSession session({"Ball", "Left ball"});
  const report::Report report = session.report(session.source());
  EXPECT_EQ(report.pictures(), 7);
  EXPECT_EQ(report.title, "Ball");
  EXPECT_THAT(report.made, HasSubstr("1 March 2026"));
  for (const char* title : {"Measurements", "Tissue distortion (rotational stress)", "Motion"})
    EXPECT_EQ(sectionOf(report, title), nullptr) << title;
  const auto& sides = std::get<report::PictureGrid>(report.sections.front().blocks.at(2));
  EXPECT_EQ(sides.pictures.at(0).caption, "From the front");
  EXPECT_NE(sides.pictures.at(0).png, sides.pictures.at(3).png) << "the letters of the cube differ";
}

TEST(Report, GivesAnEjectionFractionToVentriclesOnlyAndKeepsThePose) {
  ReportedSession session({"Ball", "LV"});
  session.record();
  report::ReportSource source = session.source();
  source.sequence = document::sequenceOf(session.document.keySequence(), session.document.rig());
  source.ratePerMinute = 30;
  const Points before = session.live.shownPose();
  const report::Report report = session.report(source);
  EXPECT_EQ(session.live.shownPose(), before);
  const report::Section* section = sectionOf(report, "Motion");
  ASSERT_NE(section, nullptr);
  const std::vector<report::Table> tables = tablesOf(*section);
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(tables[0].rows.size(), 2u);
  ASSERT_EQ(tables[1].rows.size(), 1u);
  EXPECT_EQ(tables[1].rows[0][0], "LV cavity");
  live::MotionRunner runner(session.document.state(), session.live);
  runner.setSequence(source.sequence);
  Progress progress;
  const auto curve = live::measureCycle(runner, progress).milliliters.at(1);
  EXPECT_EQ(tables[1].rows[0][1], fixed(*std::max_element(curve.begin(), curve.end()), 1));
  const report::Section* strain = sectionOf(report, "Strain");
  ASSERT_NE(strain, nullptr);
  const live::StrainReading reading =
      live::readStrain(live::movedOrgans(runner, session.registry, 50, progress), {}, progress);
  const std::string gls = fixed(100 * reading.strain.gls->peak.value, 1);
  EXPECT_TRUE(std::any_of(strain->blocks.begin(), strain->blocks.end(), [&gls](const report::Block& block) {
    const auto* said = std::get_if<report::Paragraph>(&block);
    return said && said->text.rfind("GLS " + gls + " %", 0) == 0;
  })) << gls;
  ReportedSession still({"Ball"});
  still.record();
  source = still.source();
  source.sequence = document::sequenceOf(still.document.keySequence(), still.document.rig());
  const report::Report ofBall = still.report(source);
  EXPECT_EQ(tablesOf(*sectionOf(ofBall, "Motion")).size(), 1u) << "a ball has no ejection fraction";
  EXPECT_EQ(sectionOf(ofBall, "Strain"), nullptr);
}

TEST(Report, GivesTheNumbersOfAVentricleForEachSquareMetreAndAtTheChosenEnds) {
  ReportedSession session({"Ball", "LV"});
  session.record();
  report::ReportSource source = session.source();
  source.sequence = document::sequenceOf(session.document.keySequence(), session.document.rig());
  source.view.person.bodySurfaceM2 = 2;
  source.view.cycleEnds.systole = 0; // At rest, where the volume is not the smallest.
  const std::vector<report::Table> tables = tablesOf(*sectionOf(session.report(source), "Motion"));
  ASSERT_EQ(tables.size(), 3u);
  const std::string rest = fixed(session.document.organ(session.organ(1))->restVolumeMm3 / 1000, 1);
  EXPECT_EQ(tables[1].rows[0][2], rest);
  ASSERT_EQ(tables[2].rows.size(), 4u) << "an ejection fraction has no size";
  EXPECT_EQ(tables[2].rows[1][1], "end-systolic volume");
  EXPECT_EQ(tables[2].rows[1][2], rest + " ml");
  EXPECT_EQ(tables[2].rows[1][3], fixed(session.document.organ(session.organ(1))->restVolumeMm3 / 2000, 1));
}

TEST(Report, CountsTheKeysOfARecordedCycleAndNamesItsEnds) {
  ReportedSession session;
  session.record();
  for (const double more : {1.25, 1.5, 1.75})
    session.undo.perform(document::recordKey(more));
  report::ReportSource source = session.source();
  source.sequence = document::sequenceOf(session.document.keySequence(), session.document.rig());
  const std::vector<double> keys = source.sequence->keys();
  ASSERT_EQ(keys.size(), 5U);
  source.ratePerMinute = source.sequence->standardRatePerMinute() / 2; // All instants twice as late.
  const report::Report report = session.report(source);
  const auto& facts = std::get<report::Table>(sectionOf(report, "Motion")->blocks.front());
  EXPECT_THAT(facts.rows.at(2),
              ElementsAre("Phases", "5 keys, the first at " + fixed(2 * keys.front(), 3) +
                                        " s, the last at " + fixed(2 * keys.back(), 3) + " s"));
}

TEST(Report, NamesTheFilesOfOrgansAndWhatTheyAre) {
  const auto reportOn = [](std::vector<std::string> names) {
    ReportedSession session{std::vector<std::string>()};
    for (const std::string& name : names) {
      document::NewOrgan organ = ball(name, 30);
      organ.organ.file = "/data/Doe/" + name + "_00.obj";
      session.undo.perform(document::addOrgans({organ}));
    }
    return session.report(session.source());
  };
  const report::Report heart = reportOn({"patient1", "patient1_LV_ENDOCARDIAL"});
  EXPECT_EQ(heart.title, "Heart (Patient1)") << "a patient's number tells no organ";
  const report::Table files = tablesOf(*sectionOf(heart, "Files and what was done to them")).at(0);
  EXPECT_EQ(files.rows.at(0).at(1), "patient1_00.obj");
  EXPECT_EQ(files.rows.at(1).at(1), "patient1_LV_ENDOCARDIAL_00.obj");
  EXPECT_EQ(reportOn({"liver"}).title, "Liver");
  EXPECT_EQ(reportOn({"patient1"}).title, "Patient1");
}

TEST(Report, TellsStressWithItsMethodPercentilesAndPictures) {
  ReportedSession session;
  live::LiveStress::Options options;
  options.frameSeconds = std::numeric_limits<double>::infinity();
  live::LiveStress stress(session.document, session.registry, session.live, session.jobs, options);
  stress.setWanted(400);
  stress.follow(session.organ());
  session.box.runUntil([&] { return session.jobs.idle(); });
  session.pose();
  live::StressCopy copy = stress.copy();
  report::ReportSource source = session.source();
  source.stress = &copy;
  source.stressStatus = stress.status();
  const report::Report report = session.report(source);
  const report::Section* section = sectionOf(report, "Tissue distortion (rotational stress)");
  ASSERT_NE(section, nullptr);
  const report::Table numbers = tablesOf(*section).at(0);
  EXPECT_EQ(numbers.rows.size(), 4u);
  EXPECT_EQ(numbers.rows[0][0], "Rotational stress (deg)");
  EXPECT_EQ(numbers.rows[0][5], fixed(180 / std::numbers::pi * stress.statistics().max, 1));
  EXPECT_EQ(report.pictures(), 9) << "the map and its histogram";
  // What was pinned stands in a table of its own, and the profile in a chart.
  const Vec3 first = stress.mesh()->points.row(0).transpose(),
             last = stress.mesh()->points.row(9).transpose();
  session.undo.perform(document::addStressProbe(session.organ(), first));
  session.undo.perform(document::addStressProbe(session.organ(), last));
  const auto& pinned = session.document.stressMarks().probes;
  session.undo.perform(document::addStressLine(pinned[0].id, pinned[1].id));
  report::ReportSource marked = session.source();
  marked.stress = &copy;
  marked.stressStatus = stress.status();
  const report::Report with = session.report(marked);
  const report::Table probes = tablesOf(*sectionOf(with, "Tissue distortion (rotational stress)")).at(1);
  ASSERT_EQ(probes.rows.size(), 2u);
  EXPECT_EQ(probes.rows[1][0], "2");
  EXPECT_EQ(probes.rows[1][2], fixed(180 / std::numbers::pi * stress.map().rotationalStress[9], 1));
  EXPECT_EQ(with.pictures(), 10);
}

TEST(Report, OfNothingIsRefused) {
  BoundSession session;
  session.undo.perform(document::removeOrgans({session.organ()}));
  report::ReportSource source;
  source.state = session.document.state();
  source.organs = &session.live;
  source.systems = &session.registry;
  Progress progress;
  EXPECT_THROW(report::makeReport(source, {}, progress), UsageError);
}

TEST(WithoutFolders, LeavesTheNamesOfFiles) {
  EXPECT_EQ(report::withoutFolders("/home/ann/liver.stl: it has holes"), "liver.stl: it has holes");
  EXPECT_EQ(report::withoutFolders("read \"/data/Ann Smith/1956/liver.stl\""), "read \"liver.stl\"");
  EXPECT_EQ(report::withoutFolders("C:\\Patients\\Smith\\liver.stl"), "liver.stl");
  EXPECT_EQ(report::withoutFolders("../smith/liver.stl"), "liver.stl");
  EXPECT_EQ(report::withoutFolders("its unit is mm / ml and/or cm"), "its unit is mm / ml and/or cm");
}

} // namespace
} // namespace viscera::tests
