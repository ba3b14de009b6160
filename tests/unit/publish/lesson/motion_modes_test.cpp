#include "motion_modes.h"

#include <gtest/gtest.h>

namespace viscera::lesson {
namespace {

/// Vertices that hang on handles, and handles whose motion is a sum of `rank` motions.
struct Scene {
  static constexpr Eigen::Index kVertices = 700, kHandles = 60, kInstants = 150;
  CarrierWeights weights;
  Instants instants;

  explicit Scene(Eigen::Index rank) {
    std::srand(3);
    weights = CarrierWeights::Random(kVertices, kHandles).cwiseAbs();
    const Eigen::ArrayXd sums = weights.rowwise().sum();
    weights.array().colwise() /= sums;
    const Table times = Table::Random(kInstants, rank);
    for (Table* axis : {&instants.x, &instants.y, &instants.z})
      *axis = 20 * times * Table::Random(rank, kHandles);
  }
  Points truth(Eigen::Index instant) const {
    Points carriers(kHandles, 3);
    carriers << instants.x.row(instant).transpose(), instants.y.row(instant).transpose(),
        instants.z.row(instant).transpose();
    return weights * carriers;
  }
  double worst(const MotionModes& found) const {
    double worst = 0;
    for (Eigen::Index t = 0; t < kInstants; ++t) {
      Points points = Points::Zero(kVertices, 3);
      for (std::size_t k = 0; k < found.modes.size(); ++k)
        points += found.course(t, static_cast<Eigen::Index>(k)) * found.modes[k];
      worst = std::max(worst, (points - truth(t)).rowwise().norm().maxCoeff());
    }
    return worst;
  }
};

} // namespace

TEST(MotionModes, AreAsManyAsTheMotionHas) {
  Progress progress;
  const Scene scene(5);
  const MotionModes found = modesOf(scene.instants, scene.weights, 1e-4, progress, {});
  EXPECT_EQ(found.modes.size(), 5u);
  EXPECT_LT(scene.worst(found), 1e-3);
  for (Eigen::Index k = 0; k < found.course.cols(); ++k)
    EXPECT_NEAR(found.course.col(k).cwiseAbs().maxCoeff(), 1, 1e-12);
}

TEST(MotionModes, KeepTheTolerance) {
  Progress progress;
  const Scene scene(30);
  const MotionModes fine = modesOf(scene.instants, scene.weights, 0.005, progress, {});
  const MotionModes coarse = modesOf(scene.instants, scene.weights, 5, progress, {});
  EXPECT_LT(scene.worst(fine), 0.005 + 1e-3);
  EXPECT_LT(scene.worst(coarse), 5);
  EXPECT_GT(scene.worst(coarse), 0.005) << "nothing was left out";
  EXPECT_LT(coarse.modes.size(), fine.modes.size());
}

TEST(MotionModes, DoNotDependOnTheThreads) {
  Progress progress;
  const Scene scene(8);
  const MotionModes one = modesOf(scene.instants, scene.weights, 0.005, progress, Threads{1});
  const MotionModes many = modesOf(scene.instants, scene.weights, 0.005, progress, Threads{4});
  EXPECT_TRUE(one.course == many.course);
  EXPECT_TRUE(one.modes == many.modes);
}

TEST(MotionModes, OfVerticesThatCarryThemselvesAreTheSame) {
  Progress progress;
  const Scene scene(4);
  Instants vertices;
  vertices.x = scene.instants.x * scene.weights.transpose();
  vertices.y = scene.instants.y * scene.weights.transpose();
  vertices.z = scene.instants.z * scene.weights.transpose();
  const MotionModes found = modesOf(vertices, CarrierWeights(Scene::kVertices, 0), 1e-4, progress, {});
  EXPECT_EQ(found.modes.size(), 4u);
  EXPECT_LT(scene.worst(found), 1e-3);
}

TEST(MotionModes, OfNoMotionAreNone) {
  Progress progress;
  Scene scene(1);
  for (Table* axis : {&scene.instants.x, &scene.instants.y, &scene.instants.z})
    axis->setZero();
  EXPECT_TRUE(modesOf(scene.instants, scene.weights, 0.005, progress, {}).modes.empty());
}

TEST(MotionModes, FindTheLargestDifferenceOfAll) {
  Progress progress;
  const Scene scene(6);
  const MotionModes found = modesOf(scene.instants, scene.weights, 1e-4, progress, {});
  const Table differences = Table::Random(40, found.course.cols());
  double largest = 0;
  for (Eigen::Index t = 0; t < differences.rows(); ++t) {
    Points off = Points::Zero(Scene::kVertices, 3);
    for (std::size_t k = 0; k < found.modes.size(); ++k)
      off += differences(t, static_cast<Eigen::Index>(k)) * found.modes[k];
    largest = std::max(largest, off.rowwise().norm().maxCoeff());
  }
  EXPECT_EQ(largestDifference(found.modes, differences).mm, largest);
}

} // namespace viscera::lesson
