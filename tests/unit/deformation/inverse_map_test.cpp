#include <cmath>

#include <malloc.h>

#include <gtest/gtest.h>

#include "bernstein_system.h"
#include "clouds.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/deformation/inverse_map.h"

namespace viscera::deformation {
namespace {

using tests::analyticInverse;
using tests::bentPose;
using tests::BernsteinSystem;

Points pointsWithin(double low, double high, int count) {
  Points points(count, 3);
  unsigned state = 12345;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    state = state * 1664525U + 1013904223U;
    points.data()[i] = low + (high - low) * double(state >> 8U) / double(1U << 24U);
  }
  return points;
}

TEST(InverseMap, IsTheInverseOfASmoothDeformation) {
  const BernsteinSystem system;
  const auto handles = BernsteinSystem::lattice();
  Progress progress;
  const double bend = 20;
  const InverseMap map(system, handles, bentPose(handles, bend), {}, {.accuracyMm = 0.05}, progress);
  EXPECT_LE(map.errorMm(), 0.05);
  const Points posed = pointsWithin(1, 99, 3000);
  const RestPoints rest = map.restPoints(posed);
  double largest = 0;
  for (Eigen::Index i = 0; i < posed.rows(); ++i) {
    ASSERT_EQ(rest.states[std::size_t(i)], RestState::moved);
    const Vec3 exact(analyticInverse(posed(i, 0), bend), posed(i, 1), posed(i, 2));
    largest = std::max(largest, (rest.points.row(i).transpose() - exact).norm());
  }
  EXPECT_LT(largest, 0.05);
  EXPECT_LT(map.residualMm(system, posed, rest, progress), 0.06);
}

/// Every sample of a plane as points.
Points samplesOf(const SamplePlane& plane) {
  Points points(plane.columns * plane.rows, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = plane.at(i % plane.columns, i / plane.columns).transpose();
  return points;
}

TEST(InverseMap, RefinedIsTheInverseHoweverCoarseItsGrid) {
  const BernsteinSystem system;
  const auto handles = BernsteinSystem::lattice();
  Progress progress;
  const double bend = 20;
  const InverseMap map(system, handles, bentPose(handles, bend), {}, {.mostWeights = 1}, progress);
  ASSERT_GT(map.errorMm(), 0.05);
  const SamplePlane plane{{3, 4, 20}, {0.9, 0.1, 0.05}, {-0.02, 0.8, 0.4}, 101, 103};
  RestPoints rest;
  map.restPlane(plane, rest);
  map.refinePlane(system, plane, {.toleranceMm = 0.001}, rest, progress);
  for (Eigen::Index i = 0; i < rest.points.rows(); ++i) {
    const Vec3 posed = plane.at(i % plane.columns, i / plane.columns);
    const Vec3 exact(analyticInverse(posed.x(), bend), posed.y(), posed.z());
    ASSERT_LT((rest.points.row(i).transpose() - exact).norm(), 0.002) << posed.transpose();
  }
}

TEST(InverseMap, RefinedIsExactBesideDraggedHandles) {
  const auto celestial = coordinates::sCelestial();
  const coordinates::CoordinateSystem& system = *celestial;
  const coordinates::HandleSet handles{tests::onSphere(30, 110), {}, {}};
  Points pose = handles.positions;
  for (int handle = 0; handle < 4; ++handle)
    pose.row(handle) *= 1 + 25.0 / 110;
  Progress progress;
  const InverseMap map(system, handles, pose, {}, {.mostWeights = 6e5}, progress);
  const Vec3 dragged = pose.row(1).transpose();
  const SamplePlane plane{dragged - Vec3(60, 60, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), 121, 121};
  RestPoints rest;
  map.restPlane(plane, rest);
  const Points posed = samplesOf(plane);
  const double before = map.residualMm(system, posed, rest, progress);
  EXPECT_GT(before, 0.2) << "of the grid alone";
  RestPoints some = rest;
  map.refinePlane(system, plane, {.toleranceMm = 0.02, .mostPoints = 200}, some, progress);
  Eigen::Index changed = 0;
  for (Eigen::Index i = 0; i < posed.rows(); ++i)
    changed += rest.points.row(i) != some.points.row(i) ? 1 : 0;
  EXPECT_GT(changed, 0);
  EXPECT_LE(changed, 200);
  map.refinePlane(system, plane, {.toleranceMm = 0.02}, rest, progress);
  EXPECT_LT(map.residualMm(system, posed, rest, progress), 0.04);
}

TEST(InverseMap, RefinedDoesNotTearWhereTheHullEnds) {
  const auto celestial = coordinates::sCelestial();
  const coordinates::CoordinateSystem& system = *celestial;
  const coordinates::HandleSet handles{tests::onSphere(30, 110), {}, {}};
  Points pose = handles.positions;
  pose.row(0) *= 1 + 25.0 / 110;
  Progress progress;
  const InverseMap map(system, handles, pose, {}, {.mostWeights = 3e5}, progress);
  const Vec3 way = Vec3(pose.row(0).transpose()).normalized();
  constexpr double kStep = 0.05;
  const SamplePlane line{80 * way, kStep * way, way.unitOrthogonal(), 2000, 1};
  RestPoints rest;
  map.restPlane(line, rest);
  map.refinePlane(system, line, {}, rest, progress);
  for (Eigen::Index i = 1; i < line.columns; ++i) {
    const Vec3 step = (rest.points.row(i) - rest.points.row(i - 1)).transpose();
    ASSERT_GT(step.dot(way), 0) << i;
    ASSERT_LT(step.norm(), 5 * kStep) << i;
  }
}

TEST(InverseMap, IsExactForAnAffinePoseAndItsReverseUndoesIt) {
  Points corners(8, 3);
  for (int c = 0; c < 8; ++c)
    corners.row(c) << (c & 1 ? 60 : -60), (c & 2 ? 50 : -50), (c & 4 ? 70 : -70);
  const coordinates::HandleSet handles{corners, {}, {}};
  Eigen::Affine3d affine = Eigen::Affine3d::Identity();
  affine.linear() << 1.1, 0.1, 0, -0.2, 0.9, 0.1, 0, 0.1, 1.05;
  affine.translation() << 3, -4, 5;
  Points pose(8, 3);
  for (int c = 0; c < 8; ++c)
    pose.row(c) = (affine * Vec3(corners.row(c).transpose())).transpose();
  Progress progress;
  const auto celestial = coordinates::sCelestial();
  const coordinates::CoordinateSystem& system = *celestial;
  const InverseMap map(system, handles, pose, {}, {.accuracyMm = 0.01}, progress);
  const Points posed = pointsWithin(-30, 30, 2000);
  const RestPoints rest = map.restPoints(posed);
  const InverseMap back(system, {pose, {}, {}}, corners, {}, {.accuracyMm = 0.01}, progress);
  const RestPoints again = back.restPoints(rest.points);
  for (Eigen::Index i = 0; i < posed.rows(); ++i) {
    const Vec3 exact = affine.inverse() * Vec3(posed.row(i).transpose());
    ASSERT_LT((rest.points.row(i).transpose() - exact).norm(), 0.01);
    ASSERT_LT((again.points.row(i) - posed.row(i)).norm(), 0.02);
  }
}

/// Only affine motions are undone by the reverse of a pose: of others the posed handles have other
/// coordinates than those at rest. The user guide says how much that is.
TEST(InverseMap, ReverseOfASmoothPoseComesBackToAFewTenthsOfAMillimetre) {
  const auto celestial = coordinates::sCelestial();
  const coordinates::CoordinateSystem& system = *celestial;
  const Points rest = tests::onSphere(30, 110), inside = pointsWithin(-45, 45, 1000);
  Progress progress;
  const auto meanReturn = [&](const Points& pose) {
    const InverseMap there(system, {rest, {}, {}}, pose, {}, {}, progress);
    const InverseMap back(system, {pose, {}, {}}, rest, {}, {}, progress);
    return (back.posedPoints(there.posedPoints(inside)) - inside).rowwise().norm().mean();
  };
  Points breathing = rest, twisted = rest;
  for (Eigen::Index i = 0; i < rest.rows(); ++i) {
    breathing(i, 2) += 10 * (1 - rest(i, 0) * rest(i, 0) / (110 * 110));
    const Eigen::AngleAxisd turn(0.3 * rest(i, 2) / 110, Vec3::UnitZ());
    twisted.row(i) = (turn * Vec3(rest.row(i).transpose())).transpose();
  }
  EXPECT_LT(meanReturn(breathing), 0.1);
  EXPECT_LT(meanReturn(twisted), 0.8);
  EXPECT_GT(meanReturn(twisted), 0.05) << "else the user guide says too much";
}

TEST(InverseMap, OfAPlaneIsThatOfItsPoints) {
  const BernsteinSystem system;
  const auto handles = BernsteinSystem::lattice();
  Progress progress;
  const InverseMap map(system, handles, bentPose(handles, 25), {}, {.accuracyMm = 0.05}, progress);
  const SamplePlane plane{{-80, -60, 40}, {0.9, 0.1, 0.05}, {-0.1, 0.8, 0.1}, 259, 241};
  RestPoints all;
  map.restPlane(plane, all);
  const RestPoints single = map.restPoints(samplesOf(plane));
  double largest = 0;
  std::size_t moved = 0, differ = 0;
  for (std::size_t i = 0; i < all.states.size(); ++i) {
    largest =
        std::max(largest, (all.points.row(Eigen::Index(i)) - single.points.row(Eigen::Index(i))).norm());
    moved += all.states[i] == RestState::moved ? 1U : 0U;
    differ += all.states[i] != single.states[i] ? 1U : 0U;
  }
  EXPECT_LT(largest, 0.05) << "the accuracy that was asked for";
  EXPECT_GT(moved, all.states.size() / 4);
  EXPECT_LT(moved, all.states.size());
  EXPECT_LE(differ, all.states.size() / 100) << "only in cells on the border of what moves";
  RestPoints other;
  map.restPlane(plane, other);
  EXPECT_EQ(all.points, other.points);
}

TEST(InverseMap, DoesNotTearOutsideOfTheHullAndLeavesWhatIsFarAlone) {
  const BernsteinSystem system;
  const auto handles = BernsteinSystem::lattice();
  Points pose = handles.positions;
  pose.col(1).array() += 15; // All handles: the border of the hull moves as much as its middle.
  Progress progress;
  const InverseMap map(system, handles, pose, {}, {}, progress);
  const int count = 2000;
  Points line(count, 3);
  for (int i = 0; i < count; ++i)
    line.row(i) << 50, -150 + 0.2 * i, 50;
  const RestPoints rest = map.restPoints(line);
  for (int i = 1; i < count; ++i) {
    const double step = rest.points(i, 1) - rest.points(i - 1, 1);
    ASSERT_GT(step, 0) << "at " << line(i, 1);
    ASSERT_LT(step, 0.2 * 2.5) << "at " << line(i, 1);
    ASSERT_EQ(rest.states[std::size_t(i)] == RestState::folded, false);
  }
  EXPECT_EQ(rest.points(0, 1), line(0, 1));
  EXPECT_EQ(rest.states[0], RestState::still);
  EXPECT_NEAR(rest.points(count / 2 + 100, 1), line(count / 2 + 100, 1) - 15, 1e-6) << "in the hull";
}

/// Megabytes that malloc and new have given and not taken back; 0 where a sanitiser replaces them.
double allocatedMb() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd) / (1 << 20);
}

