#include "mesh_differences.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "viscera/lesson/packed_arrays.h"

namespace viscera::lesson {
namespace {

constexpr int kSide = 60;

/// A square of vertices in an order that knows no neighbours, each cell two triangles.
Triangles shuffledSquare() {
  std::vector<std::int32_t> order(kSide * kSide);
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = static_cast<std::int32_t>((i * 1009) % order.size());
  Triangles triangles(2 * (kSide - 1) * (kSide - 1), 3);
  Eigen::Index at = 0;
  for (std::size_t y = 0; y + 1 < kSide; ++y)
    for (std::size_t x = 0; x + 1 < kSide; ++x) {
      const auto corner = [&](std::size_t dx, std::size_t dy) { return order[(y + dy) * kSide + x + dx]; };
      triangles.row(at++) << corner(0, 0), corner(1, 0), corner(0, 1);
      triangles.row(at++) << corner(1, 0), corner(1, 1), corner(0, 1);
    }
  return triangles;
}

} // namespace

TEST(MeshDifferences, ComeBackToTheBit) {
  constexpr Eigen::Index kVertices = kSide * kSide + 7; // Handles have no triangles.
  std::mt19937 random(3);
  std::uniform_int_distribution<std::int32_t> any(std::numeric_limits<std::int32_t>::min(),
                                                  std::numeric_limits<std::int32_t>::max());
  for (const int components : {1, 3}) {
    std::vector<std::int32_t> values(static_cast<std::size_t>(2 * kVertices * components));
    for (std::int32_t& value : values)
      value = any(random);
    const MeshDifferences mesh(shuffledSquare(), kVertices);
    EXPECT_EQ(mesh.undone(mesh.of(values, components), components), values) << components;
  }
}

TEST(MeshDifferences, AreToTheRoundedMeanOfNeighboursBefore) {
  Triangles triangles(2, 3);
  triangles << 0, 1, 2, 3, 2, 1;
  const std::vector<std::int32_t> values = {10, 14, 13, 20, 25};
  const std::vector<std::int32_t> expected = {10, 4, 0, 6,
                                              5}; // 13.5 is rounded up to 14; 4 has no neighbours.
  EXPECT_EQ(MeshDifferences(triangles, 5).of(values, 1), expected);
  const std::vector<std::int32_t> below = {-10, -14, -13, -20, -25};
  EXPECT_EQ(MeshDifferences(triangles, 5).of(below, 1)[3], -7) << "-13.5 is rounded up to -13";
}

TEST(MeshDifferences, OfASmoothFieldDeflateToLittle) {
  const Triangles triangles = shuffledSquare();
  std::vector<std::int32_t> values(kSide * kSide);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto x = static_cast<double>(i % kSide), y = static_cast<double>(i / kSide);
    values[i * 1009 % values.size()] =
        static_cast<std::int32_t>(std::lround(900 * std::sin(0.05 * x + 0.03 * y)));
  }
  const std::vector<std::int32_t> differences = MeshDifferences(triangles, kSide * kSide).of(values, 1);
  ArrayPacker before, mesh;
  before.add(values, 1);
  mesh.add(differences, static_cast<int>(differences.size()));
  EXPECT_LT(deflated(mesh.bytes()).size(), deflated(before.bytes()).size());
}

} // namespace viscera::lesson
