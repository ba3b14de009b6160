#include "viscera/deformation/volume_lock.h"

#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "clouds.h"
#include "shapes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/place_handles.h"

namespace viscera::deformation {
namespace {

constexpr double kExact = 1e-12; ///< Of the volume: rounding, and nothing that an iteration leaves.

/// A sphere of 30 mm with twenty handles, of which the eight enclosing ones come first.
class RestoreVolumeTest : public testing::Test {
protected:
  static Deformer sphereDeformer() {
    auto organ = std::make_shared<geometry::TriangleMesh>(tests::sphere(3, 30, {5, -80, 200}));
    Placement placement;
    placement.count = 20;
    coordinates::HandleSet handles;
    handles.positions = placeHandles(*organ, placement);
    Progress progress;
    auto binding = bindOrgan(*coordinates::sCelestial(), handles, organ->points, {}, progress);
    return Deformer(organ, binding, handles.positions);
  }

  static std::vector<int> from(int first, int count) {
    std::vector<int> handles(count);
    std::iota(handles.begin(), handles.end(), first);
    return handles;
  }
};

} // namespace

TEST_F(RestoreVolumeTest, IsExactForAnyPoseInOneStep) {
  Deformer deformer = sphereDeformer();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> by(-6, 6);
  for (int round = 0; round < 20; ++round) {
    Points pose = deformer.restHandles();
    for (int handle = 8; handle < 14; ++handle)
      pose.row(handle) += tests::drawPlace(by, random).transpose();
    deformer.setPose(pose);
    ASSERT_GT(std::abs(deformer.volumeMm3() / deformer.restVolumeMm3() - 1), 1e-6);
    restoreVolume(deformer, deformer.restVolumeMm3(), restingHandles(deformer.restHandles(), pose));
    EXPECT_NEAR(deformer.volumeMm3() / deformer.restVolumeMm3(), 1, kExact);
    EXPECT_EQ(deformer.pose().middleRows(8, 6), pose.middleRows(8, 6)) << "what the user moved stays";
  }
}

TEST_F(RestoreVolumeTest, ReachesAVolumeThatIsAskedFor) {
  Deformer deformer = sphereDeformer();
  for (double part : {0.6, 0.9, 1.0, 1.3, 2.0}) {
    deformer.reset();
    restoreVolume(deformer, part * deformer.restVolumeMm3(), from(0, 20));
    EXPECT_NEAR(deformer.volumeMm3() / deformer.restVolumeMm3(), part, kExact * part);
  }
}

TEST_F(RestoreVolumeTest, MovesOnlyTheCompensatingHandles) {
  Deformer deformer = sphereDeformer();
  restoreVolume(deformer, 1.05 * deformer.restVolumeMm3(), {9, 12});
  for (int handle = 0; handle < 20; ++handle)
    EXPECT_EQ(deformer.pose().row(handle) == deformer.restHandles().row(handle), handle != 9 && handle != 12)
        << handle;
}

TEST_F(RestoreVolumeTest, RefusesWhatCannotBeReachedAndKeepsThePose) {
  Deformer deformer = sphereDeformer();
  Points pose = deformer.restHandles();
  pose.row(10) *= 1.01;
  deformer.setPose(pose);
  EXPECT_THROW(restoreVolume(deformer, 50 * deformer.restVolumeMm3(), {9}), DataError);
  EXPECT_EQ(deformer.pose(), pose);
  EXPECT_THROW(restoreVolume(deformer, deformer.restVolumeMm3(), {}), UsageError);
  EXPECT_THROW(restoreVolume(deformer, deformer.restVolumeMm3(), {20}), UsageError);
  EXPECT_EQ(deformer.pose(), pose);
}

TEST_F(RestoreVolumeTest, KnowsWhichHandlesAPoseLeavesAlone) {
  const Deformer deformer = sphereDeformer();
  Points pose = deformer.restHandles();
  pose.topRows(18).array() += 1;
  EXPECT_EQ(restingHandles(deformer.restHandles(), pose), (std::vector<int>{18, 19}));
}

} // namespace viscera::deformation
