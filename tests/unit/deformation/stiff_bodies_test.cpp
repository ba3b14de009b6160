#include "viscera/deformation/stiff_bodies.h"

#include <cmath>

#include <gtest/gtest.h>

#include "bernstein_system.h"
#include "shapes.h"
#include "viscera/core/error.h"

namespace viscera::deformation {
namespace {

using tests::bentPose;
using tests::BernsteinSystem;

/// A space that bends along x, and balls in it that do not.
struct BentSpace {
  explicit BentSpace(double bendIn = 25) : bend(bendIn) {}

  double bend; ///< mm.
  BernsteinSystem system;
  coordinates::HandleSet handles = BernsteinSystem::lattice();
  Progress progress;
  InverseMap map{system, handles, bentPose(handles, bend), {}, {.accuracyMm = 0.05}, progress};

  using Mesh = std::shared_ptr<const geometry::TriangleMesh>;
  static Mesh ball(const Vec3& middle, double radius = 8) {
    return std::make_shared<const geometry::TriangleMesh>(tests::sphere(3, radius, middle));
  }
  static Points moved(const geometry::TriangleMesh& mesh, const Eigen::Isometry3d& motion) {
    return (mesh.points * motion.linear().transpose()).rowwise() + motion.translation().transpose();
  }
  /// A turn about the middle and a shift, near to what the tissue does.
  Eigen::Isometry3d motionOf(const Vec3& middle, double angle) const {
    const Vec3 there = map.posedPoints(middle.transpose()).row(0).transpose();
    return Eigen::Translation3d(there) * Eigen::AngleAxisd(angle, Vec3(1, 2, 2) / 3) *
           Eigen::Translation3d(-middle);
  }
};

TEST(StiffBodies, MoveAsAWholeInsideAndLeaveFarTissueAlone) {
  BentSpace space;
  const Vec3 middle(30, 50, 50);
  const auto mesh = BentSpace::ball(middle);
  StiffBodies bodies({mesh}, {}, space.progress);
  const Eigen::Isometry3d motion = space.motionOf(middle, 0.3);
  const Points posed = BentSpace::moved(*mesh, motion);
  bodies.setPose({&posed}, space.map);
  const SamplePlane plane{{0, 0, posed.col(2).mean()}, {0.5, 0, 0}, {0, 0.5, 0}, 200, 200};
  RestPoints soft, rest;
  space.map.restPlane(plane, soft);
  rest = soft;
  bodies.stiffen(plane, rest);
  Eigen::Index inside = 0, changed = 0;
  for (Eigen::Index i = 0; i < rest.points.rows(); ++i) {
    const Vec3 place = plane.at(i % plane.columns, i / plane.columns);
    const Vec3 own = motion.inverse() * place;
    const double away = (own - middle).norm();
    if (away < 8) {
      ++inside;
      ASSERT_LT((rest.points.row(i).transpose() - own).norm(), 1e-9) << place.transpose();
      ASSERT_EQ(rest.states[std::size_t(i)], RestState::moved);
    } else if (away > 18) {
      ASSERT_EQ(rest.points.row(i), soft.points.row(i)) << place.transpose();
    } else {
      changed += rest.points.row(i) != soft.points.row(i) ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 500);
  EXPECT_GT(changed, 100) << "the tissue around gives way";
}

TEST(StiffBodies, TearNoTissueAtTheirSurface) {
  BentSpace space;
  const Vec3 middle(60, 50, 50);
  const auto mesh = BentSpace::ball(middle, 10);
  StiffBodies bodies({mesh}, {}, space.progress);
  const Points posed = BentSpace::moved(*mesh, space.motionOf(middle, 0));
  bodies.setPose({&posed}, space.map);
  const Vec3 there = posed.colwise().mean().transpose();
  constexpr double kStep = 0.1;
  for (const Vec3& way : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0.6, 0, 0.8)}) {
    Vec3 last = bodies.restOf(space.map, there);
    for (int step = 1; step < 250; ++step) {
      const Vec3 next = bodies.restOf(space.map, there + step * kStep * way);
      ASSERT_GT((next - last).dot(way), 0) << "it does not fold, step " << step;
      ASSERT_LT((next - last).norm(), 4 * kStep) << step;
      last = next;
    }
  }
}

TEST(StiffBodies, FindWhereARestPlaceIsPosedInBodiesAroundAndBetweenThem) {
  BentSpace space(8);
  const Vec3 first(35, 50, 50), second(62, 48, 52);
  const auto one = BentSpace::ball(first), other = BentSpace::ball(second);
  StiffBodies bodies({one, other}, {}, space.progress);
  const Eigen::Isometry3d motion = space.motionOf(first, 0.15);
  const Points posed = BentSpace::moved(*one, motion);
  bodies.setPose({&posed, &other->points}, space.map);
  EXPECT_LT((bodies.posedOf(space.map, first + Vec3(3, 2, 1)) - motion * (first + Vec3(3, 2, 1))).norm(),
            0.02);
  EXPECT_LT((bodies.posedOf(space.map, second) - second).norm(), 0.02) << "it stays in place";
  for (double part = 0; part <= 1; part += 0.05) {
    const Vec3 rest = first + part * (second - first);
    const Vec3 there = bodies.posedOf(space.map, rest);
    EXPECT_LT((bodies.restOf(space.map, there) - rest).norm(), 0.05) << part;
  }
}

TEST(StiffBodies, AreNoneWithoutOrgansAndAreNotMadeWhenCancelled) {
  BentSpace space;
  StiffBodies none({}, {}, space.progress);
  EXPECT_TRUE(none.empty());
  none.setPose({}, space.map);
  const SamplePlane plane{{20, 20, 50}, {2, 0, 0}, {0, 2, 0}, 20, 20};
  RestPoints soft, rest;
  space.map.restPlane(plane, soft);
  rest = soft;
  none.stiffen(plane, rest);
  EXPECT_EQ(rest.points, soft.points);
  EXPECT_EQ(none.restOf(space.map, Vec3(50, 40, 30)),
            Vec3(space.map.restPoints(Vec3(50, 40, 30).transpose()).points.row(0).transpose()));
  space.progress.cancel();
  EXPECT_THROW(StiffBodies({BentSpace::ball(Vec3(50, 50, 50))}, {}, space.progress), Cancelled);
}

} // namespace
} // namespace viscera::deformation
