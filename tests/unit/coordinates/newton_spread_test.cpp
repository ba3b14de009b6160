#include "viscera/coordinates/measure/newton_spread.h"

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "clouds.h"
#include "viscera/coordinates/measure/line_profile.h"
#include "viscera/core/error.h"

namespace viscera::coordinates {
namespace {

NewtonSpread spread(double radius, NeighbourOrder order, int mostIterations = 10) {
  NewtonSpreadOptions options;
  options.radius = radius;
  options.mostIterations = mostIterations;
  Progress progress;
  return spreadNewton(tests::onSphere(20, 50), tests::cloud(300, 5, 22), order, options, progress);
}

Eigen::Index solved(const NewtonSpread& found) {
  return std::accumulate(found.solvedBy.begin(), found.solvedBy.end(), Eigen::Index(0));
}

TEST(NewtonSpread, SolvesEveryPointOnceFromItsNeighbours) {
  for (const auto order : {NeighbourOrder::euclidean, NeighbourOrder::jacobian}) {
    const NewtonSpread found = spread(15, order);
    EXPECT_EQ(found.seeds, 1);
    EXPECT_EQ(found.unsolved, 0);
    EXPECT_EQ(solved(found), 299);
    EXPECT_GT(found.shareByFirst(), 0.9);
    EXPECT_GT(found.meanIterations, 1);
    EXPECT_LT(found.meanIterations, 10);
  }
}

TEST(NewtonSpread, WithoutNeighboursEveryPointIsASeed) {
  const NewtonSpread found = spread(1e-9, NeighbourOrder::euclidean);
  EXPECT_EQ(found.seeds + found.unsolved, 300);
  EXPECT_GT(found.seeds, 250);
  EXPECT_EQ(solved(found), 0);
  EXPECT_EQ(found.shareByFirst(), 0);
}

TEST(NewtonSpread, TriesMoreNeighboursWhereFewIterationsAreAllowed) {
  const NewtonSpread hurried = spread(15, NeighbourOrder::euclidean, 2);
  EXPECT_LT(hurried.shareByFirst() * static_cast<double>(solved(hurried)), 299);
  EXPECT_LE(hurried.meanIterations, 2);
}

TEST(NewtonSpread, CanBeCancelled) {
  Progress progress;
  progress.cancel();
  NewtonSpreadOptions options;
  options.radius = 15;
  EXPECT_THROW(spreadNewton(tests::onSphere(20, 50), tests::cloud(300, 5, 22), NeighbourOrder::euclidean,
                            options, progress),
               Cancelled);
}

TEST(Roughness, IsZeroOfALineAndPassesOverGaps) {
  Eigen::MatrixXd values(6, 1);
  values << 0, 1, 2, 3, 4, 5;
  EXPECT_EQ(roughness(values), 0);
  values(5, 0) = 7; // One second difference of 2 among four.
  EXPECT_DOUBLE_EQ(roughness(values), 1);
  values(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_DOUBLE_EQ(roughness(values), std::sqrt(4.0 / 3));
  values.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(std::isnan(roughness(values)));
}

TEST(NearHalfShare, IsOneWhereOnlyTheNearestCountsAndOneHalfWhereAllDo) {
  Points handles(4, 3), point(1, 3);
  handles << 1, 0, 0, 0, 2, 0, 0, 0, 3, -4, 0, 0;
  point << 0, 0, 0;
  Eigen::MatrixXd coordinates(1, 4);
  coordinates << 1, 0, 0, 0;
  EXPECT_EQ(nearHalfShare(handles, point, coordinates), 1);
  coordinates << 0.25, 0.25, 0.25, 0.25;
  EXPECT_EQ(nearHalfShare(handles, point, coordinates), 0.5);
  coordinates << 0, 0, 0.5, -0.5;
  EXPECT_EQ(nearHalfShare(handles, point, coordinates), 0);
  EXPECT_EQ(nearHalfShare(handles, point, Eigen::MatrixXd::Zero(1, 4)), 0);
}

} // namespace
} // namespace viscera::coordinates
