#include "viscera/motion/volume_kept_sequence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/coordinates/built_in_systems.h"
#include "viscera/core/error.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/geometry/volume.h"

namespace viscera::motion {
namespace {

constexpr double kPeriodSeconds = 2;

/// Squeezes the handles towards an axis and lets go of them again, twisting a little.
class Squeeze final : public sequences::Sequence {
public:
  explicit Squeeze(Points rest) : rest_(std::move(rest)) {}
  std::string id() const override { return "squeeze"; }
  std::string name() const override { return "Squeeze"; }
  const Points& restHandles() const override { return rest_; }
  double standardRatePerMinute() const override { return 60 / kPeriodSeconds; }
  double lowestRatePerMinute() const override { return 10; }
  double highestRatePerMinute() const override { return 60; }
  void poseAt(double seconds, double rate, Points& pose) const override {
    const double grip = (1 - std::cos(2 * std::numbers::pi * seconds * rate / 60)) / 2;
    pose = rest_;
    for (Eigen::Index i = 0; i < pose.rows(); ++i) {
      const double angle = 0.004 * grip * rest_(i, 2);
      const Vec3 at = (1 - 0.2 * grip) * Vec3(rest_(i, 0), rest_(i, 1), 0);
      pose.row(i) << std::cos(angle) * at.x() - std::sin(angle) * at.y(),
          std::sin(angle) * at.x() + std::cos(angle) * at.y(), rest_(i, 2);
    }
  }
  std::vector<sequences::Phase> phases(double) const override { return {{"squeeze", 0, 1}}; }

private:
  Points rest_;
};

class VolumeKept : public testing::Test {
protected:
  void SetUp() override {
    auto mesh = tests::sphere(4);
    mesh.points = mesh.points * Vec3(40, 35, 60).asDiagonal();
    mesh_ = std::make_shared<geometry::TriangleMesh>(std::move(mesh));
    restMl_ = geometry::volume(mesh_->points, mesh_->triangles) / kMm3PerMl;
    coordinates::HandleSet handles;
    handles.positions = deformation::placeHandles(*mesh_, {24, true, 0.05, 0.15});
    Progress progress;
    binding_ = coordinates::builtInSystems().front()->bind(handles, mesh_->points, {}, progress);
    moving_ = std::make_shared<Squeeze>(handles.positions);
    lock_ = std::make_shared<deformation::VolumeLock>(
        std::vector<deformation::LockedSurface>{{"egg", mesh_, binding_, restMl_ * kMm3PerMl}});
  }

  double milliliters(const sequences::Sequence& sequence, double seconds) const {
    Points pose, points;
    sequence.poseAt(seconds, sequence.standardRatePerMinute(), pose);
    binding_->deform(pose, points);
    return geometry::volume(points, mesh_->triangles) / kMm3PerMl;
  }

  VolumeKeptSequence kept(const sequences::Curve& curve, std::vector<int> compensating = {}) const {
    return {moving_, lock_, curve, std::move(compensating), 50};
  }

  std::shared_ptr<const geometry::TriangleMesh> mesh_;
  std::shared_ptr<const coordinates::Binding> binding_;
  std::shared_ptr<const sequences::Sequence> moving_;
  std::shared_ptr<const deformation::VolumeLock> lock_;
  double restMl_ = 0;
};

TEST_F(VolumeKept, AConstantCurveLocksTheVolumeOfAMotionThatWouldLoseAThirdOfIt) {
  EXPECT_LT(milliliters(*moving_, kPeriodSeconds / 2), 0.8 * restMl_);
  const auto sequence = kept(sequences::Curve::periodic({{0, restMl_}}, 1));
  for (int i = 0; i < 200; ++i)
    EXPECT_NEAR(milliliters(sequence, i * 0.0137) / restMl_, 1, 1e-9) << "instant " << i;
}

TEST_F(VolumeKept, TheVolumeFollowsTheCurveAtEveryInstant) {
  const auto curve =
      sequences::Curve::periodic({{0, restMl_}, {0.4, 0.85 * restMl_}, {0.7, 1.05 * restMl_}}, 1);
  const auto sequence = kept(curve);
  for (int i = 0; i < 200; ++i) {
    const double seconds = i * 0.0137;
    const double wanted = curve.at(std::fmod(seconds / kPeriodSeconds, 1));
    EXPECT_NEAR(milliliters(sequence, seconds) / wanted, 1, 1e-9) << "instant " << i;
  }
}

TEST_F(VolumeKept, OnlyTheHandlesThatMayCompensateLeaveTheMotion) {
  const std::vector<int> some = {8, 9, 10, 11, 13, 15, 17, 19, 21, 22};
  const auto sequence = kept(sequences::Curve::periodic({{0, 0.98 * restMl_}}, 1), some);
  Points with, without;
  sequence.poseAt(0.3, 30, with);
  moving_->poseAt(0.3, 30, without);
  for (int i = 0; i < with.rows(); ++i)
    EXPECT_EQ(with.row(i) == without.row(i), std::find(some.begin(), some.end(), i) == some.end())
        << "handle " << i;
}

TEST_F(VolumeKept, TheSameInstantIsTheSamePoseWhateverWasPlayedBefore) {
  const auto sequence = kept(sequences::Curve::periodic({{0, restMl_}}, 1));
  Points first, again, other;
  sequence.poseAt(0.77, 30, first);
  sequence.poseAt(1.9, 45, other);
  sequence.poseAt(0.77, 30, again);
  EXPECT_EQ(first, again);
}

TEST_F(VolumeKept, SaysAtWhichInstantAVolumeIsOutOfReach) {
  const auto curve = sequences::Curve::periodic({{0, restMl_}, {0.5, 40 * restMl_}}, 1);
  try {
    kept(curve, {10});
    FAIL() << "forty times the volume by one handle";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("of the cycle"));
    EXPECT_FALSE(error.tryThis().empty());
  }
}

} // namespace
} // namespace viscera::motion
