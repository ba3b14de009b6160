#include <gtest/gtest.h>

#include "organ_cases.h"
#include "viscera/coordinates/built_in_systems.h"
#include "viscera/deformation/group_handles.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/localised_scc/localised_s_celestial.h"

namespace viscera::localised_scc {
namespace {

class LocalisedOnOrgans : public testing::TestWithParam<tests::OrganCase> {};

TEST_P(LocalisedOnOrgans, ReproduceTheIdentityInTwoThreeAndFiveOverlappingGroups) {
  const auto organ = tests::load(GetParam());
  if (!organ)
    GTEST_SKIP() << "../shared/organs/" << GetParam().file << " is not there";
  const Points placed = deformation::placeHandles(*organ);
  for (const int count : {2, 3, 5}) {
    const auto grouping = deformation::groupsAlongAxis(placed, organ->points, count);
    coordinates::HandleSet handles;
    handles.positions.resize(placed.rows() + grouping.added.rows(), 3);
    handles.positions << placed, grouping.added;
    handles.groups = grouping.groups;
    Progress progress;
    const auto report = LocalisedSCelestial({coordinates::builtInSystems().front()})
                            .bind(handles, organ->points, {}, progress)
                            ->report();
    EXPECT_TRUE(report.failures.empty()) << report.failures.size() << " vertices in " << count << " groups";
    EXPECT_LT(report.identityError, 1e-9 * boundsOf(organ->points).diagonal()) << count << " groups";
    EXPECT_LT(report.unityError, 1e-9) << count << " groups";
    EXPECT_GE(report.minWeight, 0) << count << " groups";
  }
}

std::vector<tests::OrganCase> casesWithBowel() {
  auto cases = tests::organCases();
  cases.push_back({"digestive_system", ""});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Organs, LocalisedOnOrgans, testing::ValuesIn(casesWithBowel()),
                         [](const auto& organ) { return organ.param.name; });

} // namespace
} // namespace viscera::localised_scc
