#include "viscera/elasticity/least_energy.h"

#include <memory>
#include <numeric>
#include <random>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "clouds.h"
#include "shapes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/grid_witnesses.h"

namespace viscera::elasticity {
namespace {

constexpr double kBallMm = 30, kHandlesMm = 45;
constexpr int kBallHandles = 20;

Eigen::Matrix3d drawnGradient(std::mt19937& random, double size) {
  std::normal_distribution<double> normal;
  Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 9; ++i)
    f.data()[i] += size * normal(random);
  return f;
}

TEST(StableNeoHookean, StressAndTangentAreTheDerivativesAlsoOfFoldedTissue) {
  constexpr double kStep = 1e-6;
  const StableNeoHookean material(0.45);
  std::mt19937 random(7);
  int folded = 0;
  for (int draw = 0; draw < 20; ++draw) {
    const Eigen::Matrix3d f = drawnGradient(random, 0.7);
    folded += f.determinant() < 0 ? 1 : 0;
    const Eigen::Matrix3d stress = material.stress(f);
    const Tangent tangent = material.tangent(f);
    const double size = 1 + tangent.norm();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        Eigen::Matrix3d more = f, less = f;
        more(i, j) += kStep;
        less(i, j) -= kStep;
        EXPECT_NEAR((material.energy(more) - material.energy(less)) / (2 * kStep), stress(i, j), 1e-7 * size);
        const Eigen::Matrix3d change = (material.stress(more) - material.stress(less)) / (2 * kStep);
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l)
            EXPECT_NEAR(change(k, l), tangent(3 * k + l, 3 * i + j), 1e-7 * size);
      }
  }
  EXPECT_GT(folded, 2);
}

TEST(StableNeoHookean, TheProjectedTangentIsTheTangentWithoutItsNegativeEigenvalues) {
  const StableNeoHookean material(0.45);
  std::mt19937 random(8);
  int negative = 0;
  for (int draw = 0; draw < 20; ++draw) {
    const Eigen::Matrix3d f = drawnGradient(random, 0.5);
    const Tangent tangent = material.tangent(f);
    const Eigen::SelfAdjointEigenSolver<Tangent> solver(tangent);
    negative += solver.eigenvalues()[0] < 0 ? 1 : 0;
    const Eigen::Matrix<double, 9, 1> kept = solver.eigenvalues().cwiseMax(0);
    const Tangent wanted = solver.eigenvectors() * kept.asDiagonal() * solver.eigenvectors().transpose();
    EXPECT_LE((material.projectedTangent(f) - wanted).norm(), 1e-10 * (1 + tangent.norm()));
  }
  EXPECT_GT(negative, 5);
}

TEST(StableNeoHookean, IsHookesLawForSmallStrains) {
  constexpr double kPoisson = 0.4, kStrain = 1e-4;
  const StableNeoHookean stable(kPoisson);
  const NeoHookean reference(2 * (1 + kPoisson), kPoisson); // Its shear modulus is 1.
  std::mt19937 random(9);
  for (int draw = 0; draw < 5; ++draw) {
    const Eigen::Matrix3d f = drawnGradient(random, kStrain);
    const double growth = f.determinant() - 1;
    const double wanted = reference.respond(f).energy + 0.5 * reference.bulk() * growth * growth;
    EXPECT_NEAR(stable.energy(f), wanted, 0.01 * wanted);
  }
  EXPECT_THROW(StableNeoHookean(0.5), UsageError);
}

/// A ball of tissue among handles on a sphere.
class LeastEnergyTest : public testing::Test {
protected:
  static void SetUpTestSuite() {
    handles_.positions = tests::onSphere(kBallHandles, kHandlesMm);
    ball_ = std::make_shared<const geometry::TriangleMesh>(tests::sphere(3, kBallMm));
    Progress progress;
    const deformation::WitnessMesh mesh = deformation::gridWitnesses(*ball_, 600, progress);
    const auto system = coordinates::sCelestial();
    part_ = {deformation::bindWitnesses(*system, handles_, mesh.points, {}, progress), witnessVolumes(mesh)};
    binding_ = deformation::bindOrgan(*system, handles_, ball_->points, {}, progress);
    tissue_ = tissueFor({2});
  }
  static void TearDownTestSuite() {
    tissue_.reset();
    part_ = {};
    binding_.reset();
    ball_.reset();
  }

