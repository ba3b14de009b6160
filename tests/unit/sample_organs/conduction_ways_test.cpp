#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "library_for_tests.h"
#include "viscera/core/error.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::tests {
namespace {

constexpr const char* kCarriers[] = {"lv", "rv", "la", "ra"};

/// The conduction system of the sample heart, with the surface that carries each way.
std::vector<std::pair<std::string, geometry::NamedWay>> conduction() {
  std::vector<std::pair<std::string, geometry::NamedWay>> ways;
  for (const char* surface : kCarriers)
    for (const geometry::NamedWay& way : sample_organs::namedWays(projectLibrary(), "heart", surface))
      ways.emplace_back(surface, way);
  return ways;
}

/// When the first and the last point of the ways of that name are reached, ms.
std::pair<double, double> timesOf(const std::string& name) {
  std::pair<double, double> times{std::numeric_limits<double>::infinity(), -1};
  for (const auto& [surface, way] : conduction())
    if (way.name == name)
      times = {std::min(times.first, way.reachedMs.minCoeff()),
               std::max(times.second, way.reachedMs.maxCoeff())};
  EXPECT_GE(times.second, 0) << name << " is not there";
  return times;
}

/// mm; lines lie on the wall or in it.
constexpr double kFromWall = 3;

TEST(ConductionWays, BeginWithTheSinusNodeAndReachTheVentriclesInTheirTime) {
  EXPECT_EQ(timesOf("Sinoatrial node"), std::make_pair(0.0, 0.0));
  for (const auto& [surface, way] : conduction()) {
    const bool ofAtria = (surface == "la" || surface == "ra") && way.name != "Atrioventricular node";
    if (ofAtria) {
      EXPECT_LE(way.reachedMs.maxCoeff(), 100) << way.name;
    }
    EXPECT_LE(way.reachedMs.maxCoeff(), 250) << way.name;
    for (Eigen::Index i = 1; i < way.reachedMs.size(); ++i)
      EXPECT_LE(way.reachedMs[i - 1], way.reachedMs[i]) << way.name;
  }
  const auto node = timesOf("Atrioventricular node");
  EXPECT_LE(node.first, 60);
  EXPECT_GE(node.second - node.first, 60) << "it delays";
  EXPECT_GE(timesOf("Bundle of His").first, node.second);
  for (const char* fascicle : {"Left anterior fascicle", "Left posterior fascicle", "Left septal fascicle"}) {
    EXPECT_GE(timesOf(fascicle).second, 160) << fascicle;
    EXPECT_LE(timesOf(fascicle).second, 165) << fascicle << ": the first muscle, Durrer 1970";
  }
  EXPECT_GT(timesOf("Right bundle branch").second, timesOf("Left septal fascicle").second)
      << "the septum is excited from the left";
  EXPECT_NEAR(timesOf("Purkinje fibres").second, 234, 10) << "the base is last";
}

TEST(ConductionWays, LieInTheWallOrOnIt) {
  std::map<std::string, sample_organs::ImplicitSurface> fields;
  for (const char* node : {"heart_body", "left_blood", "right_blood"})
    fields[node] = sample_organs::implicitSurface(projectLibrary(), "heart", node);
  for (const auto& [surface, way] : conduction())
    for (Eigen::Index i = 0; i < way.points.rows(); ++i) {
      const Vec3 point = way.points.row(i).transpose();
      EXPECT_LT(fields["heart_body"](point), kFromWall) << way.name << ' ' << i;
      EXPECT_GT(fields["left_blood"](point), -kFromWall) << way.name << ' ' << i;
      EXPECT_GT(fields["right_blood"](point), -kFromWall) << way.name << ' ' << i;
    }
}

/// Over the roof of the atria, behind the ascending aorta and clear of it.
TEST(ConductionWays, OfBachmannGoBehindTheAorta) {
  constexpr int kPlacesEach = 10;
  constexpr double kClearMm = 3;
  const auto aorta = sample_organs::implicitSurface(projectLibrary(), "heart", "aorta");
  const Vec3 root(-13, 9, 38); // The middle of the aorta at the bundle's height.
  int behind = 0;
  for (const auto& [surface, way] : conduction())
    for (Eigen::Index i = 0; way.name == "Bachmann's bundle" && i + 1 < way.points.rows(); ++i)
      for (int part = 0; part <= kPlacesEach; ++part) {
        const double share = static_cast<double>(part) / kPlacesEach;
        const Vec3 place = ((1 - share) * way.points.row(i) + share * way.points.row(i + 1)).transpose();
        EXPECT_GT(aorta(place), kClearMm) << place.transpose();
        if (std::abs(place.x() - root.x()) < 10) {
          ++behind;
          EXPECT_GT(place.y(), root.y() + 15) << place.transpose();
        }
      }
  EXPECT_GT(behind, kPlacesEach);
}

TEST(ConductionWays, EachBeginsWhereAnotherPasses) {
  constexpr double kTogetherMm = 0.2;
  const auto all = conduction();
  for (const auto& [surface, way] : all) {
    if (way.name == "Sinoatrial node")
      continue;
    bool joined = false;
    for (const auto& [other, before] : all)
      for (Eigen::Index i = 0; i < before.points.rows(); ++i)
        joined = joined || (&before != &way && before.reachedMs[0] <= way.reachedMs[0] &&
                            (before.points.row(i) - way.points.row(0)).norm() < kTogetherMm &&
                            std::abs(before.reachedMs[i] - way.reachedMs[0]) <= 5);
    EXPECT_TRUE(joined) << way.name << " of " << surface << " begins at " << way.points.row(0);
  }
}

TEST(ConductionWays, ComeWithTheirSurfaces) {
  Progress progress;
  const auto cavity =
      sample_organs::sampleSurface(projectLibrary(), "heart", "lv", sample_organs::Resolution::low, progress);
  EXPECT_EQ(cavity.ways, sample_organs::namedWays(projectLibrary(), "heart", "lv"));
  EXPECT_FALSE(cavity.ways.empty());
  EXPECT_TRUE(sample_organs::namedWays(projectLibrary(), "liver", "outer").empty());
}

} // namespace
} // namespace viscera::tests