TEST(InverseMap, OfAHandleDraggedFarAwayTakesNoMoreMemoryAndStaysContinuous) {
  const auto celestial = coordinates::sCelestial();
  const coordinates::CoordinateSystem& system = *celestial;
  const coordinates::HandleSet handles{tests::onSphere(30, 110), {}, {}};
  Progress progress;
  const double diameter = 220;
  for (const double diameters : {0.5, 3.0, 1e9}) {
    Points pose = handles.positions;
    pose(7, 0) += diameters * diameter;
    const double before = allocatedMb();
    const InverseMap map(system, handles, pose, {}, {.mostWeights = 3e5}, progress);
    EXPECT_LT(allocatedMb() - before, 80) << diameters;

    // Along a ray from the middle to where nothing moves.
    const Vec3 way = Vec3(0.3, 0.8, -0.5).normalized();
    const double end = 15 * diameters * diameter + 400;
    Points ray(4001, 3);
    for (Eigen::Index i = 0; i < ray.rows(); ++i)
      ray.row(i) = (end * double(i) / double(ray.rows() - 1) * way).transpose();
    const Points moved = map.posedPoints(ray) - ray;
    EXPECT_TRUE(moved.allFinite());
    EXPECT_GT(moved.row(0).norm(), 0.01 * diameters * diameter);
    EXPECT_EQ(moved.row(ray.rows() - 1).norm(), 0);
    if (end / double(ray.rows()) > 0.1 * diameter)
      continue; // Steps as large as the hull say nothing of jumps.
    const double largest = moved.rowwise().norm().maxCoeff();
    for (Eigen::Index i = 1; i < ray.rows(); ++i)
      ASSERT_LT((moved.row(i) - moved.row(i - 1)).norm(), 0.1 * largest) << diameters << ", sample " << i;
  }
}

