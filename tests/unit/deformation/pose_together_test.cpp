#include "viscera/deformation/pose_together.h"

#include <limits>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "clouds.h"
#include "counting_system.h"
#include "shapes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"

namespace viscera::deformation {
namespace {

/// Organs of several sizes on the same handles: whole, partly outside the handles (those vertices are not
/// bound), bound by coordinates that are not linear, and by ones that have no pieces.
class PoseTogether : public testing::Test {
protected:
  PoseTogether() {
    handles_.positions = tests::onSphere(24, 45);
    const auto celestial = coordinates::sCelestial(), green = coordinates::greenCoordinates();
    const tests::CountingSystem counting(std::make_shared<tests::BindingCounts>());
    add(*celestial, tests::sphere(4, 30));
    add(*celestial, tests::sphere(5, 25));
    add(*celestial, tests::sphere(4, 20, {25, 5, 0}));
    add(*celestial, tests::sphere(1, 4, {3, 0, 8}));
    add(*green, tests::sphere(4, 18));
    add(counting, tests::sphere(3, 22));
  }

  void add(const coordinates::CoordinateSystem& system, geometry::TriangleMesh mesh) {
    Progress progress;
    auto rest = std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
    std::shared_ptr<const coordinates::Binding> binding = system.bind(handles_, rest->points, {}, progress);
    organs_.emplace_back(std::move(rest), std::move(binding), handles_.positions);
  }

  Points shaken(unsigned seed) const {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> by(-4, 4);
    Points pose = handles_.positions;
    for (Eigen::Index i = 0; i < pose.size(); ++i)
      pose.data()[i] += by(random);
    return pose;
  }

  static std::vector<Deformer*> allOf(std::vector<Deformer>& organs) {
    std::vector<Deformer*> all;
    for (Deformer& organ : organs)
      all.push_back(&organ);
    return all;
  }

  coordinates::HandleSet handles_;
  std::vector<Deformer> organs_;
};

TEST_F(PoseTogether, OneOfTheOrgansIsPartlyUnbound) {
  EXPECT_FALSE(organs_[2].binding().report().failures.empty());
}

TEST_F(PoseTogether, GivesTheBitsOfEachOrganByItself) {
  for (const int threads : {1, 2, 3}) {
    std::vector<Deformer> together = organs_, alone = organs_;
    std::vector<NewPose> poses;
    for (std::size_t k = 0; k < alone.size(); ++k) {
      const Points pose = shaken(static_cast<unsigned>(k));
      poses.push_back({&together[k], std::make_shared<const Points>(pose)});
      alone[k].setPose(pose);
    }
    poseTogether(poses, {threads});
    const std::vector<double> volumes = volumesTogether(allOf(together), {threads});
    for (std::size_t k = 0; k < alone.size(); ++k) {
      EXPECT_EQ(together[k].points(), alone[k].points()) << k << ", threads " << threads;
      EXPECT_EQ(together[k].pose(), alone[k].pose());
      EXPECT_EQ(volumes[k], alone[k].volumeMm3()) << k << ", threads " << threads;
      EXPECT_EQ(together[k].volumeMm3(), volumes[k]);
      EXPECT_EQ(together[k].volumeGradient(), alone[k].volumeGradient());
    }
  }
}

TEST_F(PoseTogether, MovesSingleHandlesAsEachOrganByItself) {
  for (const int threads : {1, 2, 3}) {
    std::vector<Deformer> together = organs_, alone = organs_;
    Points pose = handles_.positions;
    for (const std::vector<int>& moved : std::vector<std::vector<int>>{{3}, {0, 7, 11}, {3, 4}}) {
      std::vector<NewPose> poses;
      for (const int handle : moved)
        pose.row(handle) += Eigen::RowVector3d(1.5, -0.25 * handle, 2);
      for (std::size_t k = 0; k < alone.size(); ++k) {
        poses.push_back({&together[k], std::make_shared<const Points>(pose), moved});
        for (const int handle : moved)
          alone[k].moveHandle(handle, pose.row(handle).transpose());
      }
      poseTogether(poses, {threads});
      const std::vector<double> volumes = volumesTogether(allOf(together), {threads});
      for (std::size_t k = 0; k < alone.size(); ++k) {
        EXPECT_EQ(together[k].points(), alone[k].points()) << k << ", threads " << threads;
        EXPECT_EQ(together[k].pose(), pose);
        EXPECT_EQ(volumes[k], alone[k].volumeMm3());
      }
    }
  }
}

TEST_F(PoseTogether, RefusesABadPoseBeforeAnyOrganHasMoved) {
  std::vector<Deformer> organs = organs_;
  Points bad = shaken(1);
  bad(2, 1) = std::numeric_limits<double>::quiet_NaN();
  const auto good = std::make_shared<const Points>(shaken(1));
  const auto notFinite = std::make_shared<const Points>(bad);
  const auto tooShort = std::make_shared<const Points>(shaken(1).topRows(5));
  EXPECT_THROW(poseTogether({{&organs[0], good}, {&organs[1], notFinite}}), DataError);
  EXPECT_THROW(poseTogether({{&organs[0], good}, {&organs[1], tooShort}}), DataError);
  EXPECT_EQ(organs[0].points(), organs_[0].points());
  EXPECT_EQ(organs[0].pose(), organs_[0].pose());
}

TEST_F(PoseTogether, KeepsOnePoseForAllOrgans) {
  std::vector<Deformer> organs = organs_;
  const auto pose = std::make_shared<const Points>(shaken(1));
  poseTogether({{&organs[0], pose}, {&organs[1], pose}});
  EXPECT_EQ(&organs[0].pose(), pose.get());
  EXPECT_EQ(&organs[1].pose(), pose.get());
  auto next = std::make_shared<Points>(*pose);
  next->row(3).array() += 1;
  const std::shared_ptr<const Points> moved = next;
  poseTogether({{&organs[0], moved, {3}}, {&organs[1], moved, {3}}});
  EXPECT_EQ(&organs[0].pose(), moved.get());
  EXPECT_EQ(&organs[1].pose(), moved.get());
}

TEST_F(PoseTogether, NothingToDoIsFine) {
  poseTogether({});
  EXPECT_TRUE(volumesTogether({}).empty());
}

} // namespace
} // namespace viscera::deformation
