#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "library_for_tests.h"
#include "self_intersections.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/sample_organs/sample_organ.h"

/// The organs of the sample abdomen as an anatomist looks for them: shapes, sizes, neighbours.
namespace viscera::tests {
namespace {

using sample_organs::ImplicitSurface;
using sample_organs::Resolution;
using sample_organs::SampleSurface;

ImplicitSurface shapeOf(const char* organ, const char* node) {
  return sample_organs::implicitSurface(projectLibrary(), organ, node);
}

SampleSurface madeOf(const char* organ, const char* surface, Resolution resolution = Resolution::medium) {
  Progress progress;
  return sample_organs::sampleSurface(projectLibrary(), organ, surface, resolution, progress);
}

/// The height, mm, of the first tissue below `from`; far below for none.
double topBelow(const ImplicitSurface& shape, double x, double y, double from) {
  for (double z = from; z > from - 160; z -= 0.5)
    if (shape({x, y, z}) < 0)
      return z;
  return -std::numeric_limits<double>::infinity();
}

struct Peak {
  double x = 0, z = -std::numeric_limits<double>::infinity();
};

Peak topOfTheFundus(const ImplicitSurface& stomach) {
  Peak top;
  for (double x = 30; x < 100; x += 2)
    for (double y = 0; y < 60; y += 2)
      if (const double z = topBelow(stomach, x, y, 140); z > top.z)
        top = {x, z};
  return top;
}

/// Between oesophagus and fundus, behind the middle of which both lie.
Peak cardialNotch(const ImplicitSurface& stomach) {
  Peak notch{0, std::numeric_limits<double>::infinity()};
  for (double x = 0; x < 45; ++x)
    if (const double z = topBelow(stomach, x, 23, 135); z < notch.z)
      notch = {x, z};
  return notch;
}

} // namespace

/// Of a stomach upright, the dome holds the bubble of gas: above the cardia and left of it, under the
/// diaphragm.
TEST(SampleStomach, HasAFundusThatRisesAboveTheCardialNotch) {
  for (const auto& [organ, node] :
       {std::pair("stomach", "stomach_smooth"), std::pair("stomach_and_bowel", "stomach_noduo")}) {
    const ImplicitSurface stomach = shapeOf(organ, node);
    const Peak top = topOfTheFundus(stomach), notch = cardialNotch(stomach);
    EXPECT_GT(top.z - notch.z, 28) << organ;
    EXPECT_LT(top.z - notch.z, 50) << organ;
    EXPECT_GT(top.x - notch.x, 30) << organ;
  }
}

/// Between body and antrum the lesser curvature is notched.
TEST(SampleStomach, HasAnAngularIncisureInTheLesserCurvature) {
  const ImplicitSurface stomach = shapeOf("stomach", "stomach_smooth");
  const double incisure = topBelow(stomach, -4, -14, 0);
  for (const double x : {-18.0, 9.0})
    EXPECT_GT(topBelow(stomach, x, -14, 0), incisure + 5) << x;
}

/// 11 cm by 7 by 4, and 114 to 286 ml in healthy adults (doi 10.5603/FM.2014.0038, with two deviations).
TEST(SampleSpleen, HasTheSizeOfAHealthyOne) {
  const SampleSurface spleen = madeOf("digestive_system", "spleen");
  EXPECT_EQ(spleen.organ, "Spleen");
  EXPECT_FALSE(spleen.hidden);
  const double ml = geometry::checkSurface(*spleen.mesh).volumeMm3 / kMm3PerMl;
  EXPECT_GT(ml, 150);
  EXPECT_LT(ml, 200);
  const Points& points = spleen.mesh->points;
  const auto extent = [&](const Vec3& direction) {
    const Values along = points * direction.normalized();
    return along.maxCoeff() - along.minCoeff();
  };
  EXPECT_NEAR(extent({0.35, -0.55, -0.76}), 110, 6) << "length";
  EXPECT_NEAR(extent({0.54, -0.545, 0.643}), 70, 6) << "width";
  EXPECT_NEAR(extent({0.766, 0.634, -0.105}), 44, 8) << "thickness";
}

/// A place of the spleen by its own axes, mm from its middle: to the ribs, to the superior border, to the
/// anterior end.
Vec3 inTheSpleen(double ribs, double border, double end) {
  return Vec3(99, 63, 88) + ribs * Vec3(0.766, 0.634, -0.105) + border * Vec3(0.54, -0.545, 0.643) +
         end * Vec3(0.35, -0.55, -0.76);
}

TEST(SampleSpleen, HasAHilumTowardsTheStomachAndANotchedBorder) {
  const ImplicitSurface spleen = shapeOf("digestive_system", "spleen");
  EXPECT_LT(spleen(inTheSpleen(0, 0, 0)), -8) << "thick tissue behind the hilum";
  EXPECT_GT(spleen(inTheSpleen(-16, 0, 0)), 3) << "hilum";
  EXPECT_LT(spleen(inTheSpleen(-12, 20, -8)), 0) << "the lip in front of it";
  EXPECT_LT(spleen(inTheSpleen(0, 30, 4)), 0);
  EXPECT_GT(spleen(inTheSpleen(0, 30, 14)), 0) << "notch";
  EXPECT_LT(spleen(inTheSpleen(0, 30, 22)), 0);
  EXPECT_GT(spleen(inTheSpleen(0, 28, 32)), 0) << "second notch";
}

/// Behind and left of the fundus, above the left flexure; the tail of the pancreas points to its hilum.
TEST(SampleSpleen, LiesAmongItsNeighbours) {
  const Vec3 middle = madeOf("digestive_system", "spleen", Resolution::low).mesh->points.colwise().mean();
  const auto place = [](const char* surface, const char* name) {
    for (const auto& part : sample_organs::namedPlaces(projectLibrary(), "digestive_system", surface))
      if (part.name == name)
        return part.at;
    ADD_FAILURE() << "no " << name;
    return Vec3(Vec3::Zero());
  };
  EXPECT_GT(middle.x(), place("outer", "Fundus").x() + 20);
  EXPECT_GT(middle.y(), place("outer", "Fundus").y() + 20);
  EXPECT_GT(middle.z(), place("outer", "Left colic flexure").z() + 20);
  EXPECT_LT((place("pancreas", "Tail") - place("spleen", "Hilum")).norm(), 60);
}

/// It leaves the left iliac fossa, crosses to the right, turns back to the left above and behind, and comes
/// to the rectum in the middle.
TEST(SampleBowel, HasASigmoidColonThatIsBentLikeAnS) {
  const ImplicitSurface colon = shapeOf("stomach_and_bowel", "colon");
  const Vec3 course[] = {{94, 11, -192},  {36, -19, -227}, {-27, -4, -222}, {-37, 14, -198},
                         {-21, 30, -178}, {25, 46, -196},  {14, 56, -224},  {0, 59, -248}};
  for (const Vec3& place : course)
    EXPECT_LT(colon(place), -12) << place.transpose();
  for (const Vec3& between : {Vec3(0, 12, -204), Vec3(40, 16, -212), Vec3(-10, 30, -215)})
    EXPECT_GT(colon(between), 4) << between.transpose() << " lies between its limbs";
  double length = 0;
  for (std::size_t i = 1; i < std::size(course); ++i)
    length += (course[i] - course[i - 1]).norm();
  EXPECT_GT(length, 250);
}

/// Whether a line of sight from the front meets tissue.
bool meets(const ImplicitSurface& bowel, double x, double z) {
  for (double y = -85; y < 75;) {
    const double away = bowel({x, y, z});
    if (away < 0)
      return true;
    y += std::clamp(away, 0.7, 6.0);
  }
  return false;
}

TEST(SampleBowel, FillsTheFrameOfTheColon) {
  const ImplicitSurface bowel = shapeOf("stomach_and_bowel", "surf outer");
  int lines = 0, through = 0;
  for (double x = -75; x <= 90; x += 3)
    for (double z = -200; z <= -110; z += 3) {
      ++lines;
      through += !meets(bowel, x, z);
    }
  RecordProperty("linesOfSight", lines);
  RecordProperty("throughTheFrame", through);
  EXPECT_LT(through, 0.01 * lines);
}

/// An apron before transverse colon and small bowel, hidden at first, of a few millimetres.
TEST(SampleOmentum, IsAThinApronBeforeTheBowelAndHiddenAtFirst) {
  const SampleSurface omentum = madeOf("digestive_system", "omentum");
  EXPECT_TRUE(omentum.hidden);
  EXPECT_EQ(omentum.organ, "Greater omentum");
  const geometry::TriangleMesh& mesh = *omentum.mesh;
  double area = 0;
  for (const auto& triangle : mesh.triangles.rowwise()) {
    const Vec3 a = mesh.points.row(triangle[0]), b = mesh.points.row(triangle[1]),
               c = mesh.points.row(triangle[2]);
    area += (b - a).cross(c - a).norm() / 2;
  }
  const double thickness = geometry::checkSurface(mesh).volumeMm3 / (area / 2);
  EXPECT_GT(thickness, 3);
  EXPECT_LT(thickness, 7);
  const Vec3 low = mesh.points.colwise().minCoeff(), high = mesh.points.colwise().maxCoeff();
  EXPECT_GT(high.x() - low.x(), 150) << "width";
  EXPECT_GT(high.z() - low.z(), 130) << "length";
  EXPECT_LT(high.y(), -25) << "nothing behind the front of the bowel";
  EXPECT_NEAR(high.z(), -60, 12) << "at the height of the greater curvature";
}

class DigestiveSystem : public testing::TestWithParam<Resolution> {};

TEST_P(DigestiveSystem, HasOrgansThatDoNotMeetEachOther) {
  Progress progress;
  const sample_organs::SampleOrgan system =
      sample_organs::sampleOrgan(projectLibrary(), "digestive_system", GetParam(), progress);
  ASSERT_EQ(system.surfaces.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = std::max<std::size_t>(i + 1, 3); j < 5; ++j)
      EXPECT_FALSE(surfacesMeet(*system.surfaces[i].mesh, *system.surfaces[j].mesh))
          << system.surfaces[i].name << ", " << system.surfaces[j].name;
}

INSTANTIATE_TEST_SUITE_P(At, DigestiveSystem, testing::Values(Resolution::low, Resolution::medium),
                         [](const auto& one) { return sample_organs::nameOf(one.param); });

/// The width, mm, of a round vein's lumen where a plane of constant height cuts it: inside its walls of
/// `wall` mm.
double lumenAt(const ImplicitSurface& vein, double z, double wall) {
  constexpr double kStep = 0.5;
  double area = 0;
  for (double x = -80; x < 20; x += kStep)
    for (double y = -10; y < 80; y += kStep)
      area += vein({x, y, z}) < 0 ? kStep * kStep : 0;
  return 2 * (std::sqrt(area / std::numbers::pi) - wall);
}

/// 20.4 +- 2.8 mm in 1,503 adults by CT (doi 10.1007/s00330-018-5820-5).
TEST(SampleVenaCava, IsTwoCentimetresWide) {
  const ImplicitSurface ofTheLiver = shapeOf("liver", "ivc"), ofTheHeart = shapeOf("heart", "cavae");
  for (const double z : {10.0, 30.0, 60.0})
    EXPECT_NEAR(lumenAt(ofTheLiver, z, 2), 21, 2.5) << "liver, " << z;
  EXPECT_NEAR(lumenAt(ofTheHeart, -36, 2.2), 21, 3) << "heart";
}

} // namespace viscera::tests
