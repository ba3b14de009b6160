#include "viscera/sequences/pose_compensation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

constexpr Eigen::Index kHandles = 40;

/// Handles on a line, 1 mm apart, and an average over neighbours that reproduces linear functions inside.
Points lineOfHandles() {
  Points rest = Points::Zero(kHandles, 3);
  for (Eigen::Index i = 0; i < kHandles; ++i)
    rest(i, 0) = static_cast<double>(i);
  return rest;
}

Eigen::MatrixXd averaging() {
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(kHandles, kHandles);
  weights(0, 0) = weights(kHandles - 1, kHandles - 1) = 1;
  for (Eigen::Index i = 1; i + 1 < kHandles; ++i) {
    weights(i, i) = 0.5;
    weights(i, i - 1) = weights(i, i + 1) = 0.25;
  }
  return weights;
}

Points waveOf(const Points& rest, double wavelength) {
  Points pose = rest;
  for (Eigen::Index i = 0; i < rest.rows(); ++i)
    pose(i, 1) += std::sin(2 * M_PI * static_cast<double>(i) / wavelength);
  return pose;
}

TEST(PoseCompensation, withoutHandlesChangesNothing) {
  const Points rest = lineOfHandles();
  Points pose = waveOf(rest, 6);
  const Points before = pose;
  PoseCompensation().apply(rest, pose);
  EXPECT_EQ(pose, before);
}

TEST(PoseCompensation, ofInterpolatingCoordinatesChangesNothing) {
  const Points rest = lineOfHandles();
  Points pose = waveOf(rest, 6);
  const Points before = pose;
  PoseCompensation(Eigen::MatrixXd::Identity(kHandles, kHandles)).apply(rest, pose);
  EXPECT_LT((pose - before).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(PoseCompensation, leavesLinearMotionsAlone) {
  const Points rest = lineOfHandles();
  Points pose = rest;
  pose.col(0) *= 1.3;
  pose.col(2).array() += 4;
  pose.col(1) += 0.2 * rest.col(0);
  const Points before = pose;
  PoseCompensation(averaging()).apply(rest, pose);
  EXPECT_LT((pose - before).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(PoseCompensation, bringsWhatTheOrganDoesCloserToTheMotionWithEveryTerm) {
  const Points rest = lineOfHandles();
  const Points wanted = waveOf(rest, 8);
  const Eigen::MatrixXd weights = averaging();
  double before = 1e9;
  for (const int terms : {0, 1, 2, 4, 8}) {
    Points pose = wanted;
    PoseCompensation(weights, terms).apply(rest, pose);
    const double error = (weights * (pose - rest) - (wanted - rest)).norm();
    EXPECT_LT(error, 0.9 * before) << terms;
    before = error;
  }
}

TEST(PoseCompensation, refusesWhatAreNoCoordinates) {
  EXPECT_THROW(PoseCompensation(Eigen::MatrixXd::Identity(4, 5)), DataError);
  EXPECT_THROW(PoseCompensation(Eigen::MatrixXd::Constant(4, 4, NAN)), DataError);
  EXPECT_THROW(PoseCompensation(2 * Eigen::MatrixXd::Identity(4, 4)), DataError);
}

} // namespace
} // namespace viscera::sequences
