#include "viscera/geometry/median_tree.h"

#include <algorithm>
#include <limits>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace viscera::geometry {
namespace {

constexpr int kLeafSize = 4;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Points of a grid, so that many are equally far from a place.
class MedianTreeOfPoints : public testing::TestWithParam<int> {
protected:
  void SetUp() override {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> coordinate(-4, 4);
    points_.resize(GetParam(), 3);
    for (double& value : points_.reshaped())
      value = coordinate(random);
    tree_ = MedianTree<Bounds>(
        GetParam(), kLeafSize,
        [this](std::span<const int> items, Vec3& sides) {
          Bounds box{points_.row(items.front()), points_.row(items.front())};
          for (const int item : items) {
            const Vec3 point = points_.row(item);
            box = {box.low.cwiseMin(point), box.high.cwiseMax(point)};
          }
          sides = box.high - box.low;
          return box;
        },
        [this](int a, int b, Eigen::Index axis) {
          return std::pair(points_(a, axis), a) < std::pair(points_(b, axis), b);
        });
  }

  double distance2(int item, const Vec3& place) const {
    return (Vec3(points_.row(item)) - place).squaredNorm();
  }

  Points points_;
  MedianTree<Bounds> tree_;
};

TEST_P(MedianTreeOfPoints, HasEveryItemInOneLeaf) {
  std::vector<int> items = tree_.order();
  std::sort(items.begin(), items.end());
  for (int item = 0; item < GetParam(); ++item)
    EXPECT_EQ(items[static_cast<std::size_t>(item)], item);
  int last = 0;
  tree_.walk([](const Bounds&) { return true; },
             [&last](int begin, int end) {
               EXPECT_EQ(begin, last) << "leaves follow each other";
               EXPECT_LE(end - begin, kLeafSize);
               EXPECT_GT(end, begin);
               last = end;
             });
  EXPECT_EQ(last, GetParam());
}

TEST_P(MedianTreeOfPoints, KnowsABoxThatHoldsTheItemsOfEachBranch) {
  Bounds box{Vec3::Zero(), Vec3::Zero()};
  tree_.walk(
      [&box](const Bounds& entered) {
        box = entered;
        return true;
      },
      [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
          const Vec3 point = points_.row(tree_.order()[static_cast<std::size_t>(i)]);
          EXPECT_TRUE((point.array() >= box.low.array()).all() && (point.array() <= box.high.array()).all());
        }
      });
}

TEST_P(MedianTreeOfPoints, FindsTheNearestDistanceOfAllAndLooksAtFew) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-6, 6);
  int looked = 0;
  constexpr int kQueries = 50;
  for (int query = 0; query < kQueries; ++query) {
    const Vec3 place(coordinate(random), coordinate(random), coordinate(random));
    double best2 = kInfinite;
    tree_.searchNearestFirst(
        [&place](const Bounds& box) {
          return (box.low - place).cwiseMax(place - box.high).cwiseMax(0).squaredNorm();
        },
        [&best2](const Bounds&, double distance2) { return distance2 >= best2; },
        [&](int begin, int end) {
          for (int i = begin; i < end; ++i, ++looked)
            best2 = std::min(best2, distance2(tree_.order()[static_cast<std::size_t>(i)], place));
        });
    double wanted = kInfinite;
    for (int item = 0; item < GetParam(); ++item)
      wanted = std::min(wanted, distance2(item, place));
    EXPECT_EQ(best2, wanted);
  }
  if (GetParam() >= 1000) {
    EXPECT_LT(looked, kQueries * GetParam() / 10);
  }
}

TEST_P(MedianTreeOfPoints, DoesNotGoIntoBranchesThatAreNotWanted) {
  int leaves = 0, entered = 0;
  tree_.walk(
      [&entered](const Bounds&) {
        ++entered;
        return false;
      },
      [&leaves](int, int) { ++leaves; });
  EXPECT_EQ(leaves, 0);
  EXPECT_EQ(entered, GetParam() > 0 ? 1 : 0);
}

INSTANTIATE_TEST_SUITE_P(Sizes, MedianTreeOfPoints, testing::Values(0, 1, 4, 5, 100, 2000));

} // namespace
} // namespace viscera::geometry
