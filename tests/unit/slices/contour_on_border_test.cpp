#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include "viscera/geometry/plane_cut.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_surfaces.h"
#include "viscera/slices/slice_frame.h"

/// The contour of an organ that came from a label map lies on the border of the label's voxels: the check
/// that axes, spacing and half voxels are right all the way from the file to the slice.
namespace viscera::slices {
namespace {

using Point = Eigen::Vector2d;

/// A border between voxels, or a piece of a contour, in voxels of one slice.
struct Piece {
  Point a, b;
};

double distance(const Point& point, const Piece& piece) {
  const Point along = piece.b - piece.a;
  const double length = along.squaredNorm();
  const double part = length > 0 ? std::clamp((point - piece.a).dot(along) / length, 0.0, 1.0) : 0;
  return (point - piece.a - part * along).norm();
}

/// The mean distance of the pieces' middles from the nearest of the others.
double meanDistance(const std::vector<Piece>& pieces, const std::vector<Piece>& others) {
  double sum = 0;
  for (const Piece& piece : pieces) {
    double least = std::numeric_limits<double>::infinity();
    for (const Piece& other : others)
      least = std::min(least, distance(0.5 * (piece.a + piece.b), other));
    sum += least;
  }
  return sum / static_cast<double>(pieces.size());
}

/// Where a segment's voxels of layer k meet others along i and j.
std::vector<Piece> borders(const medical_io::LabelMap& map, const std::vector<char>& inside, int k) {
  std::vector<Piece> pieces;
  const auto is = [&](int i, int j) {
    return i >= 0 && j >= 0 && i < map.size[0] && j < map.size[1] && inside[map.indexOf(i, j, k)];
  };
  for (int j = -1; j < map.size[1]; ++j)
    for (int i = -1; i < map.size[0]; ++i) {
      if (is(i, j) != is(i + 1, j))
        pieces.push_back({{i + 0.5, j - 0.5}, {i + 0.5, j + 0.5}});
      if (is(i, j) != is(i, j + 1))
        pieces.push_back({{i - 0.5, j + 0.5}, {i + 0.5, j + 0.5}});
    }
  return pieces;
}

/// The contour of a surface on layer k, in voxels.
std::vector<Piece> contour(const medical_io::LabelMap& map, const geometry::TriangleMesh& mesh, int k) {
  const Vec3 i = map.indexToLps.linear().col(0), j = map.indexToLps.linear().col(1);
  const geometry::Plane plane{map.indexToLps * Vec3(0, 0, k), i.cross(j).normalized()};
  const geometry::PlaneCut cut = geometry::cutSurface({&mesh.points, &mesh.triangles}, plane);
  const Eigen::Affine3d toIndex = map.indexToLps.inverse();
  std::vector<Piece> pieces;
  for (std::size_t line = 0; line < cut.lines(); ++line) {
    EXPECT_TRUE(cut.closed[line]);
    const int begin = cut.first[line], end = cut.first[line + 1];
    for (int row = begin; row < end; ++row) {
      const Vec3 a = toIndex * cut.points.row(row).transpose();
      const Vec3 b = toIndex * cut.points.row(row + 1 < end ? row + 1 : begin).transpose();
      EXPECT_NEAR(a.z(), k, 1e-6);
      pieces.push_back({a.head<2>(), b.head<2>()});
    }
  }
  return pieces;
}

/// Holds the contours of a segment's surface against its voxels, in every slice that has enough of both.
void expectOnBorder(const medical_io::LabelMap& map, std::size_t segment, int triangles) {
  Progress progress;
  medical_io::LabelSurfaceOptions options;
  options.segments = {segment};
  options.triangles = triangles;
  const geometry::TriangleMesh mesh = medical_io::labelSurfaces(map, options, progress).front().mesh;
  const auto& item = map.segments[segment];
  std::vector<char> inside(map.voxelCount());
  for (std::size_t v = 0; v < inside.size(); ++v)
    inside[v] = map.layers[std::size_t(item.layer)][v] == segment + 1;
  int seen = 0;
  // In the outermost layers a smooth surface ends where it will.
  for (int k = item.low[2] + 1; k < item.high[2]; ++k) {
    const std::vector<Piece> edges = borders(map, inside, k), lines = contour(map, mesh, k);
    ASSERT_FALSE(edges.empty()) << item.name << ", slice " << k;
    ASSERT_FALSE(lines.empty()) << item.name << ", slice " << k;
    EXPECT_LE(meanDistance(lines, edges), 0.25) << item.name << ", slice " << k;
    EXPECT_LE(meanDistance(edges, lines), 0.5) << item.name << ", slice " << k;
    ++seen;
  }
  EXPECT_GE(seen, 5) << item.name;
}

/// An egg in a corner of an oblique, left-handed grid of uneven spacing.
medical_io::LabelMap eggInObliqueGrid() {
  medical_io::LabelMap map;
  map.size = {40, 32, 24};
  map.indexToLps.linear() = Eigen::AngleAxisd(0.4, Vec3(1, 2, -1).normalized()).toRotationMatrix() *
                            Vec3(-1.2, 1.2, 2).asDiagonal();
  map.indexToLps.translation() = Vec3(31, -17, 240);
  map.layers.emplace_back(map.voxelCount(), std::uint16_t(0));
  medical_io::Segment egg;
  egg.label = 1;
  egg.name = "egg";
  egg.low = map.size;
  for (int k = 0; k < map.size[2]; ++k)
    for (int j = 0; j < map.size[1]; ++j)
      for (int i = 0; i < map.size[0]; ++i)
        if (Vec3((i - 14) / 11.0, (j - 17) / 9.0, (k - 10) / 7.0).norm() <= 1) {
          map.layers[0][map.indexOf(i, j, k)] = 1;
          ++egg.voxels;
          const std::array<int, 3> at = {i, j, k};
          for (std::size_t d = 0; d < 3; ++d) {
            egg.low[d] = std::min(egg.low[d], at[d]);
            egg.high[d] = std::max(egg.high[d], at[d]);
          }
        }
  map.segments.push_back(egg);
  return map;
}

TEST(ContourOnBorder, OfAnEggInAnObliqueLeftHandedGrid) {
  expectOnBorder(eggInObliqueGrid(), 0, 0);
}

TEST(ContourOnBorder, OfTheLiverOfARealPatient) {
  const std::filesystem::path file = std::filesystem::path(VISCERA_SHARED_ORGANS) / "ct/example_seg.nii.gz";
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << file << " is not there";
  Progress progress;
  const medical_io::LabelMap map = medical_io::readLabelMap(file, progress);
  const auto liver = medical_io::segmentsNamed(map, {"liver"}, file.string());
  expectOnBorder(map, liver.front(), 0);
}

} // namespace
} // namespace viscera::slices
