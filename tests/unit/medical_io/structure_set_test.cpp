#include <string>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "structure_sets.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/image_beside.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_surfaces.h"

/// Contours that were drawn for radiotherapy.
namespace viscera::medical_io {
namespace {

using testing::HasSubstr;
using tests::circleArea;
using tests::circleAt;
using tests::DrawnStructure;

/// Circles of a ball's slices, `step` apart.
DrawnStructure ball(int number, const std::string& name, const Vec3& center, double radius, double step) {
  DrawnStructure drawn{number, name, "10\\200\\30", {}};
  for (double z = -radius + 0.5 * step; z < radius; z += step)
    drawn.contours.push_back({circleAt(center + Vec3(0, 0, z), std::sqrt(radius * radius - z * z))});
  return drawn;
}

/// Sum of area times distance, ml.
double planarMl(double radius, double step) {
  double volume = 0;
  for (double z = -radius + 0.5 * step; z < radius; z += step)
    volume += circleArea(std::sqrt(radius * radius - z * z)) * step;
  return volume / 1000;
}

class StructureSets : public testing::Test {
protected:
  LabelMap read(const std::vector<DrawnStructure>& structures) {
    Progress progress;
    return readLabelMap(put(structures), progress);
  }
  std::filesystem::path put(const std::vector<DrawnStructure>& structures,
                            const tests::StructureWriting& writing = {}, const char* name = "RS.1.2.8") {
    return folder_.put(name, tests::dicomBytes(tests::structureElements(structures, writing)));
  }
  std::string refusal(const std::string& bytes) {
    Progress progress;
    try {
      readLabelMap(folder_.put("RS.bad", bytes), progress);
    } catch (const DataError& error) {
      return error.what();
    }
    return "nothing was refused";
  }
  static const Segment& named(const LabelMap& map, const std::string& name) {
    for (const Segment& segment : map.segments)
      if (segment.name == name)
        return segment;
    throw std::runtime_error("there is no " + name);
  }
  static double ml(const LabelMap& map, const std::string& name) { return map.volumeMl(named(map, name)); }
  static std::string warnings(const LabelMap& map) {
    std::string all;
    for (const Text& one : map.warnings)
      all += one.english() + '\n';
    return all;
  }
  tests::TemporaryFolder folder_;
};

TEST_F(StructureSets, AreFilledWithTheirNumbersNamesColoursAndVolumes) {
  const LabelMap map = read({ball(4, "Liver", {-60, 10, 80}, 40, 3), ball(7, "GTV", {-70, 15, 90}, 8, 3)});
  EXPECT_TRUE(isLabelMap(folder_ / "RS.1.2.8"));
  ASSERT_EQ(map.segments.size(), 2U);
  EXPECT_NEAR(ml(map, "Liver"), planarMl(40, 3), 0.01 * planarMl(40, 3));
  EXPECT_NEAR(ml(map, "GTV"), planarMl(8, 3), 0.01 * planarMl(8, 3));
  EXPECT_EQ(named(map, "Liver").label, 4);
  EXPECT_EQ(named(map, "GTV").label, 7);
  EXPECT_LT((named(map, "GTV").color - Vec3(10, 200, 30) / 255).norm(), 1e-9);
  EXPECT_NE(named(map, "GTV").layer, named(map, "Liver").layer) << "one lies within the other";
  EXPECT_NEAR(map.spacing().z(), 3, 1e-9);
  EXPECT_EQ(warnings(map), "");
  Progress progress;
  const std::vector<LabelSurface> surfaces = labelSurfaces(map, {}, progress);
  ASSERT_EQ(surfaces.size(), 2U);
  EXPECT_LT((boundsOf(surfaces[0].mesh.points).center() - Vec3(-60, 10, 80)).norm(), 1);
}

TEST_F(StructureSets, HaveHolesWhereAContourLiesWithinAnotherOrRunsToItAndBack) {
  DrawnStructure ring{1, "Ring", "1\\2\\3", {}}, keyhole{2, "Keyhole", "1\\2\\3", {}};
  for (int k = 0; k < 8; ++k) {
    ring.contours.push_back({circleAt({0, 0, 2.5 * k}, 30)});
    ring.contours.push_back({circleAt({4, 0, 2.5 * k}, 15)});
    const Points outer = circleAt({0, 100, 2.5 * k}, 30), inner = circleAt({4, 100, 2.5 * k}, 15);
    Points joined(outer.rows() + inner.rows() + 2, 3);
    joined << outer, outer.row(0), inner.row(0), inner.bottomRows(inner.rows() - 1).colwise().reverse(),
        inner.row(0);
    keyhole.contours.push_back({joined});
  }
  const LabelMap map = read({ring, keyhole});
  const double expected = 8 * 2.5 * (circleArea(30) - circleArea(15)) / 1000;
  EXPECT_NEAR(ml(map, "Ring"), expected, 0.01 * expected);
  EXPECT_NEAR(ml(map, "Keyhole"), expected, 0.01 * expected);
}

TEST_F(StructureSets, GetTheShapeBetweenContoursWhereSlicesAreMissing) {
  DrawnStructure whole = ball(1, "Liver", {0, 0, 0}, 40, 2.5), thinned = whole;
  thinned.contours.erase(thinned.contours.begin() + 12, thinned.contours.begin() + 15);
  const LabelMap map = read({thinned});
  EXPECT_NEAR(ml(map, "Liver"), planarMl(40, 2.5), 0.01 * planarMl(40, 2.5));
  EXPECT_THAT(warnings(map), HasSubstr("3 slices of Liver without a contour"));
  // Every second slice is drawn, beside an organ of all: its slices between are no remark.
  DrawnStructure sparse = ball(2, "Sparse", {120, 0, 0}, 40, 5);
  for (tests::DrawnContour& contour : sparse.contours)
    contour.corners.col(2).array() += 1.25;
  const LabelMap both = read({whole, sparse});
  EXPECT_NEAR(ml(both, "Sparse"), planarMl(40, 5), 0.01 * planarMl(40, 5));
  EXPECT_EQ(warnings(both), "");
}

TEST_F(StructureSets, KeepTheGapBetweenTwoPieces) {
  DrawnStructure kidneys = ball(1, "Kidneys", {0, 0, 0}, 20, 3);
  for (const tests::DrawnContour& contour : ball(1, "", {0, 0, 90}, 20, 3).contours)
    kidneys.contours.push_back(contour);
  const LabelMap map = read({kidneys});
  EXPECT_NEAR(ml(map, "Kidneys"), 2 * planarMl(20, 3), 0.02 * planarMl(20, 3));
  EXPECT_THAT(warnings(map), HasSubstr("stays open"));
}

/// Slices of 2, 3 and 5 mm in turn.
TEST_F(StructureSets, MayLieAtUnequalDistances) {
  DrawnStructure tube{1, "Aorta", "1\\2\\3", {}};
  double z = 0;
  for (int k = 0; k < 30; ++k) {
    tube.contours.push_back({circleAt({0, 0, z}, 12)});
    z += k % 3 == 0 ? 2 : k % 3 == 1 ? 3 : 5;
  }
  const LabelMap map = read({tube});
  const double expected = circleArea(12) * (z - 5 + 3) / 1000; // And half a usual slice at each end.
  EXPECT_NEAR(ml(map, "Aorta"), expected, 0.025 * expected);
}

TEST_F(StructureSets, MayLieAslantAndLeaveOutWhatIsNoClosedContourOfTheirDirection) {
  const Eigen::Affine3d turn(Eigen::AngleAxisd(0.4, Vec3(1, 2, 0.5).normalized()));
  DrawnStructure organ = ball(1, "Spleen", {30, 20, 10}, 25, 4);
  for (tests::DrawnContour& contour : organ.contours)
    contour.corners = (contour.corners * turn.linear().transpose()).eval();
  organ.contours.push_back({circleAt({0, 0, 0}, 5)});
  DrawnStructure marks{2, "Marker", "1\\2\\3", {{circleAt({0, 0, 0}, 1, 3).topRows(1), "POINT"}}};
  marks.contours.push_back({circleAt({0, 0, 0}, 9), "OPEN_PLANAR"});
  const LabelMap map = read({organ, marks});
  ASSERT_EQ(map.segments.size(), 1U);
  EXPECT_NEAR(ml(map, "Spleen"), planarMl(25, 4), 0.01 * planarMl(25, 4));
  EXPECT_THAT(warnings(map), HasSubstr("2 points and open contours were left out"));
  EXPECT_THAT(warnings(map), HasSubstr("1 contour was left out, which lies in another direction"));
  EXPECT_THAT(warnings(map), HasSubstr("1 segment has no voxels (Marker)"));
}

TEST_F(StructureSets, OfOneSliceSayThatItsThicknessIsAGuess) {
  const LabelMap map = read({{1, "Liver", "1\\2\\3", {{circleAt({0, 0, 0}, 20)}}}});
  EXPECT_NEAR(ml(map, "Liver"), circleArea(20) * 3 / 1000, 0.05);
  EXPECT_THAT(warnings(map), HasSubstr("one plane"));
}

TEST_F(StructureSets, ThatAreDamagedOrEmptyAreRefusedOrLeaveOutWhatIsDamaged) {
  EXPECT_THAT(refusal(tests::dicomBytes(tests::structureElements({}))), HasSubstr("without regions"));
  EXPECT_THAT(refusal(tests::dicomBytes(tests::structureElements({{1, "Liver", "1\\2\\3", {}}}))),
              HasSubstr("without closed contours"));
  const std::string whole = tests::dicomBytes(tests::structureElements({ball(1, "Liver", {0, 0, 0}, 30, 3)}));
  EXPECT_NE(refusal(whole.substr(0, whole.size() / 2)), "nothing was refused");
  DrawnStructure far = ball(1, "Liver", {0, 0, 0}, 30, 3);
  far.contours.push_back({circleAt({0, 0, 5e8}, 30)});
  EXPECT_NE(refusal(tests::dicomBytes(tests::structureElements({far}))), "nothing was refused");
  std::string odd = whole;
  const std::size_t at = odd.find("\\", odd.find("CLOSED_PLANAR"));
  odd[at] = 'x'; // Two numbers become none.
  Progress progress;
  const LabelMap map = readLabelMap(folder_.put("RS.odd", odd), progress);
  EXPECT_THAT(warnings(map), HasSubstr("1 contour was left out, whose numbers cannot be read"));
}

TEST_F(StructureSets, OpenWithTheSeriesThatTheyWereDrawnOn) {
  tests::LabelImage image = tests::emptyLabels({24, 20, 16});
  image.indexToLps.linear() = Vec3(2, 2, 3).asDiagonal();
  std::filesystem::create_directories(folder_ / "ct");
  for (int k = 0; k < image.size[2]; ++k) {
    tests::DicomElements slice = tests::dicomSlice(image, k);
    slice[0x00200052] = "UI1.2.9";
    folder_.put("ct/" + std::to_string(k), tests::dicomBytes(slice));
  }
  const std::vector<DrawnStructure> organs = {ball(1, "Liver", {20, 20, 20}, 10, 3)};
  Progress progress;
  const auto scanOf = [&](const std::filesystem::path& file) {
    return imageBeside(file, ImageContents::values, progress);
  };
  EXPECT_EQ(scanOf(put(organs, {.referencedSeries = "1.2.3.4"})), folder_ / "ct");
  EXPECT_EQ(scanOf(put(organs, {.referencedInstance = "1.2.3.4.5"})), folder_ / "ct");
  EXPECT_EQ(scanOf(put(organs, {.referencedSeries = "1.2.3.5"})), std::nullopt);
  EXPECT_EQ(scanOf(put(organs, {.frameOfReference = "1.2.10"})), std::nullopt);
}

} // namespace
} // namespace viscera::medical_io
