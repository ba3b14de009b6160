#include "viscera/live/locked_motion.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "clouds.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/geometry/volume.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::live {
namespace {

using deformation::LockedSurface;
using deformation::MirrorPlane;
using deformation::VolumeLock;

constexpr double kAllowedError = 1e-9;
constexpr int kHandles = 30;

/// The surfaces of a sample organ, bound to handles around the outer one.
class LockedOrgan {
public:
  LockedOrgan(const std::string& name, std::size_t lockedSurfaces) {
    Progress progress;
    const sample_organs::SampleLibrary library = {std::filesystem::path(VISCERA_SOURCE_DIR) / "sample_organs",
                                                  std::filesystem::path(VISCERA_BINARY_DIR) / "test_organs"};
    const auto organ = sample_organs::sampleOrgan(library, name, sample_organs::Resolution::low, progress);
    coordinates::HandleSet set;
    handles = deformation::placeHandles(*organ.surfaces.front().mesh, {kHandles, true, 0.05, 0.15});
    set.positions = handles;
    std::vector<LockedSurface> locked;
    for (std::size_t k = 0; k < std::min(lockedSurfaces, organ.surfaces.size()); ++k) {
      const auto& mesh = organ.surfaces[k].mesh;
      locked.push_back(
          {organ.surfaces[k].name, mesh,
           deformation::bindOrgan(*coordinates::builtInSystems().front(), set, mesh->points, {}, progress),
           geometry::volume(mesh->points, mesh->triangles)});
    }
    lock = std::make_shared<VolumeLock>(std::move(locked));
    size = boundsOf(organ.surfaces.front().mesh->points).diagonal();
    center = boundsOf(organ.surfaces.front().mesh->points).center();
  }

  double error(const Points& pose) const {
    double worst = 0;
    const auto volumes = lock->volumes(pose);
    for (std::size_t k = 0; k < volumes.size(); ++k)
      worst = std::max(worst, std::abs(volumes[k] / lock->surfaces()[k].targetMm3 - 1));
    return worst;
  }

  LockedMotion motion(const std::vector<int>& selection, const std::vector<int>& marked = {},
                      const std::optional<Vec3>& plane = std::nullopt) const {
    LockedMotion::Setup setup{lock, handles, selection};
    setup.plane = plane;
    setup.limitMm = 0.5 * boundsOf(handles).diagonal();
    setup.compensating = marked;
    setup.alwaysCompensate = !marked.empty();
    if (marked.empty()) {
      setup.compensating.resize(kHandles);
      std::iota(setup.compensating.begin(), setup.compensating.end(), 0);
    }
    return LockedMotion(std::move(setup));
  }

  LockedMotion mirrored(const std::vector<int>& selection, const MirrorPlane& plane,
                        const std::optional<Vec3>& slice = std::nullopt) const {
    LockedMotion::Setup setup{lock, handles, selection};
    setup.plane = slice;
    setup.mirror = {plane, deformation::mirrorPartners(handles, selection, plane, 0.2 * size)};
    setup.limitMm = 0.5 * boundsOf(handles).diagonal();
    return LockedMotion(std::move(setup));
  }

