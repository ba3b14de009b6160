#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clouds.h"
#include "organ_cases.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/deformation/selection_motion.h"
#include "viscera/deformation/volume_lock.h"
#include "viscera/geometry/volume.h"
#include "viscera/live/locked_motion.h"

namespace viscera::deformation {
namespace {

/// Five kinds: 10,000 drags an organ, each measured on the surface itself.
constexpr int kDragsOfAKind = 2000;
constexpr double kAllowedError = 1e-9;

class VolumeLockOnOrgans : public testing::TestWithParam<tests::OrganCase> {
protected:
  void SetUp() override {
    auto mesh = tests::load(GetParam());
    if (!mesh)
      GTEST_SKIP() << "../shared/organs/" << GetParam().file << " is not there";
    organ_ = std::make_shared<geometry::TriangleMesh>(std::move(*mesh));
    coordinates::HandleSet handles;
    handles.positions = placeHandles(*organ_);
    rest_ = handles.positions;
    Progress progress;
    const auto binding =
        bindOrgan(*coordinates::builtInSystems().front(), handles, organ_->points, {}, progress);
    lock_ = std::make_shared<VolumeLock>(std::vector<LockedSurface>{
        {GetParam().name, organ_, binding, geometry::volume(organ_->points, organ_->triangles)}});
    size_ = boundsOf(organ_->points).diagonal();
    random_.seed(1234);
  }

  Vec3 direction() { return tests::drawDirection(random_); }
  double upTo(double most) { return std::uniform_real_distribution<double>(0, most)(random_); }

  /// `count` handles of those near the surface, not of the enclosing box.
  std::vector<int> selection(int count) {
    std::vector<int> all(static_cast<std::size_t>(rest_.rows() - 8));
    std::iota(all.begin(), all.end(), 8);
    std::shuffle(all.begin(), all.end(), random_);
    all.resize(static_cast<std::size_t>(count));
    std::sort(all.begin(), all.end());
    return all;
  }

  std::vector<int> others(const std::vector<int>& moved) const {
    std::vector<int> list;
    for (int i = 0; i < rest_.rows(); ++i)
      if (!std::binary_search(moved.begin(), moved.end(), i))
        list.push_back(i);
    return list;
  }

  double error(const Points& pose) const {
    return std::abs(lock_->volumes(pose)[0] / lock_->surfaces()[0].targetMm3 - 1);
  }

  /// Drags of any length up to half the organ keep the volume, and the selection goes where the plane allows.
  void translate(int count) {
    for (int i = 0; i < kDragsOfAKind; ++i) {
      const auto chosen = selection(count);
      const Vec3 wanted = upTo(size_ / 2) * direction();
      live::LockedMotion motion({lock_, rest_, chosen});
      motion.translate(wanted);
      const Vec3 by = (motion.pose().row(chosen.front()) - rest_.row(chosen.front())).transpose();
      ASSERT_LT(error(motion.pose()), kAllowedError) << "drag " << i;
      ASSERT_LE((by - wanted).norm(), wanted.norm() * (1 + 1e-9)) << "drag " << i;
    }
  }

  /// Either the volume is kept exactly, or the lock says why not.
  void compensate(const std::vector<int>& chosen, const Points& wanted, int& kept) {
    const auto restored = lock_->restore(wanted, others(chosen), LeastDisplacement(), size_);
    if (!restored.restored) {
      EXPECT_FALSE(restored.reason.empty());
      EXPECT_EQ(restored.pose, wanted);
      return;
    }
    ++kept;
    ASSERT_LT(error(restored.pose), kAllowedError);
    for (const int handle : chosen)
      ASSERT_EQ(restored.pose.row(handle), wanted.row(handle));
  }

  std::shared_ptr<const geometry::TriangleMesh> organ_;
  Points rest_;
  std::shared_ptr<VolumeLock> lock_;
  double size_ = 0;
  std::mt19937 random_;
};

TEST_P(VolumeLockOnOrgans, KeepsTheVolumeWhileOneHandleIsDragged) {
  translate(1);
}

TEST_P(VolumeLockOnOrgans, KeepsTheVolumeWhileFiveHandlesAreDragged) {
  translate(5);
}

TEST_P(VolumeLockOnOrgans, KeepsTheVolumeWhileFiveHandlesAreTurned) {
  int kept = 0;
  for (int i = 0; i < kDragsOfAKind; ++i) {
    const auto five = selection(5);
    compensate(five, rotated(rest_, five, selectionCenter(rest_, five), direction(), upTo(1.5)), kept);
  }
  EXPECT_GT(kept, 0.99 * kDragsOfAKind);
}

TEST_P(VolumeLockOnOrgans, KeepsTheVolumeWhileFiveHandlesAreScaled) {
  int kept = 0;
  for (int i = 0; i < kDragsOfAKind; ++i) {
    const auto five = selection(5);
    compensate(five, scaled(rest_, five, selectionCenter(rest_, five), Vec3::Constant(0.5 + upTo(1))), kept);
  }
  EXPECT_GT(kept, 0.99 * kDragsOfAKind);
}

TEST_P(VolumeLockOnOrgans, KeepsTheVolumeWhileAPairIsDraggedSymmetrically) {
  int kept = 0;
  const MirrorPlane plane{boundsOf(organ_->points).center(), Vec3::UnitX()};
  for (int i = 0; i < kDragsOfAKind; ++i) {
    const auto pair = selection(2);
    const std::vector<int> first = {pair[0]}, partner = {pair[1]};
    compensate(pair, mirroredTranslation(rest_, first, partner, plane, upTo(size_ / 4) * direction()), kept);
  }
  EXPECT_GT(kept, 0.99 * kDragsOfAKind);
}

INSTANTIATE_TEST_SUITE_P(Organs, VolumeLockOnOrgans, testing::ValuesIn(tests::organCases()),
                         [](const auto& organ) { return organ.param.name; });

/// The bunny stands on holes: it has no volume until they are closed.
TEST(VolumeLockOnOpenSurface, RefusesTheBunnyWithTheNumberOfItsBoundaryEdges) {
  const auto mesh = tests::load({"bunny", "bunny.obj"});
  if (!mesh)
    GTEST_SKIP() << "../shared/organs/bunny.obj is not there";
  const auto bunny = std::make_shared<geometry::TriangleMesh>(*mesh);
  const int edges = geometry::checkSurface(*bunny).boundaryEdges;
  ASSERT_GT(edges, 0);
  coordinates::HandleSet handles;
  handles.positions = placeHandles(*bunny);
  Progress progress;
  const std::shared_ptr<const coordinates::Binding> binding =
      coordinates::builtInSystems().front()->bind(handles, bunny->points, {}, progress);
  try {
    VolumeLock lock({{"bunny", bunny, binding, 1000}});
    FAIL() << "an open surface was locked";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(std::to_string(edges) + " boundary edges"));
    EXPECT_THAT(error.tryThis().english(), testing::HasSubstr("close"));
  }
}

} // namespace
} // namespace viscera::deformation
