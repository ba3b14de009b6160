#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/group_handles.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/localised_scc/localised_s_celestial.h"

namespace viscera::localised_scc {
namespace {

TEST(LocalisedSCelestial, ReproducesTheIdentityWithTwoThreeAndFiveGroups) {
  auto organ = tests::sphere(4, 1);
  organ.points = organ.points * Vec3(90, 45, 40).asDiagonal();
  const Points placed = deformation::placeHandles(organ, {30, true, 0.04, 0.15});
  for (const int count : {2, 3, 5}) {
    const auto grouping = deformation::groupsAlongAxis(placed, organ.points, count);
    coordinates::HandleSet handles;
    handles.positions.resize(placed.rows() + grouping.added.rows(), 3);
    handles.positions << placed, grouping.added;
    handles.groups = grouping.groups;
    Progress progress;
    const auto binding = localisedSCelestial({coordinates::builtInSystems().front()})
                             ->bind(handles, organ.points, {}, progress);
    EXPECT_TRUE(binding->report().failures.empty()) << count << " groups";
    EXPECT_LT(binding->report().identityError, 1e-9 * boundsOf(organ.points).diagonal());
    EXPECT_LT(binding->report().unityError, 1e-12);
    EXPECT_GE(binding->report().minWeight, 0);
  }
}

} // namespace
} // namespace viscera::localised_scc
