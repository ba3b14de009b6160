#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "clouds.h"
#include "concave_cage.h"
#include "green/cage_normals.h"
#include "green/triangle_potentials.h"
#include "line_measures.h"
#include "shapes.h"

/// What Lipman, Levin and Cohen-Or (2008) say of Green coordinates.
namespace viscera::coordinates {
namespace {

std::unique_ptr<Binding> boundTo(const HandleSet& handles, const Points& points) {
  Progress progress;
  return tests::builtIn("green")->bind(handles, points, {}, progress);
}

TEST(Green, InsideAConcaveCageReproducesEveryPoint) {
  const auto bound = boundTo(tests::concaveCage(), tests::cloud(400, 2, 4, Vec3(50, 6, 6)));
  EXPECT_TRUE(bound->report().failures.empty());
  EXPECT_LT(bound->report().identityError, 1e-12 * 80);
  EXPECT_LT(bound->report().unityError, 1e-13);
}

TEST(Green, OnFacesEdgesAndCornersReproduceThePoint) {
  const HandleSet handles = tests::concaveCage();
  Points points(4, 3);
  points << 80, 0, 0, 40, 0, 0, 20, 30, 0, 0, 33, 33;
  const auto bound = boundTo(handles, points);
  EXPECT_TRUE(bound->report().failures.empty());
  EXPECT_LT(bound->report().identityError, 1e-9);
  EXPECT_LT(bound->report().unityError, 1e-12);
}

TEST(Green, AreContinuousUpToTheCage) {
  const HandleSet handles = tests::concaveCage();
  Points points(3, 3);
  points << 20, 30, 0, 20, 30, 1e-6, 20, 30, 1e-4;
  const auto bound = boundTo(handles, points);
  for (int handle = 0; handle < 8; ++handle) {
    const Values influence = bound->influence(handle);
    EXPECT_NEAR(influence[0], influence[1], 1e-6) << handle;
    EXPECT_NEAR(influence[0], influence[2], 1e-4) << handle;
  }
}

TEST(Green, HaveNoAnswerOutsideAndInADent) {
  Points points(3, 3);
  points << 60, 60, 60, -1, 40, 40, 12, 12, 40;
  EXPECT_EQ(boundTo(tests::concaveCage(), points)->report().failures, (std::vector<int>{0, 1}));
}

TEST(Green, FollowSimilaritiesAndNoShear) {
  const HandleSet handles = tests::concaveCage();
  const Points points = tests::cloud(100, 3, 4, Vec3(50, 6, 6));
  const auto bound = boundTo(handles, points);
  const Eigen::Matrix3d similarity = 1.7 * tests::turn(1.1).transpose();
  const Eigen::RowVector3d shift(5, -60, 8);
  Points moved;
  bound->deform((handles.positions * similarity).rowwise() + shift, moved);
  EXPECT_LT((moved - ((points * similarity).rowwise() + shift)).norm(), 1e-9 * 80);
  Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
  shear(0, 1) = 0.5;
  bound->deform(handles.positions * shear, moved);
  EXPECT_GT((moved - points * shear).rowwise().norm().maxCoeff(), 1);
}

/// The largest quotient of stretches, over points in a box whose top is turned by a right angle.
double worstQuotient(const std::string& id) {
  const auto box = tests::box(80, 80, 80);
  HandleSet handles;
  handles.positions = box.points;
  handles.cage = box.triangles;
  Points pose = handles.positions;
  const Eigen::RowVector3d hinge(40, 40, 80);
  Eigen::Matrix3d turn;
  turn << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  for (const int top : {4, 5, 6, 7})
    pose.row(top) = (pose.row(top) - hinge) * turn + hinge + Eigen::RowVector3d(60, 0, 0);
  const Points points = tests::cloud(100, 4, 25, Vec3::Constant(40));
  Progress progress;
  const auto gradients = tests::builtIn(id)->gradients(handles, points, {}, progress);
  const Points rows = gradients.lift ? gradients.lift->lift(pose) : pose;
  double worst = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Matrix3d m = rows.transpose() * gradients.values.middleRows(i * rows.rows(), rows.rows());
    const Vec3 stretches = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m.transpose() * m).eigenvalues();
    worst = std::max(worst, std::sqrt(stretches.maxCoeff() / stretches.minCoeff()));
  }
  return worst;
}

TEST(Green, StretchLessUnevenlyThanMeanValue) {
  EXPECT_LT(worstQuotient("green"), 0.8 * worstQuotient("mean-value"));
}

/// Both layers against the sum over small triangles.
TEST(TrianglePotentials, AreTheIntegralsOverTheTriangle) {
  const Vec3 a(1, 0.2, 0.8), b(-0.7, 1.1, 1.2), c(-0.4, -1, 0.9);
  const auto found = SeenTriangle(a, b, c).potentials(false, false);
  const Vec3 area = (b - a).cross(c - a);
  constexpr int kParts = 400;
  double face = 0;
  Vec3 corners = Vec3::Zero();
  for (int i = 0; i < kParts; ++i)
    for (int j = 0; j < kParts - i; ++j)
      for (int flip = 0; flip < (j + 1 < kParts - i ? 2 : 1); ++flip) {
        const double third = flip ? 2.0 / 3 : 1.0 / 3;
        const Vec3 shares((kParts - i - j - 2 * third) / kParts, (i + third) / kParts, (j + third) / kParts);
        const Vec3 at = shares[0] * a + shares[1] * b + shares[2] * c;
        const double part = area.norm() / 2 / (kParts * kParts), distance = at.norm();
        face += part / distance;
        corners += shares * part * at.dot(area.normalized()) / std::pow(distance, 3);
      }
  EXPECT_NEAR(found.face, face / (4 * std::numbers::pi), 1e-6);
  EXPECT_LT((found.corners - corners / (4 * std::numbers::pi)).norm(), 1e-6);
}

TEST(CageNormals, AreUnitVectorsAtRestAndFiniteInAnyPose) {
  const HandleSet handles = tests::concaveCage();
  const CageNormals normals(handles.positions, handles.cage);
  const Points rest = normals.lift(handles.positions).bottomRows(12);
  EXPECT_LT((rest.rowwise().norm().array() - 1).abs().maxCoeff(), 1e-14);
  Points flat = handles.positions;
  flat.row(1) = flat.row(0);
  EXPECT_TRUE(normals.lift(flat).allFinite());
  EXPECT_TRUE(normals.lift(Points::Zero(8, 3)).allFinite());
  EXPECT_TRUE(normals.pullBack(flat, Points::Ones(20, 3)).allFinite());
}

} // namespace
} // namespace viscera::coordinates