  static std::shared_ptr<const LeastEnergy> tissueFor(Threads threads) {
    LeastEnergy::Options options;
    options.threads = threads;
    return std::make_shared<const LeastEnergy>(std::vector<WitnessedTissue>{part_}, rest(), options);
  }
  static const Points& rest() { return handles_.positions; }
  /// All handles from this one on.
  static std::vector<int> from(int first) {
    std::vector<int> rows(std::size_t(kBallHandles - first));
    std::iota(rows.begin(), rows.end(), first);
    return rows;
  }
  static Points pulled(double mm) {
    Points pose = rest();
    pose.row(0) += mm * Eigen::RowVector3d(0.8, -0.5, 0.33);
    return pose;
  }

  static inline coordinates::HandleSet handles_;
  static inline std::shared_ptr<const geometry::TriangleMesh> ball_;
  static inline std::shared_ptr<const coordinates::Binding> binding_;
  static inline WitnessedTissue part_;
  static inline std::shared_ptr<const LeastEnergy> tissue_;
};

TEST_F(LeastEnergyTest, WitnessesShareTheTetrahedraAmongThem) {
  Progress progress;
  const deformation::WitnessMesh mesh = deformation::gridWitnesses(*ball_, 600, progress);
  EXPECT_NEAR(witnessVolumes(mesh).sum(), deformation::tetrahedronVolumes(mesh.points, mesh.tetrahedra).sum(),
              1e-6);
  EXPECT_NEAR(static_cast<double>(tissue_->witnesses()), 600, 60);
}

TEST_F(LeastEnergyTest, GradientAgreesWithDifferences) {
  constexpr double kStep = 1e-4;
  const Points pose = pulled(25);
  const Points gradient = tissue_->gradient(pose);
  const double size = gradient.cwiseAbs().maxCoeff();
  ASSERT_GT(size, 0);
  for (Eigen::Index row = 0; row < kBallHandles; ++row)
    for (int axis = 0; axis < 3; ++axis) {
      Points more = pose, less = pose;
      more(row, axis) += kStep;
      less(row, axis) -= kStep;
      EXPECT_NEAR((tissue_->energy(more) - tissue_->energy(less)) / (2 * kStep), gradient(row, axis),
                  1e-6 * size);
    }
}

TEST_F(LeastEnergyTest, StiffnessAtRestAgreesWithDifferencesOfTheGradient) {
  constexpr double kStep = 1e-4;
  const std::vector<int> free = {1, 4, 5, 11, 19};
  const Eigen::MatrixXd stiffness = tissue_->stiffness(rest(), free);
  const double size = stiffness.cwiseAbs().maxCoeff();
  for (std::size_t i = 0; i < free.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      Points more = rest(), less = rest();
      more(free[i], axis) += kStep;
      less(free[i], axis) -= kStep;
      const Points change = (tissue_->gradient(more) - tissue_->gradient(less)) / (2 * kStep);
      for (std::size_t j = 0; j < free.size(); ++j)
        for (int other = 0; other < 3; ++other)
          EXPECT_NEAR(stiffness(Eigen::Index(3 * i) + axis, Eigen::Index(3 * j) + other),
                      change(free[j], other), 1e-4 * size);
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(tissue_->stiffness(pulled(60), from(1)));
  EXPECT_GE(solver.eigenvalues()[0], -1e-5 * solver.eigenvalues().tail<1>()[0]) << "projected in any pose";
}

TEST_F(LeastEnergyTest, FreeHandlesFollowARigidMotionOfTheOthers) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.6, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  const Points there = (rest() * turn.transpose()).rowwise() + Eigen::RowVector3d(8, -20, 13);
  EXPECT_LE(std::abs(tissue_->energy(there)), 1e-12);
  Points start = rest();
  start.topRows(4) = there.topRows(4);
  LeastEnergy::Relaxing exactly;
  exactly.tolerance = 1e-13;
  exactly.mostSteps = 100;
  const RelaxedPose relaxed = tissue_->relax(start, from(4), exactly);
  EXPECT_LE((relaxed.pose - there).cwiseAbs().maxCoeff(), 5e-9 * kHandlesMm);
  EXPECT_LE(std::abs(relaxed.energy), 1e-12);
}

