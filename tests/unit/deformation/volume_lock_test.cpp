#include "viscera/deformation/volume_lock.h"

#include <cmath>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clouds.h"
#include "counting_system.h"
#include "shapes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/deformation/selection_motion.h"
#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

constexpr double kAllowedError = 1e-9;

/// A closed organ-like surface, its handles and a lock at its rest volume.
struct Locked {
  explicit Locked(const Vec3& stretch = {60, 45, 35}) {
    auto mesh = tests::sphere(4);
    mesh.points = mesh.points * stretch.asDiagonal();
    rest = std::make_shared<geometry::TriangleMesh>(std::move(mesh));
    handles = placeHandles(*rest, {24, true, 0.05, 0.15});
    coordinates::HandleSet set;
    set.positions = handles;
    Progress progress;
    binding = coordinates::builtInSystems().front()->bind(set, rest->points, {}, progress);
    volume = geometry::volume(rest->points, rest->triangles);
  }
  VolumeLock lock() const { return VolumeLock({surface()}); }
  LockedSurface surface() const { return {"organ", rest, binding, volume}; }

  std::shared_ptr<const geometry::TriangleMesh> rest;
  std::shared_ptr<const coordinates::Binding> binding;
  Points handles;
  double volume = 0;
};

double relativeError(const VolumeLock& lock, const Points& pose) {
  double worst = 0;
  const auto volumes = lock.volumes(pose);
  for (std::size_t k = 0; k < volumes.size(); ++k)
    worst = std::max(worst, std::abs(volumes[k] / lock.surfaces()[k].targetMm3 - 1));
  return worst;
}

std::vector<int> allBut(Eigen::Index count, const std::vector<int>& taken) {
  std::vector<int> rest;
  for (int i = 0; i < count; ++i)
    if (std::find(taken.begin(), taken.end(), i) == taken.end())
      rest.push_back(i);
  return rest;
}

class RandomDrags {
public:
  explicit RandomDrags(unsigned seed) : random_(seed) {}
  Vec3 direction() { return tests::drawDirection(random_); }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  std::vector<int> selection(int count, Eigen::Index handles) {
    std::vector<int> all(static_cast<std::size_t>(handles));
    std::iota(all.begin(), all.end(), 0);
    std::shuffle(all.begin(), all.end(), random_);
    all.resize(static_cast<std::size_t>(count));
    std::sort(all.begin(), all.end());
    return all;
  }

private:
  std::mt19937 random_;
};

TEST(VolumeLock, TheGradientAgreesWithCentralDifferences) {
  const Locked organ;
  const auto lock = organ.lock();
  const double step = 1e-3;
  for (int handle = 0; handle < organ.handles.rows(); ++handle) {
    const Vec3 gradient = lock.translationGradient(organ.handles, {handle}).row(0).transpose();
    Vec3 differences;
    for (int k = 0; k < 3; ++k) {
      const Vec3 by = step * Vec3::Unit(k);
      differences[k] = (lock.volumes(translated(organ.handles, {handle}, by))[0] -
                        lock.volumes(translated(organ.handles, {handle}, -by))[0]) /
                       (2 * step);
    }
    EXPECT_LT((gradient - differences).norm(), 1e-6 * gradient.norm());
  }
}

TEST(VolumeLock, RotationsAndScalingsAreCompensatedExactly) {
  const Locked organ;
  const auto lock = organ.lock();
  RandomDrags drags(6);
  for (int i = 0; i < 200; ++i) {
    const auto five = drags.selection(5, organ.handles.rows());
    const Vec3 center = selectionCenter(organ.handles, five);
    const Points wanted = i % 2 == 0
                              ? rotated(organ.handles, five, center, drags.direction(), drags.between(-1, 1))
                              : scaled(organ.handles, five, center, Vec3::Constant(drags.between(0.6, 1.5)));
    const auto restored = lock.restore(wanted, allBut(organ.handles.rows(), five), LeastDisplacement(), 40);
    ASSERT_TRUE(restored.restored) << restored.reason;
    EXPECT_LT(relativeError(lock, restored.pose), kAllowedError);
    for (const int handle : five)
      EXPECT_EQ(restored.pose.row(handle), wanted.row(handle));
  }
}

