#include "viscera/deformation/bind_organ.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "concave_cage.h"
#include "shapes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/deformation/place_handles.h"

namespace viscera::deformation {
namespace {

coordinates::HandleSet handlesAt(const Points& positions) {
  coordinates::HandleSet handles;
  handles.positions = positions;
  return handles;
}

} // namespace

TEST(BindOrgan, AcceptsAnOrganInsideItsHandles) {
  const auto organ = tests::sphere(3, 40);
  Progress progress;
  const auto binding = bindOrgan(*coordinates::sCelestial(), handlesAt(enclosingHandles(organ.points)),
                                 organ.points, {}, progress);
  EXPECT_EQ(binding->pointCount(), organ.points.rows());
  EXPECT_TRUE(binding->report().failures.empty());
}

TEST(BindOrgan, SaysHowManyVerticesAreOutsideAndByHowMuch) {
  const auto organ = tests::sphere(2, 10);
  Points handles = enclosingHandles(organ.points, 0);
  handles.col(2) = handles.col(2).cwiseMin(9.0); // Cuts the cap above z = 9 off; its top is 1 mm higher.
  int above = 0, first = -1;
  for (Eigen::Index v = 0; v < organ.points.rows(); ++v)
    if (organ.points(v, 2) > 9 + 1e-9) {
      ++above;
      first = first < 0 ? static_cast<int>(v) : first;
    }
  ASSERT_GT(above, 0);
  Progress progress;
  try {
    bindOrgan(*coordinates::sCelestial(), handlesAt(handles), organ.points, {}, progress);
    FAIL() << "vertices outside the hull were accepted";
  } catch (const DataError& error) {
    EXPECT_THAT(error.problem().english(), testing::HasSubstr(std::to_string(above) + " lie outside"));
    EXPECT_THAT(error.problem().english(), testing::HasSubstr("by up to 1 mm"));
    EXPECT_EQ(error.where().english(), "vertex " + std::to_string(first));
    EXPECT_THAT(error.tryThis().english(), testing::HasSubstr("enclosing"));
  }
}

TEST(BindOrgan, SaysThatItIsTheGivenCageThatVerticesLieOutsideOf) {
  const coordinates::HandleSet handles = tests::concaveCage();
  Points organ(3, 3);
  organ << 20, 20, 20, 60, 60, 60, 60, 55, 60; // The last two lie in the dent.
  Progress progress;
  try {
    bindOrgan(*coordinates::greenCoordinates(), handles, organ, {}, progress);
    FAIL() << "vertices outside the cage were accepted";
  } catch (const UnboundVertices& error) {
    EXPECT_TRUE(error.cageCounts());
    EXPECT_FALSE(error.groupsCount());
    EXPECT_EQ(error.vertices(), (std::vector<int>{1, 2}));
    EXPECT_THAT(error.problem().english(),
                testing::HasSubstr("2 of 3 vertices have no coordinates in the cage"));
    EXPECT_THAT(error.tryThis().english(), testing::HasSubstr("convex hull"));
  }
}

} // namespace viscera::deformation
