#include <cmath>

#include <gtest/gtest.h>

#include "viscera/coordinates/celestial/s_celestial.h"
#include "viscera/core/error.h"
#include "viscera/deformation/inverse_map.h"

namespace viscera::deformation {
namespace {

constexpr double kSide = 100;

/// Weights by Bernstein's polynomials of degree 2 on the cube [0, 100]^3: a deformation that is known at
/// every point, and whose inverse is.
class BernsteinSystem final : public coordinates::DescribedSystem {
public:
  BernsteinSystem() : DescribedSystem({"bernstein", "Bernstein", "of a test"}) {}

  static coordinates::HandleSet lattice() {
    coordinates::HandleSet handles;
    handles.positions.resize(27, 3);
    for (int n = 0; n < 27; ++n)
      handles.positions.row(n) << kSide / 2 * (n % 3), kSide / 2 * (n / 3 % 3), kSide / 2 * (n / 9);
    return handles;
  }

  std::unique_ptr<coordinates::Binding> bind(const coordinates::HandleSet&, const Points& points,
                                             const coordinates::BindOptions&, Progress&) const override {
    return std::make_unique<Bound>(points);
  }

private:
  class Bound final : public coordinates::Binding {
  public:
    explicit Bound(const Points& points) : weights_(points.rows(), 27) {
      for (Eigen::Index p = 0; p < points.rows(); ++p)
        for (int n = 0; n < 27; ++n)
          weights_(p, n) =
              basis(n % 3, points(p, 0)) * basis(n / 3 % 3, points(p, 1)) * basis(n / 9, points(p, 2));
    }
    Eigen::Index handleCount() const override { return 27; }
    Eigen::Index pointCount() const override { return weights_.rows(); }
    const coordinates::BindingReport& report() const override { return report_; }
    void deform(const Points& pose, Points& points, Threads) const override { points = weights_ * pose; }
    void moveHandle(const Points&, int, const Vec3&, Points&, Threads) const override {}
    void pullBack(const Points&, const Points&, Points&, Threads) const override {}
    Values influence(int handle) const override { return weights_.col(handle); }

  private:
    static double basis(int i, double x) {
      const double t = x / kSide;
      return i == 0 ? (1 - t) * (1 - t) : i == 1 ? 2 * t * (1 - t) : t * t;
    }
    Eigen::MatrixXd weights_;
    coordinates::BindingReport report_;
  };
};

/// y = x + bend * 2 t (1 - t) along x, with t = x / 100, bends along x; z and y shear by its middle column.
Points bentPose(const coordinates::HandleSet& handles, double bend) {
  Points pose = handles.positions;
  for (int n = 0; n < 27; ++n)
    if (n % 3 == 1)
      pose(n, 0) += bend;
  return pose;
}

/// The x whose image is y: the root of x + 2 bend t (1 - t) = y in [0, 100].
double analyticInverse(double y, double bend) {
  const double a = -2 * bend / kSide / kSide, b = 1 + 2 * bend / kSide;
  return (-b + std::sqrt(b * b + 4 * a * y)) / (2 * a);
}

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
  const coordinates::SCelestial system;
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

TEST(InverseMap, OfAPlaneIsThatOfItsPoints) {
  const BernsteinSystem system;
  const auto handles = BernsteinSystem::lattice();
  Progress progress;
  const InverseMap map(system, handles, bentPose(handles, 25), {}, {.accuracyMm = 0.05}, progress);
  const SamplePlane plane{{-80, -60, 40}, {0.9, 0.1, 0.05}, {-0.1, 0.8, 0.1}, 259, 241};
  RestPoints all;
  map.restPlane(plane, all);
  Points posed(plane.columns * plane.rows, 3);
  for (Eigen::Index r = 0; r < plane.rows; ++r)
    for (Eigen::Index c = 0; c < plane.columns; ++c)
      posed.row(r * plane.columns + c) =
          (plane.corner + double(c) * plane.columnStep + double(r) * plane.rowStep).transpose();
  const RestPoints single = map.restPoints(posed);
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
