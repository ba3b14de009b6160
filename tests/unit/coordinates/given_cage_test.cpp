#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/coordinates/cage/cage.h"
#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::coordinates {
namespace {

std::string refusal(const Points& handles, const geometry::TriangleMesh& cage) {
  try {
    cageOver(handles, cage);
  } catch (const DataError& error) {
    return error.what();
  }
  return {};
}

TEST(GivenCage, FindsItsHandlesInAnyOrderAndBesideOthers) {
  const auto box = tests::box(20, 30, 40);
  Points handles(10, 3);
  handles << 1, 2, 3, box.points.colwise().reverse(), 4, 5, 6;
  const Triangles cage = cageOver(handles, box);
  ASSERT_EQ(cage.rows(), 12);
  for (Eigen::Index t = 0; t < 12; ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(handles.row(cage(t, k)), box.points.row(box.triangles(t, k)));
}

TEST(GivenCage, IsTurnedOutward) {
  auto box = tests::box(20, 30, 40);
  const Points handles = box.points;
  box.triangles.col(1).swap(box.triangles.col(2));
  const geometry::TriangleMesh found{handles, cageOver(handles, box), {}};
  EXPECT_GT(geometry::checkSurface(found).volumeMm3, 0);
}

TEST(GivenCage, ThatIsOpenOrWithoutAHandleIsRefusedByName) {
  auto box = tests::box(20, 30, 40);
  Points handles = box.points;
  handles.row(5) *= 1.01;
  EXPECT_THAT(refusal(handles, box), testing::HasSubstr("no handle at vertex 5"));
  box.triangles.conservativeResize(11, 3);
  EXPECT_THAT(refusal(box.points, box), testing::HasSubstr("open at 3 edges"));
  box.triangles.resize(0, 3);
  EXPECT_THAT(refusal(box.points, box), testing::HasSubstr("no triangles"));
}

TEST(GivenCage, KnowsWhichHandlesLieAtItsVertices) {
  const auto box = tests::box(20, 30, 40);
  Points handles = box.points.bottomRows(7);
  handles(0, 0) += 1e-5;
  handles(1, 0) += 1e-3;
  EXPECT_THAT(handlesAtVertices(handles, box), testing::ElementsAre(-1, 0, -1, 2, 3, 4, 5, 6));
  EXPECT_THAT(handlesAtVertices(Points(0, 3), box), testing::Each(-1));
}

} // namespace
} // namespace viscera::coordinates
