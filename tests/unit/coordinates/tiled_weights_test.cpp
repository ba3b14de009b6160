#include "viscera/coordinates/tiled_weights.h"

#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include "clouds.h"

namespace viscera::coordinates {
namespace {

using Matrix = Eigen::MatrixXd;

/// Random weights and the same as a plain matrix.
struct Pair {
  TiledWeights tiled;
  Matrix plain;
};

Pair randomPair(Eigen::Index points, Eigen::Index handles, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  Pair pair{TiledWeights(points, handles), Matrix(points, handles)};
  for (Eigen::Index i = 0; i < points; ++i)
    for (Eigen::Index j = 0; j < handles; ++j) {
      pair.plain(i, j) = value(random);
      pair.tiled.set(i, j, pair.plain(i, j));
    }
  return pair;
}

/// Sizes around whole tiles and whole ranges of tiles.
class TiledWeightsTest : public testing::TestWithParam<int> {};

} // namespace

TEST_P(TiledWeightsTest, MultiplyAsAPlainMatrixDoes) {
  const Pair pair = randomPair(GetParam(), 7);
  const Points pose = tests::cloud(7, 2);
  Points points;
  pair.tiled.multiply(pose, points, {});
  ASSERT_EQ(points.rows(), GetParam());
  EXPECT_TRUE(points.isApprox(Points(pair.plain * pose), 1e-14));
}

TEST_P(TiledWeightsTest, MultiplyTransposedAsAPlainMatrixDoes) {
  const Pair pair = randomPair(GetParam(), 7);
  const Points rows = tests::cloud(GetParam(), 3);
  Points out;
  pair.tiled.multiplyTransposed(rows, out, {});
  ASSERT_EQ(out.rows(), 7);
  EXPECT_LT((out - pair.plain.transpose() * rows).cwiseAbs().maxCoeff(), 1e-15 * GetParam());
}

TEST_P(TiledWeightsTest, AddOneColumn) {
  const Pair pair = randomPair(GetParam(), 7);
  const Points before = tests::cloud(GetParam(), 4);
  const Vec3 delta(1, -2, 3);
  Points points = before;
  pair.tiled.addColumn(5, delta, points, {});
  EXPECT_TRUE(points.isApprox(Points(before + pair.plain.col(5) * delta.transpose()), 1e-15));
  EXPECT_EQ(pair.tiled.column(5), pair.plain.col(5));
}

TEST_P(TiledWeightsTest, GiveTheSameBitsForAnyNumberOfThreads) {
  const Pair pair = randomPair(GetParam(), 7);
  const Points pose = tests::cloud(7, 2), rows = tests::cloud(GetParam(), 3);
  Points one, oneTransposed;
  pair.tiled.multiply(pose, one, {1});
  pair.tiled.multiplyTransposed(rows, oneTransposed, {1});
  for (const int threads : {2, 3, 5}) {
    Points more, moreTransposed;
    pair.tiled.multiply(pose, more, {threads});
    pair.tiled.multiplyTransposed(rows, moreTransposed, {threads});
    EXPECT_EQ(more, one);
    EXPECT_EQ(moreTransposed, oneTransposed);
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, TiledWeightsTest, testing::Values(1, 15, 16, 17, 1023, 1024, 1025, 5000));

TEST(TiledWeights, StartAsZerosAtACacheLine) {
  // The larger one is in huge pages.
  for (const Eigen::Index points : {40, 40000}) {
    const TiledWeights weights(points, 9);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(weights.tile(0)) % 64, 0u);
    const double* data = weights.tile(0);
    for (Eigen::Index i = 0; i < weights.tiles() * TiledWeights::kTile * 9; ++i)
      ASSERT_EQ(data[i], 0) << i;
  }
}

TEST(TiledWeights, CopyDeeplyAndMoveWithoutCopying) {
  Pair pair = randomPair(40, 3);
  TiledWeights copy = pair.tiled;
  copy.set(20, 1, 5);
  EXPECT_EQ(pair.tiled(20, 1), pair.plain(20, 1));
  EXPECT_EQ(copy(20, 1), 5);
  EXPECT_EQ(copy(21, 1), pair.plain(21, 1));
  const double* data = copy.tile(0);
  const TiledWeights moved = std::move(copy);
  EXPECT_EQ(moved.tile(0), data);
  TiledWeights assigned(2, 2);
  assigned = pair.tiled;
  EXPECT_EQ(assigned.points(), 40);
  EXPECT_EQ(assigned(39, 2), pair.plain(39, 2));
}

TEST(TiledWeights, WithoutPointsDoNothing) {
  const TiledWeights weights(0, 4);
  Points points, out;
  weights.multiply(Points::Ones(4, 3), points, {});
  EXPECT_EQ(points.rows(), 0);
  weights.multiplyTransposed(points, out, {});
  EXPECT_EQ(out, Points::Zero(4, 3));
}

} // namespace viscera::coordinates