TEST(VolumeLock, TheCompensationFollowsARotationWithoutAJump) {
  const Locked organ;
  const auto lock = organ.lock();
  const std::vector<int> five = {8, 10, 12, 14, 16};
  const Vec3 center = selectionCenter(organ.handles, five);
  const auto largestStep = [&](int steps) {
    Points before = organ.handles;
    double largest = 0;
    for (int i = 1; i <= steps; ++i) {
      const Points wanted = rotated(organ.handles, five, center, Vec3::UnitZ(), 1.2 * i / steps);
      const auto restored =
          lock.restore(wanted, allBut(organ.handles.rows(), five), LeastDisplacement(), 100);
      EXPECT_TRUE(restored.restored) << restored.reason;
      largest = std::max(largest, (restored.pose - before).rowwise().norm().maxCoeff());
      before = restored.pose;
    }
    return largest;
  };
  EXPECT_NEAR(largestStep(50) / largestStep(100), 2, 0.2);
}

TEST(VolumeLock, OnlyTheHandlesThatMayCompensateMove) {
  const Locked organ;
  const auto lock = organ.lock();
  const Points wanted = scaled(organ.handles, {9}, Vec3::Zero(), Vec3::Constant(1.2));
  const auto restored = lock.restore(wanted, {11, 20}, LeastDisplacement(), 100);
  ASSERT_TRUE(restored.restored) << restored.reason;
  for (const int handle : allBut(organ.handles.rows(), {11, 20}))
    EXPECT_EQ(restored.pose.row(handle), wanted.row(handle));
  EXPECT_GT(restored.largestShiftMm, 0);
}

TEST(VolumeLock, ReachesATargetVolume) {
  const Locked organ;
  auto lock = organ.lock();
  for (const double factor : {0.8, 0.95, 1.1, 1.3}) {
    lock.setTarget(0, factor * organ.volume);
    const auto restored =
        lock.restore(organ.handles, allBut(organ.handles.rows(), {}), LeastDisplacement(), 40);
    ASSERT_TRUE(restored.restored) << restored.reason;
    EXPECT_NEAR(lock.volumes(restored.pose)[0], factor * organ.volume, kAllowedError * organ.volume);
  }
}

TEST(VolumeLock, SaysWhyATargetIsOutOfReachAndKeepsThePose) {
  const Locked organ;
  auto lock = organ.lock();
  lock.setTarget(0, 50 * organ.volume);
  const auto restored =
      lock.restore(organ.handles, allBut(organ.handles.rows(), {}), LeastDisplacement(), 10);
  EXPECT_FALSE(restored.restored);
  EXPECT_THAT(restored.reason.english(), testing::HasSubstr("10 mm"));
  EXPECT_EQ(restored.pose, organ.handles);
  EXPECT_THAT(lock.restore(organ.handles, {}, LeastDisplacement(), 10).reason.english(),
              testing::HasSubstr("no handle"));
}

TEST(VolumeLock, KeepsTwoSurfacesAtOnce) {
  const Locked organ;
  auto inner = std::make_shared<geometry::TriangleMesh>(*organ.rest);
  inner->points = 0.5 * inner->points.array().matrix();
  coordinates::HandleSet set;
  set.positions = organ.handles;
  Progress progress;
  const LockedSurface cavity{"cavity", inner,
                             coordinates::builtInSystems().front()->bind(set, inner->points, {}, progress),
                             geometry::volume(inner->points, inner->triangles)};
  const VolumeLock lock({organ.surface(), cavity});
  RandomDrags drags(8);
  for (int i = 0; i < 50; ++i) {
    const auto five = drags.selection(5, organ.handles.rows());
    const Points wanted = rotated(organ.handles, five, Vec3::Zero(), drags.direction(), 0.3);
    const auto restored = lock.restore(wanted, allBut(organ.handles.rows(), five), LeastDisplacement(), 60);
    ASSERT_TRUE(restored.restored) << restored.reason;
    EXPECT_LT(relativeError(lock, restored.pose), kAllowedError);
  }
}

