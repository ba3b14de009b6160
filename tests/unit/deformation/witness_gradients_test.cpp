#include "viscera/deformation/witness_gradients.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"

namespace viscera::deformation {
namespace {

/// Forty witnesses inside twelve handles.
class WitnessGradientsTest : public testing::Test {
protected:
  WitnessGradientsTest() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> inside(-30, 30), off(-8, 8);
    handles_.positions.resize(12, 3);
    for (int i = 0; i < 8; ++i)
      handles_.positions.row(i) << ((i & 1) ? 50 : -50), ((i & 2) ? 50 : -50), ((i & 4) ? 50 : -50);
    for (int i = 8; i < 12; ++i)
      handles_.positions.row(i) << inside(random), inside(random), 40 + off(random);
    points_.resize(40, 3);
    for (Eigen::Index i = 0; i < points_.size(); ++i)
      points_.data()[i] = inside(random);
    Progress progress;
    system_ = coordinates::builtInSystems().front();
    gradients_ = system_->gradients(handles_, points_, {}, progress);
    pose_ = handles_.positions;
    for (Eigen::Index i = 0; i < pose_.size(); ++i)
      pose_.data()[i] += off(random);
  }
  WitnessGradients witnesses() const {
    WitnessGradients all(points_.rows(), handles_.positions.rows(), gradients_.lift);
    all.put(0, gradients_, points_.rows());
    return all;
  }

  coordinates::HandleSet handles_;
  Points points_, pose_;
  std::shared_ptr<const coordinates::CoordinateSystem> system_;
  coordinates::CoordinateGradients gradients_;
};

TEST_F(WitnessGradientsTest, ARigidMotionHasNoStressAndKeepsVolumes) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Points moved = (handles_.positions * turn.transpose()).rowwise() + Eigen::RowVector3d(500, -20, 7);
  StressMap map;
  witnesses().evaluate(moved, map);
  EXPECT_LT(map.rotationalStress.maxCoeff(), 1e-9);
  EXPECT_LT((map.volumeRatio.array() - 1).abs().maxCoeff(), 1e-9);
  EXPECT_EQ(map.folded, 0);
}

TEST_F(WitnessGradientsTest, TheDeformationGradientIsTheDerivativeOfTheDeformation) {
  const auto all = witnesses();
  const double step = 1e-4;
  Points shifted(6 * points_.rows(), 3);
  for (Eigen::Index i = 0; i < points_.rows(); ++i)
    for (int k = 0; k < 3; ++k) {
      shifted.row(6 * i + 2 * k) = points_.row(i) + step * Eigen::RowVector3d::Unit(k);
      shifted.row(6 * i + 2 * k + 1) = points_.row(i) - step * Eigen::RowVector3d::Unit(k);
    }
  Progress progress;
  Points posed;
  system_->bind(handles_, shifted, {}, progress)->deform(pose_, posed);
  for (Eigen::Index i = 0; i < points_.rows(); ++i) {
    Eigen::Matrix3d differences;
    for (int k = 0; k < 3; ++k)
      differences.col(k) = (posed.row(6 * i + 2 * k) - posed.row(6 * i + 2 * k + 1)).transpose() / (2 * step);
    EXPECT_LT((all.deformationGradient(i, pose_) - differences).norm(), 1e-6);
  }
}

TEST_F(WitnessGradientsTest, TheMapHoldsTheDistortionOfEveryGradient) {
  const auto all = witnesses();
  StressMap map;
  all.evaluate(pose_, map);
  for (Eigen::Index i = 0; i < points_.rows(); ++i) {
    const auto one = localDistortion(all.deformationGradient(i, pose_));
    EXPECT_NEAR(map.rotationalStress[i], one.rotationalStress, 1e-12);
    EXPECT_NEAR(map.stretchMax[i], one.stretchMax, 1e-12);
    EXPECT_NEAR(map.volumeRatio[i], one.volumeRatio, 1e-12);
  }
}

TEST_F(WitnessGradientsTest, TheMapIsTheSameToTheBitForAnyNumberOfThreads) {
  StressMap one, three;
  witnesses().evaluate(pose_, one, {1});
  witnesses().evaluate(pose_, three, {3});
  EXPECT_EQ(one.rotationalStress, three.rotationalStress);
}

TEST_F(WitnessGradientsTest, SeveralPosesAtOnceAreTheSameToTheBit) {
  const auto all = witnesses();
  const std::vector<Points> poses{pose_, handles_.positions, 2 * pose_};
  std::vector<StressMap> maps(poses.size());
  std::vector<StressMap> firstOnes(poses.size());
  constexpr Eigen::Index kFirst = 21;
  all.evaluate(poses, maps, points_.rows(), {2});
  all.evaluate(poses, firstOnes, kFirst);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    StressMap one;
    all.evaluate(poses[i], one);
    EXPECT_EQ(maps[i].rotationalStress, one.rotationalStress);
    EXPECT_EQ(maps[i].volumeRatio, one.volumeRatio);
    EXPECT_EQ(maps[i].folded, one.folded);
    EXPECT_EQ(firstOnes[i].stretchMax, Values(one.stretchMax.head(kFirst)));
  }
}