TEST(InverseMap, MarksFoldedTissue) {
  const BernsteinSystem system;
  const auto handles = BernsteinSystem::lattice();
  Progress progress;
  // y = 300 t - 200 t t turns back at t = 0.75: what lies beyond comes to 100 to 112.5 mm, where other tissue
  // is as well.
  const InverseMap map(system, handles, bentPose(handles, 100), {}, {}, progress);
  Points posed = pointsWithin(30, 70, 4000);
  for (Eigen::Index i = 0; i < posed.rows(); ++i)
    posed(i, 0) = 1 + 159.0 * double(i) / double(posed.rows());
  const RestPoints rest = map.restPoints(posed);
  std::size_t folded = 0;
  for (Eigen::Index i = 0; i < posed.rows(); ++i) {
    EXPECT_TRUE(rest.points.row(i).allFinite());
    const bool marked = rest.states[std::size_t(i)] == RestState::folded;
    if (posed(i, 0) > 103 && posed(i, 0) < 109) {
      EXPECT_TRUE(marked) << posed(i, 0);
    } else if (posed(i, 0) < 80 || posed(i, 0) > 130) {
      EXPECT_FALSE(marked) << posed(i, 0);
    }
    folded += marked ? 1U : 0U;
  }
  EXPECT_GT(folded, 0U);
  EXPECT_NEAR(map.foldedMl(), 250, 60) << "a quarter of the cube, to cells of the grid";
}