TEST_F(LeastEnergyTest, AnAffinePoseHasTheEnergyOfItsMatrixEverywhere) {
  Eigen::Matrix3d affine = Eigen::Matrix3d::Identity();
  affine(0, 0) = 1.2;
  affine(0, 1) = 0.15;
  affine(2, 2) = 0.9;
  const Points pose = (rest() * affine.transpose()).rowwise() + Eigen::RowVector3d(3, 1, -2);
  const double wanted = StableNeoHookean(LeastEnergy::Options().poisson).energy(affine);
  ASSERT_GT(wanted, 0.01);
  EXPECT_NEAR(tissue_->energy(pose), wanted, 1e-4) << "the springs have a thousandth";
}

TEST_F(LeastEnergyTest, TheEnergyFallsAndTheGradientVanishes) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (const double mm : {1.0, 10.0, 40.0}) {
    Points start = rest();
    for (int axis = 0; axis < 3; ++axis)
      start(2, axis) += mm * normal(random);
    std::vector<int> free = from(3);
    std::erase(free, 12); // Holds the ball, with 0 and 1.
    const RelaxedPose relaxed = tissue_->relax(start, free);
    EXPECT_TRUE(relaxed.converged) << mm;
    EXPECT_LT(relaxed.energy, 0.95 * tissue_->energy(start));
    EXPECT_EQ(relaxed.energy, tissue_->energy(relaxed.pose));
    for (const int row : {0, 1, 2, 12})
      EXPECT_EQ(relaxed.pose.row(row), start.row(row));
    const Points before = tissue_->gradient(start), after = tissue_->gradient(relaxed.pose);
    EXPECT_LT(after(free, Eigen::all).norm(), 0.1 * before(free, Eigen::all).norm()) << mm;
  }
}

TEST_F(LeastEnergyTest, AWarmStartTakesFewSteps) {
  std::vector<int> free = from(3);
  const RelaxedPose first = tissue_->relax(pulled(20), free);
  Points next = first.pose;
  next.row(0) = pulled(21).row(0);
  const RelaxedPose warm = tissue_->relax(next, free);
  EXPECT_TRUE(warm.converged);
  EXPECT_LE(warm.steps, 8);
  EXPECT_LE((warm.pose - tissue_->relax(pulled(21), free).pose).cwiseAbs().maxCoeff(), 0.05)
      << "the way hardly matters, mm";
}

TEST_F(LeastEnergyTest, LocksAreKeptForTheLockToFinish) {
  const double volume = 4.0 / 3 * 3.14159265358979 * kBallMm * kBallMm * kBallMm;
  for (const double factor : {0.97, 1.02}) {
    const deformation::VolumeLock lock({{"ball", ball_, binding_, factor * volume}});
    const std::vector<int> free = from(2);
    const RelaxedPose relaxed = tissue_->relax(pulled(15), free, &lock);
    EXPECT_NEAR(lock.volumes(relaxed.pose).front() / (factor * volume), 1, 1e-5);
    const deformation::RestoredPose restored =
        lock.restore(relaxed.pose, free, deformation::LeastDisplacement(), kBallMm);
    EXPECT_TRUE(restored.restored) << restored.reason.english();
    EXPECT_LE(restored.relativeError, 1e-12);
    EXPECT_LE(restored.largestShiftMm, 0.05) << "nothing is left to do but digits";
    const deformation::RestoredPose alone =
        lock.restore(pulled(15), free, deformation::LeastDisplacement(), kBallMm);
    ASSERT_TRUE(alone.restored);
    EXPECT_LT(tissue_->energy(restored.pose), tissue_->energy(alone.pose));
  }
}

TEST_F(LeastEnergyTest, ResultsDoNotDependOnTheNumberOfThreads) {
  const RelaxedPose one = tissueFor({1})->relax(pulled(25), from(3));
  const RelaxedPose three = tissueFor({3})->relax(pulled(25), from(3));
  EXPECT_EQ(one.pose, three.pose);
  EXPECT_EQ(one.energy, three.energy);
}

TEST_F(LeastEnergyTest, WithoutFreeHandlesNothingMoves) {
  const RelaxedPose relaxed = tissue_->relax(pulled(25), {});
  EXPECT_EQ(relaxed.pose, pulled(25));
  EXPECT_TRUE(relaxed.converged);
  EXPECT_EQ(relaxed.steps, 0);
}

TEST_F(LeastEnergyTest, SaysThatThereIsNoTissue) {
  try {
    const LeastEnergy none({}, rest());
    FAIL();
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("there is no witness point"), std::string::npos) << error.what();
  }
  EXPECT_THROW(tissue_->energy(Points::Zero(3, 3)), DataError);
}

} // namespace
} // namespace viscera::elasticity
