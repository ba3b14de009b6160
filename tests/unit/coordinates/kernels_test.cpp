#include <gtest/gtest.h>

#include "celestial/celestial_function.h"
#include "clouds.h"
#include "simd/usable_kernels.h"

/// Every version of the kernels that this processor can run computes the same, up to the rounding of fused
/// products.
namespace viscera::coordinates::simd {
namespace {

constexpr int kHandles = 13;
constexpr int kTile = 16;

Eigen::MatrixXd randomNumbers(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  const Points cloud = tests::cloud(static_cast<int>((rows * columns + 2) / 3), seed);
  return Eigen::Map<const Eigen::MatrixXd>(cloud.data(), rows, columns);
}

struct CelestialCase {
  const char* name;
  SolveCelestialTile CelestialKernels::*solve;
  int dimension;
  double locality;
  double softness;
};

/// Coordinates and solutions of one version; points 0 to 13 are inside the sphere of handles, 14 is outside,
/// and 15 is at handle 3.
struct CelestialResult {
  Eigen::MatrixXd tile{kTile, kHandles};
  Eigen::MatrixXd x{kTile, 3};
  unsigned failed = 0;
};

CelestialResult solveCelestial(const CelestialKernels& kernels, const CelestialCase& each) {
  const Points handles = tests::onSphere(kHandles);
  Points points = tests::cloud(kTile, 7, 0.4);
  points.row(14) << 3, 3, 3;
  points.row(15) = handles.row(3);
  const Eigen::MatrixXd handlesByAxis = handles, pointsByAxis = points; // Column by column.
  const CelestialProblem problem = {handlesByAxis.data(),          kHandles, each.locality,
                                    each.softness * each.softness, 1e-28,    1e-13};
  std::vector<double> scratch(kHandles * kCelestialScratch);
  CelestialResult result;
  result.x.setZero();
  result.failed = (kernels.*each.solve)(problem, pointsByAxis.data(), scratch.data(), result.tile.data(),
                                        result.x.data());
  return result;
}

} // namespace

TEST(Kernels, IncludeTheBaselineEverywhere) {
  EXPECT_GE(usableTileKernels().size(), 1u);
  EXPECT_EQ(usableTileKernels().size(), simd::usableCelestialKernels().size());
  EXPECT_EQ(usableTileKernels().size(), usableDeterminantKernels().size());
}

TEST(Kernels, OfDeterminantsAgreeBetweenInstructionSets) {
  constexpr long kPoints = 5, kStride = 32;
  const Eigen::MatrixXd weights = randomNumbers(kStride, kPoints, 4); // A column a point.
  const Eigen::MatrixXd strip = randomNumbers(kStrip, kPoints, 5), before = randomNumbers(kStride, kStrip, 6);
  const std::vector<long> starts = {0, 2, 2, 4, 8, 10}; // The second point has no corners.
  const std::vector<int> corners = {1, 4, 0, 2, 2, 3, 1, 0, 4, 3};
  constexpr long kHandle = 3, kFirst = kStride - kPanel;
  Eigen::MatrixXd gathered = Eigen::MatrixXd::Zero(kPanel, kPoints);
  for (Eigen::Index point = 0; point < kPoints; ++point)
    for (long item = starts[std::size_t(point)]; item < starts[std::size_t(point + 1)]; item += 2) {
      const Eigen::VectorXd q = weights.col(corners[std::size_t(item)]),
                            r = weights.col(corners[std::size_t(item + 1)]);
      gathered.col(point) += r[kHandle] * q.tail(kPanel) - q[kHandle] * r.tail(kPanel);
    }
  Eigen::MatrixXd grown = before;
  grown.topRows(kPanel) += gathered * strip.transpose();
  for (const DeterminantKernels* kernels : usableDeterminantKernels()) {
    Eigen::MatrixXd panel(kPanel, kPoints), sums = before;
    EXPECT_TRUE(kernels->gather(weights.data(), kStride, kHandle, kFirst, starts.data(), corners.data(),
                                kPoints, panel.data()));
    EXPECT_TRUE(panel.isApprox(gathered, 1e-14));
    kernels->multiply(strip.data(), panel.data(), kPoints, sums.data(), kStride);
    EXPECT_TRUE(sums.isApprox(grown, 1e-14));
  }
}

TEST(Kernels, OfTilesAgreeBetweenInstructionSets) {
  const Eigen::MatrixXd tile = randomNumbers(kTile, kHandles, 1);
  const Points pose = tests::cloud(kHandles, 2), rows = tests::cloud(kTile, 3);
  const Vec3 delta(1, -2, 3);
  Points product(kTile, 3), moved = rows;
  product = tile * pose;
  moved += tile.col(4) * delta.transpose();
  const Points transposed = tile.transpose() * rows;
  for (const TileKernels* kernels : usableTileKernels()) {
    Points points(kTile, 3), added = rows;
    kernels->multiply(tile.data(), pose.data(), kHandles, points.data());
    EXPECT_TRUE(points.isApprox(product, 1e-14));
    kernels->addColumn(tile.col(4).data(), delta.data(), added.data());
    EXPECT_TRUE(added.isApprox(moved, 1e-15));
    std::vector<double> sums(kHandles * 3 * kSumLanes);
    kernels->addTransposed(tile.data(), rows.data(), kHandles, sums.data());
    for (int i = 0; i < kHandles * 3; ++i) {
      double sum = 0;
      for (int lane = 0; lane < kSumLanes; ++lane)
        sum += sums[std::size_t(i * kSumLanes + lane)];
      EXPECT_NEAR(sum, transposed.data()[i], 1e-14);
    }
  }
}

TEST(Kernels, OfTilesInSinglePrecisionAgreeBetweenInstructionSets) {
  // Positive, with the sum 1 at every point; point 5 has none, point 6 is at a handle.
  Eigen::MatrixXd exact = randomNumbers(kTile, kHandles, 1).cwiseAbs();
  exact.array().colwise() /= exact.rowwise().sum().array().eval();
  exact.row(5).setZero();
  exact.row(6) = Eigen::RowVectorXd::Unit(kHandles, 3);
  exact(7, 2) = 1e-40;
  const Points pose = tests::cloud(kHandles, 2), rows = tests::cloud(kTile, 3);
  const Vec3 delta(1, -2, 3);
  for (const TileKernels* kernels : usableTileKernels()) {
    Eigen::MatrixXd tile = exact;
    Eigen::MatrixXf single(kTile, kHandles + 1);
    kernels->round(tile.data(), kHandles, single.data());
    EXPECT_EQ(tile(7, 2), 0);
    EXPECT_EQ(tile.row(6), exact.row(6));
    EXPECT_EQ(tile.row(5), exact.row(5));
    EXPECT_LT(((tile - exact).array().abs() - 1.2e-7 * exact.array()).maxCoeff(), 1e-39);
    EXPECT_LT((tile.rowwise().sum() - exact.rowwise().sum()).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_GT((tile - exact).cwiseAbs().maxCoeff(), 1e-10);

    Points points(kTile, 3), added = rows, moved = rows;
    kernels->multiplySingle(single.data(), pose.data(), kHandles, points.data());
    EXPECT_TRUE(points.isApprox(Points(tile * pose), 1e-14));
    kernels->addColumnSingle(single.data(), 4, kHandles, delta.data(), added.data());
    moved += tile.col(4) * delta.transpose();
    EXPECT_TRUE(added.isApprox(moved, 1e-15));
    std::vector<double> sums(kHandles * 3 * kSumLanes);
    kernels->addTransposedSingle(single.data(), rows.data(), kHandles, sums.data());
    const Points transposed = tile.transpose() * rows;
    for (int i = 0; i < kHandles * 3; ++i) {
      double sum = 0;
      for (int lane = 0; lane < kSumLanes; ++lane)
        sum += sums[std::size_t(i * kSumLanes + lane)];
      EXPECT_NEAR(sum, transposed.data()[i], 1e-14);
    }
  }
}

TEST(Kernels, OfCelestialCoordinatesAgreeBetweenInstructionSets) {
  for (const CelestialCase& each : {CelestialCase{"S", &CelestialKernels::s3, 3, 0, 0},
                                    CelestialCase{"S soft", &CelestialKernels::s3, 3, 3, 0.5},
                                    CelestialCase{"T", &CelestialKernels::t3, 3, 0, 0},
                                    CelestialCase{"T local", &CelestialKernels::t3, 3, 2, 0},
                                    CelestialCase{"S flat", &CelestialKernels::s2, 2, 0, 0},
                                    CelestialCase{"T flat", &CelestialKernels::t2, 2, 1, 0.1}}) {
    SCOPED_TRACE(each.name);
    const CelestialResult first = solveCelestial(*simd::usableCelestialKernels().back(), each);
    EXPECT_EQ(first.failed, 1u << 14);
    for (const CelestialKernels* kernels : simd::usableCelestialKernels()) {
      const CelestialResult other = solveCelestial(*kernels, each);
      EXPECT_EQ(other.failed, first.failed);
      EXPECT_LT((other.tile - first.tile).cwiseAbs().maxCoeff(), 1e-11);
      EXPECT_LT((other.x - first.x).cwiseAbs().maxCoeff(), 1e-9 * (1 + first.x.cwiseAbs().maxCoeff()));
    }
  }
}

} // namespace viscera::coordinates::simd
