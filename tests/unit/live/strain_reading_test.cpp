#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "held_value.h"
#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/live/strain_reading.h"

namespace viscera::live {
namespace {

/// A ventricle: an ellipsoid that is cut off at the valves' plane, z = 0, with its apex at z = `depth`.
std::shared_ptr<const geometry::TriangleMesh> ventricle(double radius, double depth, const Vec3& middle) {
  auto mesh = std::make_shared<geometry::TriangleMesh>(tests::sphere(4));
  for (Eigen::Index row = 0; row < mesh->points.rows(); ++row) {
    const double z = mesh->points(row, 2);
    mesh->points.row(row) << radius * mesh->points(row, 0), radius * mesh->points(row, 1),
        std::max(0.0, z) * depth;
    mesh->points.row(row) += middle.transpose();
  }
  return mesh;
}

/// A heart whose handles narrow it by a fifth and shorten it by a tenth, as one affine map.
MovedOrgans heart(const Vec3& scale = {0.8, 0.8, 0.9}) {
  MovedOrgans moved;
  moved.organs = {{"EPI", ventricle(34, 95, Vec3::Zero())},
                  {"LV", ventricle(20, 80, Vec3(0, 0, 0.5))},
                  {"RV", ventricle(12, 60, Vec3(-52, 0, 0.5))}};
  moved.handles.positions = deformation::placeHandles(tests::sphere(4, 140), {.count = 40});
  moved.system = coordinates::builtInRegistry().find("s-celestial");
  for (int phase = 0; phase < 5; ++phase) {
    const double part = std::sin(3.14159265358979 * phase / 4);
    moved.seconds.push_back(0.2 * phase);
    moved.poses.push_back(moved.handles.positions *
                          (Vec3::Ones() + part * (scale - Vec3::Ones())).asDiagonal());
  }
  moved.corresponding = true;
  return moved;
}

StrainOptions fewWitnesses() {
  StrainOptions options;
  options.witnesses = 9000;
  return options;
}

TEST(StrainReading, OfAnAffineBeatIsItsStretchInEachSegment) {
  Progress progress;
  const StrainReading reading = readStrain(heart(), fewWitnesses(), progress);
  EXPECT_EQ(reading.left, "LV");
  EXPECT_EQ(reading.right, "RV");
  EXPECT_EQ(reading.outer, "EPI");
  EXPECT_GT(reading.witnesses, 1000);
  EXPECT_NEAR(reading.strain.gcs->peak.value, -0.2, 1e-6);
  for (const int number : {1, 4, 5, 6, 7, 10, 11, 12}) {
    const strain::SegmentStrain& segment = reading.strain.segment(number);
    EXPECT_TRUE(reading.reliable(segment)) << number;
    EXPECT_NEAR(segment.circumferential[2], -0.2, 0.01) << number;
    EXPECT_GT(segment.longitudinal[2], -0.15) << number;
    EXPECT_LT(segment.longitudinal[2], -0.08) << number;
  }
}

/// Only in a heart with a right ventricle do the segments between both lie on its side.
TEST(StrainReading, SegmentsOfTheSeptumLieOnTheRightVentriclesSide) {
  Progress progress;
  const StrainReading reading = readStrain(heart(), fewWitnesses(), progress);
  ASSERT_TRUE(reading.strain.oriented);
  for (const strain::Segment& segment : strain::segments())
    if (segment.ring < 2) {
      const double middle = (0.5 * (segment.fromDegrees + segment.toDegrees) - 120) * 3.14159265 / 180;
      EXPECT_EQ(reading.strain.axes.across(middle).x() < -0.5, segment.septal) << segment.name;
    }
}

TEST(StrainReading, IsTheSameWithSixtyAndAHundredAndTwentyHandles) {
  Progress progress;
  MovedOrgans sixty = heart(), more = heart();
  const auto withHandles = [](MovedOrgans& moved, int count) {
    moved.handles.positions = deformation::placeHandles(tests::sphere(4, 140), {.count = count});
    for (std::size_t phase = 0; phase < moved.poses.size(); ++phase) {
      const double part = std::sin(0.785398163 * static_cast<double>(phase));
      moved.poses[phase] = moved.handles.positions * (Vec3::Ones() - part * Vec3(0.2, 0.2, 0.1)).asDiagonal();
      for (Eigen::Index row = 0; row < moved.poses[phase].rows(); ++row) { // A twist is no affine map.
        const double turn = 0.15 * part * moved.handles.positions(row, 2) / 80;
        moved.poses[phase].row(row) *= Eigen::AngleAxisd(-turn, Vec3::UnitZ()).toRotationMatrix();
      }
    }
  };
  withHandles(sixty, 60);
  withHandles(more, 120);
  const StrainReading a = readStrain(sixty, fewWitnesses(), progress),
                      b = readStrain(more, fewWitnesses(), progress);
  tests::HeldValue held("60 and 120 handles", 1, "points");
  held.add(100 * (a.strain.gls->peak.value - b.strain.gls->peak.value));
  held.add(100 * (a.strain.gcs->peak.value - b.strain.gcs->peak.value));
  held.add(100 * (a.strain.grs->peak.value - b.strain.grs->peak.value));
}

TEST(StrainReading, WithoutAnOuterSurfaceIsThatOfTheEndocardium) {
  Progress progress;
  MovedOrgans moved = heart();
  moved.organs.erase(moved.organs.begin());
  const StrainReading reading = readStrain(moved, {}, progress);
  EXPECT_TRUE(reading.outer.empty());
  EXPECT_FALSE(reading.strain.grs);
  EXPECT_FALSE(strainValue(reading, 7, StrainDirection::radial, StrainMoment::peak));
  EXPECT_NEAR(*strainValue(reading, 7, StrainDirection::circumferential, StrainMoment::peak), -20, 1);
  EXPECT_NEAR(*strainValue(reading, 7, StrainDirection::circumferential, StrainMoment::timeToPeak), 400,
              1e-6);
}

/// A series may begin before the end of diastole, as the textbook's beat does.
TEST(StrainReading, BeginsWhereTheVentricleIsFullest) {
  Progress progress;
  MovedOrgans moved = heart();
  moved.organs.erase(moved.organs.begin());
  std::rotate(moved.poses.begin(), moved.poses.begin() + 2, moved.poses.end());
  const StrainReading found = readStrain(moved, {}, progress);
  EXPECT_NEAR(static_cast<double>(found.strain.reference), 2.5, 0.5) << "the last phase or the first one";
  EXPECT_NEAR(*strainValue(found, 7, StrainDirection::circumferential, StrainMoment::peak), -20, 1);
  StrainOptions first;
  first.reference = 0;
  const StrainReading asked = readStrain(moved, first, progress);
  EXPECT_EQ(asked.strain.reference, 0U);
  EXPECT_EQ(asked.warnings.size(), found.warnings.size() + 1) << "fuller in another phase";
}

TEST(StrainReading, SaysWhatCannotBeReliedOn) {
  Progress progress;
  MovedOrgans moved = heart();
  moved.corresponding = false;
  const StrainReading reading = readStrain(moved, fewWitnesses(), progress);
  EXPECT_FALSE(reading.reliable(reading.strain.segment(7)));
  EXPECT_FALSE(reading.warnings.empty());
  moved.organs.pop_back();
  EXPECT_FALSE(readStrain(moved, fewWitnesses(), progress).strain.oriented);
  moved.organs.pop_back();
  EXPECT_THROW(readStrain(moved, fewWitnesses(), progress), DataError);
}

TEST(StrainReading, NamesOfSurfacesThatDoNotExistAreRefused) {
  Progress progress;
  StrainOptions options = fewWitnesses();
  options.left = "liver";
  EXPECT_THROW(readStrain(heart(), options, progress), UsageError);
}

TEST(StrainReading, WritesWhatIsMeasured) {
  Progress progress;
  MovedOrgans moved = heart();
  moved.organs.erase(moved.organs.begin());
  const StrainReading reading = readStrain(moved, {}, progress);
  const auto json = parseJson<nlohmann::ordered_json>(strainJson(reading), "strain", {});
  EXPECT_EQ(json["segments"].size(), 17U);
  EXPECT_EQ(json["phases"].size(), 5U);
  EXPECT_NEAR(json["gcs"]["peakPercent"].get<double>(), -20, 1e-4);
  EXPECT_NEAR(json["gcs"]["middle"]["peakPercent"].get<double>(), -20, 1e-4);
  const tests::TemporaryFolder folder;
  writeStrainTable(folder.path() / "strain.csv", reading);
  std::ifstream table(folder.path() / "strain.csv");
  std::string head;
  std::getline(table, head);
  EXPECT_EQ(head.substr(0, 30), "time_s,gls_percent,gcs_percent");
  std::istringstream cells(head);
  std::set<std::string> columns;
  for (std::string cell; std::getline(cells, cell, ',');)
    EXPECT_TRUE(columns.insert(cell).second) << cell << " is there twice";
  for (const std::string& column : columns) {
    std::string plain;
    for (const char letter : column) {
      if (std::isupper(static_cast<unsigned char>(letter)) && !plain.empty() && plain.back() != '_')
        plain += '_';
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
    EXPECT_EQ(columns.count(plain), 1U) << column << " has no name in small letters beside it";
  }
}

/// Vertices are counted as in the file, whatever has become of repeated ones.
TEST(StrainReading, ContoursOfOtherProgramsAreByTheNumbersOfTheirFiles) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "lists.json";
  std::ofstream(file) << R"({"contours": [{"name": "4ch", "surface": "LV", "vertices": [3, 4, 5]},
                             {"name": "mid", "vertices": [5, 6, 7], "closed": true}], "firstIndex": 1})";
  std::vector<strain::ListedContour> lists = readContours(file);
  ASSERT_EQ(lists.size(), 2U);
  EXPECT_EQ(lists[0].name, "fourChamber");
  EXPECT_EQ(lists[0].vertices, (std::vector<std::int32_t>{2, 3, 4}));
  EXPECT_EQ(lists[1].name, "middle");
  EXPECT_TRUE(lists[1].closed);
  std::ofstream(file) << R"({"4ch": [1, 2], "base": [2, 3], "rvfw": [1, 5]})";
  lists = readContours(file);
  ASSERT_EQ(lists.size(), 3U);
  EXPECT_EQ(lists[2].name, "rightFreeWall");
  EXPECT_EQ(lists[2].surface, "RV");
  std::ofstream(file) << R"({"tail": "here"})";
  EXPECT_THROW(readContours(file), DataError);

  Progress progress;
  MovedOrgans moved = heart();
  moved.organs.erase(moved.organs.begin());
  StrainOptions options;
  options.contours = {{"base", "", {0, 1, 2, 3}, false}, {"septum", "RV", {0, 1, 2}, false}};
  const StrainReading both = readStrain(moved, options, progress);
  ASSERT_EQ(both.strain.others.size(), 1U);
  EXPECT_EQ(both.strain.others.front().name, "septum");
  const double direct = readStrain(moved, options, progress).strain.circumferential.front().referenceMm;
  // In the file every point came twice.
  for (const SequenceOrgan& organ : moved.organs) {
    std::vector<std::int32_t>& rows = moved.rowOfGiven.emplace_back();
    for (std::int32_t row = 0; row < 2 * organ.mesh->points.rows(); ++row)
      rows.push_back(row / 2);
  }
  options.contours = {{"base", "", {0, 3, 5, 6}, false}};
  EXPECT_DOUBLE_EQ(readStrain(moved, options, progress).strain.circumferential.front().referenceMm, direct);
}