TEST_F(WitnessGradientsTest, CountsWhatIsFolded) {
  Points mirrored = handles_.positions;
  mirrored.col(0) *= -1;
  StressMap map;
  witnesses().evaluate(mirrored, map);
  EXPECT_EQ(map.folded, 40);
}

TEST_F(WitnessGradientsTest, AreTheSameWhenTheyComeInPortions) {
  WitnessGradients portions(points_.rows(), handles_.positions.rows());
  Progress progress;
  for (const auto& [begin, count] : {std::pair{0, 17}, {17, 23}})
    portions.put(begin, system_->gradients(handles_, points_.middleRows(begin, count), {}, progress), count);
  StressMap whole, inPortions;
  witnesses().evaluate(pose_, whole);
  portions.evaluate(pose_, inPortions);
  EXPECT_EQ(whole.rotationalStress, inPortions.rotationalStress);
  const auto bound = bindWitnesses(*system_, handles_, points_, {}, progress);
  bound->evaluate(pose_, inPortions);
  EXPECT_EQ(whole.stretchMin, inPortions.stretchMin);
  EXPECT_TRUE(bound->closedForm());
}

/// With slow coordinates a portion takes hours.
TEST_F(WitnessGradientsTest, AreCancelledWithinAPortion) {
  const auto systems = coordinates::builtInSystems();
  const auto slow = std::find_if(systems.begin(), systems.end(),
                                 [](const auto& system) { return system->id() == "c-celestial"; });
  ASSERT_NE(slow, systems.end());
  int looks = 0;
  Progress progress({}, [&] {
    if (++looks == 20)
      progress.cancel();
  });
  EXPECT_THROW(bindWitnesses(**slow, handles_, points_, {{}, {1}}, progress), Cancelled);
  EXPECT_LT(looks, 40) << "it goes on after that";
}

TEST_F(WitnessGradientsTest, NameAPointOutsideTheHullWhateverItsPortion) {
  Points many(20'000, 3);
  for (Eigen::Index i = 0; i < many.rows(); ++i)
    many.row(i) = points_.row(i % points_.rows());
  many.row(19'000) << 0, 0, 500;
  Progress progress;
  EXPECT_EQ(bindWitnesses(*system_, handles_, many, {}, progress)->failures(), std::vector<int>{19'000});
  progress.cancel();
  EXPECT_THROW(bindWitnesses(*system_, handles_, many, {}, progress), Cancelled);
}

TEST_F(WitnessGradientsTest, StatisticsOfTheFirstPointsLeaveTheOthersOut) {
  StressMap map;
  map.rotationalStress = Values::LinSpaced(101, 0, 1);
  map.volumeRatio = Values::Ones(101);
  map.volumeRatio.tail(3).setConstant(-1);
  EXPECT_NEAR(statisticsOf(map, 51).max, 0.5, 1e-12);
  EXPECT_EQ(statisticsOf(map, 51).folded, 0);
  EXPECT_EQ(statisticsOf(map, map.rotationalStress.size()).folded, 3);
}

TEST_F(WitnessGradientsTest, StatisticsAreThoseOfTheSortedValues) {
  StressMap map;
  map.rotationalStress = Values::LinSpaced(101, 0, 1);
  map.volumeRatio = Values::Ones(101);
  const auto statistics = statisticsOf(map, map.rotationalStress.size());
  EXPECT_DOUBLE_EQ(statistics.min, 0);
  EXPECT_NEAR(statistics.mean, 0.5, 1e-12);
  EXPECT_NEAR(statistics.percentile95, 0.95, 1e-12);
  EXPECT_DOUBLE_EQ(statistics.max, 1);
}

TEST_F(WitnessGradientsTest, StatisticsLeaveTheAnglesOfFoldedPointsOut) {
  StressMap map;
  map.rotationalStress = Values::LinSpaced(101, 0, 1);
  map.volumeRatio = Values::Ones(101);
  map.volumeRatio.tail(50).setConstant(-1);
  const auto statistics = statisticsOf(map, map.rotationalStress.size());
  EXPECT_EQ(statistics.folded, 50);
  EXPECT_DOUBLE_EQ(statistics.min, 0);
  EXPECT_NEAR(statistics.mean, 0.25, 1e-12);
  EXPECT_NEAR(statistics.percentile95, 0.48, 1e-12);
  EXPECT_NEAR(statistics.max, 0.5, 1e-12);
  map.volumeRatio.setZero();
  const auto none = statisticsOf(map, map.rotationalStress.size());
  EXPECT_EQ(none.folded, 101);
  EXPECT_EQ(none.max, 0) << "there is no angle";
}

TEST_F(WitnessGradientsTest, RefusesAPoseOfAnotherSize) {
  StressMap map;
  EXPECT_THROW(witnesses().evaluate(Points::Zero(3, 3), map), DataError);
}

} // namespace
} // namespace viscera::deformation