TEST(VolumeLock, RefusesAnOpenSurfaceWithTheNumberOfItsEdges) {
  Locked organ;
  auto open = std::make_shared<geometry::TriangleMesh>(*organ.rest);
  open->triangles.conservativeResize(open->triangles.rows() - 1, 3);
  auto surface = organ.surface();
  surface.rest = open;
  try {
    VolumeLock lock({surface});
    FAIL();
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("3 boundary edges"));
  }
}

TEST(VolumeLock, WithoutItsFormItKeepsTheSameVolumeAtNearlyTheSamePose) {
  const Locked organ;
  const VolumeLock with({organ.surface()});
  const VolumeLock without({organ.surface()}, {}, VolumeLock::Forms::given, {});
  RandomDrags drags(9);
  for (int i = 0; i < 20; ++i) {
    const auto five = drags.selection(5, organ.handles.rows());
    const Vec3 center = selectionCenter(organ.handles, five);
    const Points wanted = rotated(organ.handles, five, center, drags.direction(), 0.4);
    const auto free = allBut(organ.handles.rows(), five);
    const auto one = with.restore(wanted, free, LeastDisplacement(), 40);
    const auto other = without.restore(wanted, free, LeastDisplacement(), 40);
    ASSERT_TRUE(one.restored && other.restored);
    EXPECT_LT(relativeError(with, one.pose), 1e-12);
    EXPECT_LT(relativeError(without, other.pose), 1e-12);
    EXPECT_LT((one.pose - other.pose).cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST(VolumeLock, MakesItsFormOnceAndAnotherLockTakesItOver) {
  Locked organ;
  const auto counts = std::make_shared<tests::BindingCounts>();
  coordinates::HandleSet set;
  set.positions = organ.handles;
  Progress progress;
  organ.binding = tests::CountingSystem(counts).bind(set, organ.rest->points, {}, progress);
  const auto first = std::make_shared<const VolumeLock>(std::vector{organ.surface()});
  EXPECT_EQ(counts->influences, 0) << "nobody asked yet";
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(first->makeForms(cancelled), Cancelled);
  counts->influences = 0;
  first->makeForms(progress);
  EXPECT_EQ(counts->influences, organ.handles.rows());
  LockedSurface larger = organ.surface();
  larger.targetMm3 *= 1.05;
  const VolumeLock second({larger}, {}, VolumeLock::Forms::given, {nullptr, first});
  const auto restored =
      second.restore(organ.handles, allBut(organ.handles.rows(), {}), LeastDisplacement(), 40);
  EXPECT_TRUE(restored.restored);
  EXPECT_EQ(counts->influences, organ.handles.rows()) << "the form was made again";
  EXPECT_EQ(counts->pullBacks, 0) << "the form was not used";
}

TEST(VolumeLock, AFormThatIsCancelledHalfwayIsMadeForWhoeverAsksNext) {
  Locked organ;
  const auto counts = std::make_shared<tests::BindingCounts>();
  coordinates::HandleSet set;
  set.positions = organ.handles;
  Progress progress, cancelled;
  organ.binding = tests::CountingSystem(counts).bind(set, organ.rest->points, {}, progress);
  const VolumeLock lock({organ.surface()}, {1});
  counts->beforeInfluence = [&] { cancelled.cancel(); };
  EXPECT_THROW(lock.makeForms(cancelled), Cancelled);
  EXPECT_GT(counts->influences, 0) << "it had begun";
  counts->beforeInfluence = [] {};
  lock.makeForms(progress);
  EXPECT_TRUE(
      lock.restore(organ.handles, allBut(organ.handles.rows(), {}), LeastDisplacement(), 40).restored);
  EXPECT_EQ(counts->pullBacks, 0) << "the form was not used";
}

} // namespace
} // namespace viscera::deformation
