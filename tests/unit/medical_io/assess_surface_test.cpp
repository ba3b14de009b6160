#include "viscera/medical_io/assess_surface.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "build_paths.h"
#include "mesh_checks.h"
#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/medical_io/assess_patient.h"
#include "viscera/medical_io/plausible_size.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/medical_io/surface_repairs.h"

namespace viscera::medical_io {
namespace {

using geometry::TriangleMesh;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A ball of a normal liver's volume (1550 ml) on the right side of the body.
TriangleMesh liver() {
  return tests::sphere(4, 71.8, {-80, 10, 300});
}

SurfaceAssessment assess(const TriangleMesh& mesh, const std::string& name = "liver",
                         std::optional<Space> space = Space::lps) {
  Progress progress;
  return assessSurface(mesh, {name, space}, progress);
}

TriangleMesh repaired(const TriangleMesh& mesh, const std::string& id) {
  Progress progress;
  return surfaceRepair(id).apply(mesh, progress, {});
}

/// The findings that a user is asked to look at.
std::vector<Finding> doubts(const SurfaceAssessment& assessment) {
  std::vector<Finding> list;
  for (const Finding& finding : assessment.findings)
    if (finding.severity >= FindingSeverity::doubt)
      list.push_back(finding);
  return list;
}

std::string texts(const std::vector<Finding>& findings) {
  std::string all;
  for (const Finding& finding : findings)
    all += finding.text.english() + "\n";
  return all;
}

/// There is exactly one doubt, it says so, and its first repair leaves none.
void expectOneClick(const TriangleMesh& mesh, const std::string& says, const std::string& repair,
                    const std::string& name = "liver", std::optional<Space> space = Space::lps) {
  const std::vector<Finding> found = doubts(assess(mesh, name, space));
  ASSERT_EQ(found.size(), 1u) << texts(found);
  EXPECT_THAT(found[0].text.english(), HasSubstr(says));
  ASSERT_FALSE(found[0].repairs.empty());
  EXPECT_EQ(found[0].repairs.front(), repair);
  EXPECT_THAT(doubts(assess(repaired(mesh, repair), name, space)), IsEmpty());
}

TEST(AssessSurface, AGoodLiverHasNoDoubts) {
  const SurfaceAssessment assessment = assess(liver());
  EXPECT_EQ(assessment.worst(), FindingSeverity::good);
  EXPECT_FALSE(assessment.questionable());
  EXPECT_NEAR(assessment.volumeMl, 1540, 20);
  EXPECT_NEAR(assessment.sizeMm.x(), 143.6, 0.1);
}

TEST(AssessSurface, AxesThatAreNotStatedAreANoteOnly) {
  const SurfaceAssessment assessment = assess(liver(), "liver", std::nullopt);
  EXPECT_EQ(assessment.worst(), FindingSeverity::note);
  EXPECT_THAT(assessment.findings.front().text.english(), HasSubstr("LPS is assumed"));
}

TEST(AssessSurface, MetresInchesAndCentimetresAreToldApartByTheOrgan) {
  for (const char* unit : {"m", "in", "cm"}) {
    const auto known = std::find_if(lengthUnits().begin(), lengthUnits().end(),
                                    [&](const LengthUnit& u) { return u.id == unit; });
    expectOneClick(geometry::scaled(liver(), 1 / known->mm), "organ", "unit-" + std::string(unit));
  }
}

TEST(AssessSurface, MillimetresTakenAsMetresAndMultipliedAgainAreMicrometres) {
  expectOneClick(geometry::scaled(liver(), 1000), "is implausible for an organ", "unit-um");
}

TEST(AssessSurface, AnOrganOfUnknownNameInMetresIsNoticedByItsSize) {
  expectOneClick(geometry::scaled(liver(), 0.001), "metres", "unit-m", "segment_7");
}

TEST(AssessSurface, AShrunkenLiverInMetresIsNoticedByItsSizeToo) {
  const std::vector<Finding> found = doubts(assess(geometry::scaled(liver(), 0.0005)));
  ASSERT_EQ(found.size(), 1u) << texts(found);
  EXPECT_THAT(found[0].text.english(), HasSubstr("metres"));
  EXPECT_THAT(found[0].repairs, ElementsAre("unit-m"));
}

TEST(AssessSurface, ASmallVesselOfALabelMapIsSmallAndNotInCentimetres) {
  const TriangleMesh vessel = tests::sphere(3, 6, {-10, 20, 300});
  Progress progress;
  EXPECT_TRUE(assessSurface(vessel, {"celiac trunk", Space::lps}, progress).questionable());
  EXPECT_THAT(doubts(assessSurface(vessel, {"celiac trunk", Space::lps, true}, progress)), IsEmpty());
  EXPECT_THAT(texts(doubts(assessSurface(vessel, {"liver", Space::lps, true}, progress))),
              HasSubstr("not life-sized"));
}

TEST(AssessSurface, InsideOutIsTurnedByOneClick) {
  TriangleMesh mesh = liver();
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  expectOneClick(mesh, "inside out", "orient");
}

TEST(AssessSurface, ASingleTurnedTriangleIsFound) {
  TriangleMesh mesh = liver();
  std::swap(mesh.triangles(7, 0), mesh.triangles(7, 1));
  expectOneClick(mesh, "opposite orientation", "orient");
}

TEST(AssessSurface, AnOpenSurfaceIsClosedByOneClick) {
  TriangleMesh mesh = liver();
  mesh.triangles = mesh.triangles.bottomRows(mesh.triangles.rows() - 64).eval();
  expectOneClick(mesh, "open", "fill-holes");
}

TEST(AssessSurface, AnOpenLiverInMetresIsRecognisedByTheVolumeThatItWouldHave) {
  TriangleMesh mesh = geometry::scaled(liver(), 0.001);
  mesh.triangles = mesh.triangles.bottomRows(mesh.triangles.rows() - 64).eval();
  const std::vector<Finding> found = doubts(assess(mesh));
  ASSERT_EQ(found.size(), 2u) << texts(found);
  EXPECT_THAT(found[0].repairs, ElementsAre("unit-m"));
  EXPECT_THAT(found[1].repairs, ElementsAre("fill-holes", "remesh"));
}

TEST(AssessSurface, CrumbsOfASegmentationAreOfferedToGo) {
  const TriangleMesh large = liver(), crumb = tests::sphere(1, 3, {20, 20, 300});
  TriangleMesh mesh;
  mesh.points.resize(large.points.rows() + crumb.points.rows(), 3);
  mesh.points << large.points, crumb.points;
  mesh.triangles.resize(large.triangles.rows() + crumb.triangles.rows(), 3);
  mesh.triangles << large.triangles, crumb.triangles.array() + static_cast<std::int32_t>(large.points.rows());
  expectOneClick(mesh, "2 separate pieces, 1 of them is a small fragment of", "remove-fragments");
}

TEST(AssessSurface, IntersectionsAreCountedAndMadeAnew) {
  TriangleMesh mesh = liver();
  mesh.points.row(100) += Eigen::RowVector3d(0, -200, 0);
  const SurfaceAssessment assessment = assess(mesh);
  EXPECT_GT(assessment.selfIntersections, 0);
  EXPECT_THAT(doubts(assessment)[0].repairs, ElementsAre("remesh"));
  EXPECT_EQ(assess(repaired(mesh, "remesh")).selfIntersections, 0);
}

TEST(AssessSurface, ALiverOnTheLeftSideOfAnUnstatedFileMayBeRas) {
  expectOneClick(geometry::turnedHalf(liver()), "RAS", "ras-to-lps", "liver", std::nullopt);
}

TEST(AssessSurface, AMirroredKidneyIsQuestionedByTheSideInItsName) {
  const TriangleMesh kidney = tests::sphere(3, 35, {60, 60, 250});
  EXPECT_THAT(doubts(assess(kidney, "kidney_left")), IsEmpty());
  EXPECT_THAT(
      doubts(assess(kidney, "kidney_right")),
      ElementsAre(testing::Field(&Finding::text, testing::Property(&Text::english, HasSubstr("mirrored")))));
}

TEST(AssessSurface, LooksAtSurfacesThatNothingWasMendedOf) {
  TriangleMesh mesh = tests::box(100, 100, 100);
  mesh.triangles.row(3) = mesh.triangles.row(2);
  mesh.triangles.row(4) << 1, 1, 2;
  EXPECT_TRUE(assess(mesh, "box").questionable());
}

TEST(AssessSurface, CanBeCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(assessSurface(liver(), {}, progress), Cancelled);
}

/// Surfaces of an atlas that is in RAS, says so nowhere, and is not life-sized.
class Atlas : public testing::TestWithParam<const char*> {};

TEST_P(Atlas, IsCaughtAsRasAndAsNotLifeSized) {
  const std::filesystem::path file = std::filesystem::path(VISCERA_SHARED_ORGANS) / GetParam();
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << file.filename() << " is not there; it is not part of the project";
  const SurfaceFile surface = readSurface(file);
  ASSERT_FALSE(surface.spaceStated);
  const auto assessed = [&](const TriangleMesh& mesh, std::optional<Space> space) {
    return texts(doubts(assess(mesh, surface.name, space)));
  };
  EXPECT_THAT(assessed(surface.mesh, std::nullopt), HasSubstr("RAS"));
  const std::string turned = assessed(repaired(surface.mesh, "ras-to-lps"), Space::lps);
  EXPECT_THAT(turned, testing::Not(HasSubstr("RAS")));
  EXPECT_THAT(turned, testing::Not(HasSubstr("mirrored")));
  EXPECT_THAT(turned, HasSubstr("not life-sized"));
}

INSTANTIATE_TEST_SUITE_P(Organs, Atlas, testing::Values("liver.vtk", "kidney_left.vtk"));

TEST(AssessArrangement, KnowsABodyFromItsMirrorImageAndFromRas) {
  const auto placed = [](double signX, double signY) {
    const auto at = [&](double x, double y) {
      const Vec3 middle(signX * x, signY * y, 0);
      return Bounds{middle - Vec3::Ones(), middle + Vec3::Ones()};
    };
    return std::vector<PlacedOrgan>{{"liver", at(-80, 0)},
                                    {"spleen", at(90, 40)},
                                    {"kidney_left", at(50, 60)},
                                    {"Stomach", at(40, -20)},
                                    {"tumour", at(0, 0)}};
  };
  EXPECT_EQ(assessArrangement(placed(1, 1)), std::nullopt);
  EXPECT_THAT(assessArrangement(placed(-1, -1))->repairs, ElementsAre("ras-to-lps"));
  EXPECT_THAT(assessArrangement(placed(-1, 1))->repairs, ElementsAre("mirror"));
  EXPECT_EQ(assessArrangement({}), std::nullopt);
}

TEST(SurfaceRepairs, AnUnknownOneNamesThoseThereAre) {
  try {
    surfaceRepair("magic");
    ADD_FAILURE();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.tryThis().english(), HasSubstr("fill-holes"));
  }
}

TEST(PlausibleSize, DoubtsSayWhetherTheyQuoteARangeOrAverages) {
  EXPECT_THAT(doubtAboutVolume("liver", 239)->english(), HasSubstr("19 of 20 adults have 814 to 1906 ml"));
  EXPECT_THAT(doubtAboutVolume("heart", 90)->english(), HasSubstr("have on average 590 to 800 ml"));
  EXPECT_THAT(doubtAboutVolume("myocardium", 3000)->english(), HasSubstr("238 to 314 ml"));
  EXPECT_EQ(doubtAboutVolume("kidney_left", 150), std::nullopt);
  EXPECT_EQ(doubtAboutVolume("heart", 936), std::nullopt) << "with its great vessels";
}

} // namespace
} // namespace viscera::medical_io
