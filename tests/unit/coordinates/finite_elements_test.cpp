#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "clouds.h"
#include "tetrahedra.h"
#include "tetrahedra/finite_elements.h"
#include "tetrahedra/simplex_program.h"
#include "tetrahedra/tetrahedra_field.h"

/// The elements below harmonic coordinates and bounded biharmonic weights.
namespace viscera::coordinates {
namespace {

SolidMesh boxMesh(int n, double half) {
  const tests::Solid solid = tests::solidBox(n, half);
  return {solid.points, solid.tetrahedra};
}

std::vector<Eigen::Index> onBoundary(const SolidMesh& mesh, double half) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
    if (mesh.points.row(i).cwiseAbs().maxCoeff() > half * (1 - 1e-9))
      rows.push_back(i);
  return rows;
}

/// Harmonic, and no polynomial.
double wave(const Vec3& p) {
  return std::exp(p[0]) * std::sin(p[1]) + p[2] * p[0];
}

/// The largest error at random points of the solution with the wave's values on the boundary.
double errorOnMesh(int n) {
  const SolidMesh mesh = boxMesh(n, 1);
  const auto fixed = onBoundary(mesh, 1);
  Eigen::MatrixXd given(static_cast<Eigen::Index>(fixed.size()), 1);
  for (std::size_t i = 0; i < fixed.size(); ++i)
    given(static_cast<Eigen::Index>(i), 0) = wave(mesh.points.row(fixed[i]).transpose());
  Progress progress;
  const TetrahedraField field(mesh, leastEnergy(stiffness(mesh), fixed, given, {}, progress));
  const Points points = tests::cloud(500, 3, 0.95);
  double worst = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Vec3 point = points.row(i).transpose();
    Values value = Values::Zero(1);
    field.addValues(field.locate(point).value(), value);
    worst = std::max(worst, std::abs(value[0] - wave(point)));
  }
  return worst;
}

TEST(FiniteElements, ApproachAHarmonicFunctionWithTheSquareOfTheirSize) {
  const double coarse = errorOnMesh(4), middle = errorOnMesh(8), fine = errorOnMesh(16);
  EXPECT_GT(std::log2(coarse / middle), 1.7);
  EXPECT_GT(std::log2(middle / fine), 1.7);
  EXPECT_LT(fine, 2e-2);
}

TEST(FiniteElements, ReproduceLinearFunctionsAndTheirGradients) {
  const SolidMesh mesh = boxMesh(5, 1);
  const auto fixed = onBoundary(mesh, 1);
  Eigen::MatrixXd given(static_cast<Eigen::Index>(fixed.size()), 3);
  for (std::size_t i = 0; i < fixed.size(); ++i)
    given.row(static_cast<Eigen::Index>(i)) = mesh.points.row(fixed[i]);
  Progress progress;
  const TetrahedraField field(mesh, leastEnergy(stiffness(mesh), fixed, given, {}, progress));
  const Vec3 point(0.31, -0.47, 0.12);
  const auto place = field.locate(point).value();
  Values values = Values::Zero(3);
  Points gradients = Points::Zero(3, 3);
  field.addValues(place, values);
  field.addGradients(place, gradients);
  EXPECT_LT((values - point).norm(), 1e-13);
  EXPECT_LT((gradients - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_FALSE(field.locate(Vec3(0, 0, 1.001)).has_value());
}

TEST(FiniteElements, MassIsTheVolume) {
  EXPECT_NEAR(lumpedMass(boxMesh(3, 2)).sum(), 64, 1e-12);
}

TEST(SimplexProgram, ProjectsOnTheNearestWeights) {
  Eigen::RowVectorXd inside(3), outside(3), corner(3);
  inside << 0.2, 0.3, 0.5;
  projectOnSimplex(inside);
  EXPECT_LT((inside - Eigen::RowVector3d(0.2, 0.3, 0.5)).norm(), 1e-15);
  outside << 0.7, 0.7, -0.5;
  projectOnSimplex(outside);
  EXPECT_LT((outside - Eigen::RowVector3d(0.5, 0.5, 0)).norm(), 1e-15);
  corner << 9, 1, 0;
  projectOnSimplex(corner);
  EXPECT_EQ(corner, Eigen::RowVector3d(1, 0, 0));
}

/// The biharmonic programme of six handles in a box.
SimplexProgram boxProgram(const SolidMesh& mesh) {
  SimplexProgram program;
  program.mass = lumpedMass(mesh);
  const SparseMatrix laplacian = stiffness(mesh);
  program.energy = laplacian.transpose() * program.mass.cwiseInverse().asDiagonal() * laplacian;
  const Eigen::Index count = mesh.points.rows();
  program.fixed = {0, 8, count / 3, count / 2, 2 * count / 3, count - 1};
  return program;
}

double energyOf(const SimplexProgram& program, const Eigen::MatrixXd& weights) {
  return (weights.transpose() * (program.energy * weights)).trace() / 2;
}

TEST(SimplexProgram, NoOtherWeightsWithinTheBoundsHaveLessEnergy) {
  const SolidMesh mesh = boxMesh(8, 0.3);
  const SimplexProgram program = boxProgram(mesh);
  Progress progress;
  const SimplexSolution solution = solveOnSimplex(program, {4000, 1e-7}, {}, progress);
  ASSERT_TRUE(solution.converged) << solution.primal << " " << solution.dual;
  EXPECT_GE(solution.weights.minCoeff(), 0);
  EXPECT_LT((solution.weights.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-12);
  const double least = energyOf(program, solution.weights);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 50; ++trial) {
    // A hat on one free point, mixed from random weights.
    Eigen::MatrixXd other = solution.weights;
    const auto row = static_cast<Eigen::Index>(unit(random) * static_cast<double>(other.rows() - 1));
    if (std::find(program.fixed.begin(), program.fixed.end(), row) != program.fixed.end())
      continue;
    Eigen::RowVectorXd moved =
        other.row(row) + 0.01 * Eigen::RowVectorXd::NullaryExpr(6, [&] { return unit(random) - 0.5; });
    projectOnSimplex(moved);
    other.row(row) = moved;
    EXPECT_GT(energyOf(program, other), least * (1 - 1e-9)) << trial;
  }
  // The unbounded weights have less energy and break the bounds: these bounds cost something.
  const Eigen::MatrixXd unbounded =
      leastEnergy(program.energy, program.fixed, Eigen::MatrixXd::Identity(6, 6), {}, progress);
  EXPECT_LT(unbounded.minCoeff(), -1e-3);
  EXPECT_LT(energyOf(program, unbounded), least);
}

TEST(SimplexProgram, SaysThatItIsNotDone) {
  Progress progress;
  const SimplexSolution solution = solveOnSimplex(boxProgram(boxMesh(8, 0.3)), {3, 1e-9}, {}, progress);
  EXPECT_FALSE(solution.converged);
  EXPECT_EQ(solution.iterations, 3);
  EXPECT_GT(std::max(solution.primal, solution.dual), 1e-9);
  EXPECT_GE(solution.weights.minCoeff(), 0);
}

} // namespace
} // namespace viscera::coordinates