/// A gauge is made once, and reads other poses of the same handles as if it were made for them.
TEST(StrainReading, AGaugeReadsOtherPosesOfTheSameHandles) {
  Progress progress;
  const StrainGauge gauge(heart(), fewWitnesses(), progress);
  MovedOrgans pose = heart({0.9, 0.9, 0.95});
  pose.seconds = {0, 1};
  pose.poses = {pose.handles.positions, pose.poses[2]};
  const StrainReading read = gauge.read(pose, progress);
  const StrainReading made = readStrain(pose, fewWitnesses(), progress);
  ASSERT_EQ(read.strain.seconds.size(), 2U);
  EXPECT_NEAR(read.strain.gcs->curve[1], -0.1, 1e-6);
  EXPECT_EQ(read.strain.gls->curve, made.strain.gls->curve);
  EXPECT_EQ(read.strain.segment(8).radial, made.strain.segment(8).radial);
  pose.poses[1] = 1.1 * pose.handles.positions;
  EXPECT_EQ(gauge.read(pose, progress).strain.reference, 1U) << "the end of diastole";
  EXPECT_NEAR(gauge.read(pose, progress, {}, 0).strain.gcs->curve[1], 0.1, 1e-6) << "as asked";
}

/// On the surface around both ventricles only what is nearer to the left one has segments.
TEST(StrainReading, VerticesOfTheLeftVentriclesWallKnowTheirSegments) {
  Progress progress;
  MovedOrgans organs = heart();
  organs.organs[0].mesh = ventricle(70, 95, Vec3::Zero()); // Around both.
  const StrainGauge gauge(organs, fewWitnesses(), progress);
  EXPECT_TRUE(gauge.segmentsOn(2).empty()) << "the right ventricle";
  const Points& outer = organs.organs[0].mesh->points;
  const std::vector<int>& around = gauge.segmentsOn(0);
  ASSERT_EQ(around.size(), static_cast<std::size_t>(outer.rows()));
  int left = 0, right = 0;
  for (Eigen::Index row = 0; row < outer.rows(); ++row) {
    if (outer(row, 2) < 20 || outer(row, 2) > 50)
      continue;
    const int segment = around[static_cast<std::size_t>(row)];
    if (outer(row, 0) > 30)
      left += segment > 0 ? 1 : -1000;
    if (outer(row, 0) < -60)
      right += segment == 0 ? 1 : -1000;
  }
  EXPECT_GT(left, 0);
  EXPECT_GT(right, 0);
  geometry::TriangleMesh stub = *organs.organs[0].mesh; // A vessel that leaves the surface there.
  Eigen::Index tip = -1;
  for (Eigen::Index row = 0; row < outer.rows() && tip < 0; ++row)
    if (around[static_cast<std::size_t>(row)] > 0 && outer(row, 0) > 30)
      tip = row;
  ASSERT_GE(tip, 0);
  stub.points.row(tip).head<2>() *= 4;
  organs.organs[0].mesh = std::make_shared<const geometry::TriangleMesh>(stub);
  const StrainGauge withStub(organs, fewWitnesses(), progress);
  EXPECT_EQ(withStub.segmentsOn(0)[static_cast<std::size_t>(tip)], 0);
  std::set<int> inside(gauge.segmentsOn(1).begin(), gauge.segmentsOn(1).end());
  inside.erase(0);
  EXPECT_GE(inside.size(), 16U) << "the cap may lie beyond the tip of the cavity";
}

} // namespace
} // namespace viscera::live
