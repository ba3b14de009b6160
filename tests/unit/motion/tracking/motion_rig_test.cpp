#include <cmath>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/geometry/volume.h"
#include "viscera/tracking/motion_rig.h"

namespace viscera::tracking {
namespace {

std::vector<geometry::TriangleMesh> shell() {
  return {tests::sphere(3, 40), tests::sphere(3, 20, Vec3(10, 0, 0)), tests::sphere(3, 8, Vec3(-20, 0, 0))};
}

TEST(PlaceMotionHandles, StandsOutsideTheOuterSurfaceAndInTheBloodOfCavities) {
  const RigHandles rig = placeMotionHandles(shell(), 0, {.handles = 108, .offsetMm = 3});
  ASSERT_EQ(rig.rest.rows(), 108);
  std::array<int, 4> counts{};
  for (Eigen::Index i = 0; i < rig.rest.rows(); ++i) {
    const int surface = rig.ofSurface[static_cast<std::size_t>(i)];
    ++counts[static_cast<std::size_t>(surface + 1)];
    const Vec3 at = rig.rest.row(i);
    if (surface == 0) {
      EXPECT_NEAR(at.norm(), 43, 0.2);
    } else if (surface == 1) {
      EXPECT_NEAR((at - Vec3(10, 0, 0)).norm(), 17, 0.2);
    } else if (surface == 2) {
      EXPECT_NEAR((at - Vec3(-20, 0, 0)).norm(), 5, 0.2);
    }
  }
  EXPECT_EQ(counts, (std::array<int, 4>{8, 40, 30, 30}));
}

TEST(PlaceMotionHandles, TakesSixtyForOneSurfaceAndAHundredAndTwentyForMore) {
  EXPECT_EQ(placeMotionHandles({tests::sphere(3, 40)}, 0, {}).rest.rows(), 60);
  EXPECT_EQ(placeMotionHandles(shell(), 0, {}).rest.rows(), 120);
}

TEST(PlaceMotionHandles, RefusesTooFew) {
  EXPECT_THROW(placeMotionHandles(shell(), 0, {.handles = 19}), DataError);
  EXPECT_EQ(placeMotionHandles(shell(), 0, {.handles = 20}).rest.rows(), 20);
}

TEST(MotionRig, HoldsAllSurfacesAtRestAndUnderAnyAffineMap) {
  Progress progress;
  const auto surfaces = shell();
  const RigHandles handles = placeMotionHandles(surfaces, 0, {});
  const MotionRig rig(surfaces, handles.rest, 3, softnessFor(handles.rest, 8, 1.5), progress);
  Eigen::Matrix3d map;
  map << 0.9, 0.1, 0, -0.2, 1.1, 0.05, 0, 0.3, 0.8;
  const Points pose = (rig.rest() * map.transpose()).rowwise() + Eigen::RowVector3d(3, -4, 5);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const Points expected = (surfaces[i].points * map.transpose()).rowwise() + Eigen::RowVector3d(3, -4, 5);
    EXPECT_LT((rig.vertices(pose, i) - expected).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_NEAR(rig.shares().segment(rig.firstRow(i), rig.rows(i)).sum(), 1.0 / 3, 1e-12);
  }
  EXPECT_LT((rig.bending() * (pose - rig.rest())).cwiseAbs().maxCoeff(), 1e-9) << "affine motion is free";
  EXPECT_NEAR(rig.volumesMl(rig.vertices(rig.rest()))[0],
              geometry::volume(surfaces[0].points, surfaces[0].triangles) / 1000, 1e-9);
}

TEST(MotionRig, SaysWhatLiesOutsideAGivenRig) {
  Progress progress;
  const Points handles = placeMotionHandles({tests::sphere(2, 10)}, 0, {}).rest;
  EXPECT_THROW(MotionRig({tests::sphere(3, 40)}, handles, 3, 5, progress), deformation::UnboundVertices);
}

} // namespace
} // namespace viscera::tracking