  std::shared_ptr<VolumeLock> lock;
  Points handles;
  double size = 0;
  Vec3 center;
};

class Random {
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vec3 direction() { return tests::drawDirection(engine_); }
  std::vector<int> handles(int count) {
    std::vector<int> all(kHandles);
    std::iota(all.begin(), all.end(), 0);
    std::shuffle(all.begin(), all.end(), engine_);
    all.resize(static_cast<std::size_t>(count));
    std::sort(all.begin(), all.end());
    return all;
  }

private:
  std::mt19937 engine_;
};

double longest(const Points& difference) {
  return difference.rowwise().norm().maxCoeff();
}

/// What is done with each fraction of a random motion.
using Wish = std::function<const Points&(LockedMotion&, double fraction)>;

/// Goes along a motion in small steps; the volumes stay, and no step is much farther than the wish went.
void expectKeptAlong(const LockedOrgan& organ, LockedMotion motion, double length, const Wish& wish,
                     const std::string& what) {
  constexpr int kSteps = 8;
  // A compensating handle with little influence goes farther than the one that it makes up for.
  constexpr double kFarthestOfAStep = 4;
  Points before = motion.pose();
  for (int step = 1; step <= kSteps; ++step) {
    const Points& now = wish(motion, double(step) / kSteps);
    ASSERT_LE(organ.error(now), kAllowedError) << what << ", step " << step;
    ASSERT_LE(longest(now - before), kFarthestOfAStep * length / kSteps) << what << ", step " << step;
    before = now;
  }
  ASSERT_GT(longest(before - motion.start()), 0) << what;
}

struct Case {
  const char* organ;
  std::size_t surfaces;
};

class LockedMotions : public ::testing::TestWithParam<Case> {
protected:
  void SetUp() override { organ_ = std::make_unique<LockedOrgan>(GetParam().organ, GetParam().surfaces); }
  std::unique_ptr<LockedOrgan> organ_;
  Random random_{7};
};

TEST_P(LockedMotions, SingleHandlesAndGroupsKeepTheVolumesWithoutAJump) {
  for (int drag = 0; drag < 12; ++drag) {
    const double length = random_.between(0.02, 0.25) * organ_->size;
    const Vec3 by = length * random_.direction();
    expectKeptAlong(
        *organ_, organ_->motion(random_.handles(drag % 2 ? 5 : 1)), length,
        [&](LockedMotion& motion, double part) -> const Points& { return motion.translate(part * by); },
        "drag " + std::to_string(drag));
  }
}

TEST_P(LockedMotions, RotationsAndScalingsKeepTheVolumesWithoutAJump) {
  for (int turn = 0; turn < 8; ++turn) {
    LockedMotion motion = organ_->motion(random_.handles(5));
    const Vec3 center = deformation::selectionCenter(motion.start(), motion.selection());
    const Vec3 axis = random_.direction();
    const double angle = random_.between(-1, 1);
    const Vec3 factors = Vec3::Ones() + random_.between(-0.5, 0.5) * random_.direction();
    const Wish rotate = [&](LockedMotion& m, double part) -> const Points& {
      return m.rotate(center, axis, part * angle);
    };
    const Wish scale = [&](LockedMotion& m, double part) -> const Points& {
      return m.scale(center, Vec3::Ones() + part * (factors - Vec3::Ones()));
    };
    expectKeptAlong(*organ_, std::move(motion), 0.5 * organ_->size, turn % 2 ? rotate : scale,
                    "turn " + std::to_string(turn));
  }
}

TEST_P(LockedMotions, MirroredPairsKeepTheVolumesWithoutAJump) {
  for (int drag = 0; drag < 8; ++drag) {
    MirrorPlane plane{organ_->center, Vec3::Unit(drag % 3)};
    LockedMotion motion = organ_->mirrored(random_.handles(1), plane);
    if (GetParam().surfaces > 1)
      continue; // Without compensating handles only one volume can be kept.
    const double length = random_.between(0.02, 0.25) * organ_->size;
    const Vec3 by = length * random_.direction();
    expectKeptAlong(
        *organ_, std::move(motion), length,
        [&](LockedMotion& m, double part) -> const Points& { return m.translate(part * by); },
        "pair " + std::to_string(drag));
  }
}

TEST_P(LockedMotions, MarkedHandlesMakeUpForTheVolumeAndTheDraggedOneGoesWhereItIsWanted) {
  LockedMotion motion = organ_->motion({9}, {2, 3, 11, 14, 20});
  const Vec3 by = 0.05 * organ_->size * Vec3(1, -1, 0.5).normalized();
  const Points& pose = motion.translate(by);
  EXPECT_EQ(motion.obstacle().english(), "");
  EXPECT_LE(organ_->error(pose), kAllowedError);
  EXPECT_LE((pose.row(9) - motion.start().row(9) - by.transpose()).norm(), 1e-12 * organ_->size);
  for (int row = 0; row < kHandles; ++row)
    if (row != 9 && row != 2 && row != 3 && row != 11 && row != 14 && row != 20) {
      EXPECT_EQ(pose.row(row), motion.start().row(row));
    }
  EXPECT_EQ(motion.planeNormal(), Vec3(Vec3::Zero()));
}

TEST_P(LockedMotions, ADragThatIsHeldToASliceStaysInItAndKeepsTheVolumes) {
  for (int drag = 0; drag < 12; ++drag) {
    const int axis = drag % 3;
    const LockedMotion begun = organ_->motion(random_.handles(drag % 2 ? 5 : 1), {}, Vec3(Vec3::Unit(axis)));
    const double length = random_.between(0.02, 0.2) * organ_->size;
    const Vec3 by = length * random_.direction();
    const std::string what = "drag " + std::to_string(drag);
    expectKeptAlong(
        *organ_, begun, length,
        [&](LockedMotion& motion, double part) -> const Points& {
          const Points& pose = motion.translate(part * by);
          for (const int row : motion.selection())
            EXPECT_EQ(pose(row, axis), motion.start()(row, axis)) << what;
          return pose;
        },
        what);
  }
}

TEST_P(LockedMotions, GoingBackToWhereItBeganEndsWhereItBegan) {
  for (const int count : {1, 5}) {
    LockedMotion motion = organ_->motion(random_.handles(count));
    motion.translate(0.2 * organ_->size * random_.direction());
    EXPECT_LE(longest(motion.translate(Vec3::Zero()) - motion.start()), 1e-9 * organ_->size);
  }
}

INSTANTIATE_TEST_SUITE_P(Organs, LockedMotions,
                         ::testing::Values(Case{"heart", 1}, Case{"stomach", 1}, Case{"heart", 3}),
                         [](const auto& instance) {
                           return std::string(instance.param.organ) +
                                  (instance.param.surfaces > 1 ? "WithCavities" : "");
                         });

TEST(LockedMotion, ADraggedHandleComesAsNearAsThePlaneAllows) {
  const LockedOrgan organ("stomach", 1);
  Random random(3);
  for (int drag = 0; drag < 20; ++drag) {
    LockedMotion motion = organ.motion(random.handles(1));
    const int row = motion.selection().front();
    const Vec3 by = 0.2 * organ.size * random.direction();
    const Vec3 moved = (motion.translate(by).row(row) - motion.start().row(row)).transpose();
    const Vec3 normal = motion.planeNormal();
    EXPECT_NEAR(normal.norm(), 1, 1e-12);
    EXPECT_NEAR((moved - (by - normal.dot(by) * normal)).norm(), 0, 1e-9 * organ.size);
  }
}

TEST(LockedMotion, HeldToASliceAHandleComesAsNearAsTheLineInItAllowsAndNothingElseMoves) {
  const LockedOrgan organ("stomach", 1);
  Random random(5);
  for (int drag = 0; drag < 12; ++drag) {
    const int axis = drag % 3;
    LockedMotion motion = organ.motion(random.handles(1), {}, Vec3(Vec3::Unit(axis)));
    const int row = motion.selection().front();
    const Vec3 by = 0.2 * organ.size * random.direction();
    Points others = motion.translate(by) - motion.start();
    const Vec3 moved = others.row(row).transpose();
    others.row(row).setZero();
    EXPECT_EQ(others.norm(), 0);
    Vec3 inSlice = by;
    inSlice[axis] = 0;
    // The line along which the volume stays is at a right angle to what the slice has of the gradient.
    const Vec3 line = motion.planeNormal().cross(Vec3(Vec3::Unit(axis))).normalized();
    EXPECT_NEAR((moved - line.dot(inSlice) * line).norm(), 0, 1e-9 * organ.size) << "drag " << drag;
    EXPECT_LE(organ.error(motion.pose()), kAllowedError);
  }
}

TEST(LockedMotion, HeldToThePlaneInWhichTheVolumeStaysAHandleGoesWhereverThatPlaneLeads) {
  const LockedOrgan organ("stomach", 1);
  Random random(9);
  for (int drag = 0; drag < 6; ++drag) {
    const std::vector<int> handle = random.handles(1);
    const Vec3 normal = organ.motion(handle).planeNormal();
    LockedMotion motion = organ.motion(handle, {}, normal);
    const Vec3 by = 0.2 * organ.size * random.direction();
    const int row = handle.front();
    const Vec3 moved = (motion.translate(by).row(row) - motion.start().row(row)).transpose();
    EXPECT_NEAR((moved - (by - normal.dot(by) * normal)).norm(), 0, 1e-9 * organ.size) << "drag " << drag;
    EXPECT_LE(organ.error(motion.pose()), kAllowedError);
  }
}

TEST(LockedMotion, HeldToASliceAPairOfMirrorImagesStaysInItToo) {
  const LockedOrgan organ("heart", 1);
  Random random(2);
  const MirrorPlane sagittal{organ.center, Vec3::UnitX()};
  double farthest = 0;
  for (int drag = 0; drag < 6; ++drag) {
    LockedMotion motion = organ.mirrored(random.handles(1), sagittal, Vec3(Vec3::UnitZ()));
    const Points way = motion.translate(0.1 * organ.size * random.direction()) - motion.start();
    EXPECT_LE(organ.error(motion.pose()), kAllowedError);
    EXPECT_EQ(way.col(2).cwiseAbs().maxCoeff(), 0) << "drag " << drag;
    farthest = std::max(farthest, longest(way));
  }
  EXPECT_GT(farthest, 0.01 * organ.size);
}

TEST(LockedMotion, AWishBeyondReachStopsOnItsWayAndSaysWhy) {
  const LockedOrgan organ("stomach", 1);
  LockedMotion motion = organ.motion({8, 9, 10, 11, 12, 13, 14, 15, 16, 17}, {18});
  const Vec3 center = deformation::selectionCenter(motion.start(), motion.selection());
  const Points& pose = motion.scale(center, Vec3::Constant(6));
  EXPECT_NE(motion.obstacle().english(), "");
  EXPECT_LE(organ.error(pose), kAllowedError);
  // What is possible again is done again.
  motion.scale(center, Vec3::Constant(1.001));
  EXPECT_EQ(motion.obstacle().english(), "");
  EXPECT_LE(organ.error(motion.pose()), kAllowedError);
}

TEST(LockedMotion, WithoutALockEverythingGoesWhereItIsWanted) {
  const LockedOrgan organ("stomach", 1);
  LockedMotion motion({nullptr, organ.handles, {1, 4}});
  const Points& pose = motion.translate({1, 2, 3});
  EXPECT_EQ(pose, deformation::translated(organ.handles, {1, 4}, {1, 2, 3}));
  EXPECT_EQ(motion.planeNormal(), Vec3(Vec3::Zero()));
  const Points turned = deformation::rotated(organ.handles, {1, 4}, {0, 0, 0}, Vec3::UnitZ(), 0.3);
  EXPECT_EQ(motion.rotate({0, 0, 0}, Vec3::UnitZ(), 0.3), turned);
}

TEST(LockedMotion, TurningAllHandlesNeedsNobodyToCompensate) {
  const LockedOrgan organ("stomach", 1);
  Random random(1);
  LockedMotion motion = organ.motion(random.handles(kHandles));
  const Points& pose = motion.rotate(organ.center, Vec3(1, 1, 1).normalized(), std::numbers::pi / 3);
  EXPECT_EQ(motion.obstacle().english(), "");
  EXPECT_LE(organ.error(pose), kAllowedError);
  EXPECT_GT(longest(pose - motion.start()), 0.1 * organ.size);
}

} // namespace
} // namespace viscera::live