TEST(InverseMap, DoesNotDependOnThreads) {
  const BernsteinSystem system;
  const auto handles = BernsteinSystem::lattice();
  Progress progress;
  coordinates::BindOptions one, two;
  one.threads.count = 1;
  two.threads.count = 2;
  const InverseMap a(system, handles, bentPose(handles, 20), one, {}, progress);
  const InverseMap b(system, handles, bentPose(handles, 20), two, {}, progress);
  const SamplePlane plane{{-20, -20, 30}, {0.7, 0, 0.1}, {0, 0.7, 0.1}, 200, 200};
  RestPoints x, y;
  a.restPlane(plane, x);
  b.restPlane(plane, y);
  EXPECT_EQ(x.points, y.points);
  EXPECT_EQ(x.states, y.states);
}

TEST(InverseMap, RefusesAPoseOfAnotherSize) {
  const BernsteinSystem system;
  const auto handles = BernsteinSystem::lattice();
  Progress progress;
  InverseMap map(system, handles, handles.positions, {}, {}, progress);
  EXPECT_THROW(map.setPose(Points::Zero(3, 3)), DataError);
  Points broken = handles.positions;
  broken(0, 0) = std::nan("");
  EXPECT_THROW(map.setPose(broken), DataError);
  const Points points = pointsWithin(-50, 150, 100);
  EXPECT_EQ(map.restPoints(points).points, points) << "at rest everything is where it is";
}

} // namespace
} // namespace viscera::deformation
