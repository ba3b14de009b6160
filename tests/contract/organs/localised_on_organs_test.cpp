#include <algorithm>

#include <gtest/gtest.h>

#include "organ_cases.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/group_handles.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/geometry/convex_hull.h"
#include "viscera/localised_scc/localised_s_celestial.h"
#include "viscera/localised_scc/region_layout.h"

namespace viscera::localised_scc {
namespace {

class LocalisedOnOrgans : public testing::TestWithParam<tests::OrganCase> {};

coordinates::HandleSet with(const Points& placed, const deformation::Grouping& grouping) {
  coordinates::HandleSet handles;
  handles.positions.resize(placed.rows() + grouping.added.rows(), 3);
  handles.positions << placed, grouping.added;
  handles.groups = grouping.groups;
  return handles;
}

coordinates::HandleSet grouped(const geometry::TriangleMesh& organ, int count) {
  const Points placed = deformation::placeHandles(organ);
  return with(placed, deformation::groupsAlongAxis(placed, organ.points, count));
}

std::unique_ptr<coordinates::Binding> bind(const coordinates::CoordinateSystem& system,
                                           const coordinates::HandleSet& handles, const Points& points) {
  Progress progress;
  return system.bind(handles, points, {}, progress);
}

std::shared_ptr<const coordinates::CoordinateSystem> localised() {
  return localisedSCelestial({coordinates::builtInSystems().front()});
}

TEST_P(LocalisedOnOrgans, ReproduceTheIdentityInTwoThreeAndFiveOverlappingGroups) {
  const auto organ = tests::load(GetParam());
  if (!organ)
    GTEST_SKIP() << "../shared/organs/" << GetParam().file << " is not there";
  for (const int count : {2, 3, 5}) {
    const auto handles = grouped(*organ, count);
    const RegionLayout layout(handles, 1);
    EXPECT_EQ(layout.zones().size(), static_cast<std::size_t>(count - 1)) << "only neighbours meet";
    for (const Region& region : layout.regions())
      EXPECT_GT(region.offsetBound, 0.005 * boundsOf(organ->points).diagonal()) << region.name;
    const auto report = bind(*localised(), handles, organ->points)->report();
    EXPECT_TRUE(report.failures.empty()) << report.failures.size() << " vertices in " << count << " groups";
    EXPECT_LT(report.identityError, 1e-9 * boundsOf(organ->points).diagonal()) << count << " groups";
    EXPECT_LT(report.unityError, 1e-9) << count << " groups";
    EXPECT_GE(report.minWeight, 0) << count << " groups";
  }
}

TEST_P(LocalisedOnOrgans, FourClustersOfFortyHandlesAreUsableAndLeaveAnOffset) {
  const auto organ = tests::load(GetParam());
  if (!organ)
    GTEST_SKIP() << "../shared/organs/" << GetParam().file << " is not there";
  const Points placed = deformation::placeHandles(*organ, {40});
  const auto handles = with(placed, deformation::groupsByCluster(placed, organ->points, 4));
  ASSERT_EQ(handles.groups.size(), 4u);
  for (const auto& group : handles.groups)
    EXPECT_GE(group.handles.size(), 4u) << group.name;
  const double standard = localised()->parameters().front().standard;
  const RegionLayout layout(handles, standard);
  ASSERT_EQ(layout.regions().size(), 4u) << "a group that is no region";
  EXPECT_FALSE(layout.zones().empty()) << "the clusters do not meet";
  for (const Region& region : layout.regions()) {
    EXPECT_GT(region.offset, 0) << region.name;
    EXPECT_LT(region.offset, region.offsetBound) << region.name;
    EXPECT_GT(region.offsetBound, 0.005 * boundsOf(organ->points).diagonal()) << region.name;
  }
  const auto report = bind(*localised(), handles, organ->points)->report();
  EXPECT_TRUE(report.failures.empty()) << report.failures.size() << " vertices";
  EXPECT_LT(report.identityError, 1e-9 * boundsOf(organ->points).diagonal());
  EXPECT_GE(report.minWeight, 0);
}

TEST_P(LocalisedOnOrgans, OneGroupIsThePlainSystemTo1e12) {
  const auto organ = tests::load(GetParam());
  if (!organ)
    GTEST_SKIP() << "../shared/organs/" << GetParam().file << " is not there";
  coordinates::HandleSet handles;
  handles.positions = deformation::placeHandles(*organ);
  const auto plain = bind(*coordinates::builtInSystems().front(), handles, organ->points);
  handles.groups = {{"all", {}}};
  for (int i = 0; i < handles.positions.rows(); ++i)
    handles.groups[0].handles.push_back(i);
  const auto local = bind(*localised(), handles, organ->points);
  for (int i = 0; i < handles.positions.rows(); ++i)
    EXPECT_LT((local->influence(i) - plain->influence(i)).cwiseAbs().maxCoeff(), 1e-12) << "handle " << i;
}

/// By other means than the system's own: the hulls of Qhull, and every set of handles that holds the handle.
TEST_P(LocalisedOnOrgans, AHandleHasWeightExactlyZeroOutsideItsRegionsAndTheirSuperRegions) {
  const auto organ = tests::load(GetParam());
  if (!organ)
    GTEST_SKIP() << "../shared/organs/" << GetParam().file << " is not there";
  const auto handles = grouped(*organ, 5);
  const RegionLayout layout(handles, 10);
  const auto binding = bind(*localised(), handles, organ->points);
  std::vector<geometry::ConvexHull> hulls;
  for (int set = 0; set < layout.setCount(); ++set)
    hulls.emplace_back(Points(handles.positions(layout.handlesOf(set), Eigen::all)));
  Eigen::Index outside = 0;
  for (int handle = 0; handle < handles.positions.rows(); ++handle) {
    const Values influence = binding->influence(handle);
    for (Eigen::Index v = 0; v < organ->points.rows(); ++v) {
      bool reached = false;
      for (int set = 0; set < layout.setCount() && !reached; ++set) {
        const auto& own = layout.handlesOf(set);
        reached = std::binary_search(own.begin(), own.end(), handle) &&
                  hulls[std::size_t(set)].signedDistance(organ->points.row(v).transpose()) <= 0;
      }
      if (reached)
        continue;
      ++outside;
      ASSERT_EQ(influence[v], 0) << "handle " << handle << ", vertex " << v;
    }
  }
  EXPECT_GT(outside, 0) << "every handle reaches everything";
}

std::vector<tests::OrganCase> casesWithBowel() {
  auto cases = tests::organCases();
  cases.push_back({"stomach_and_bowel", ""});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Organs, LocalisedOnOrgans, testing::ValuesIn(casesWithBowel()),
                         [](const auto& organ) { return organ.param.name; });

} // namespace
} // namespace viscera::localised_scc
