#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "dicom_slices.h"
#include "phantom_scan.h"
#include "temporary_folder.h"
#include "viscera/geometry/plane_cut.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_surfaces.h"
#include "viscera/medical_io/scan.h"
#include "viscera/medical_io/slice_frame.h"

/// The contour of an organ that came from a label map lies on the border of the label's voxels: the check
/// that axes, spacing and half voxels are right all the way from the file to the slice.
namespace viscera::medical_io {
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

/// A layer of a label map: voxel `at` along `axis`, seen along the two axes that follow.
struct Layer {
  const LabelMap& map;
  std::size_t axis;
  int at;

  std::size_t along() const { return (axis + 1) % 3; }
  std::size_t across() const { return (axis + 2) % 3; }
  std::size_t indexOf(int a, int b) const {
    std::array<int, 3> voxel{};
    voxel[axis] = at;
    voxel[along()] = a;
    voxel[across()] = b;
    return map.indexOf(voxel[0], voxel[1], voxel[2]);
  }
  Vec3 step(std::size_t k) const { return map.indexToLps.linear().col(static_cast<Eigen::Index>(k)); }
};

/// Where a segment's voxels of a layer meet others.
std::vector<Piece> borders(const Layer& layer, const std::vector<char>& inside, const Segment& segment) {
  std::vector<Piece> pieces;
  const std::size_t x = layer.along(), y = layer.across();
  const auto is = [&](int a, int b) {
    return a >= 0 && b >= 0 && a < layer.map.size[x] && b < layer.map.size[y] && inside[layer.indexOf(a, b)];
  };
  for (int b = segment.low[y] - 1; b <= segment.high[y]; ++b)
    for (int a = segment.low[x] - 1; a <= segment.high[x]; ++a) {
      if (is(a, b) != is(a + 1, b))
        pieces.push_back({{a + 0.5, b - 0.5}, {a + 0.5, b + 0.5}});
      if (is(a, b) != is(a, b + 1))
        pieces.push_back({{a - 0.5, b + 0.5}, {a + 0.5, b + 0.5}});
    }
  return pieces;
}

/// The contour of a surface on a layer, in voxels.
std::vector<Piece> contour(const Layer& layer, const geometry::TriangleMesh& mesh) {
  const Vec3 middle = layer.map.indexToLps * Vec3(layer.at * Vec3::Unit(Eigen::Index(layer.axis)));
  const geometry::Plane plane{middle,
                              layer.step(layer.along()).cross(layer.step(layer.across())).normalized()};
  const geometry::PlaneCut cut = geometry::cutSurface({&mesh.points, &mesh.triangles}, plane);
  const Eigen::Affine3d toIndex = layer.map.indexToLps.inverse();
  const auto flat = [&](Eigen::Index row) {
    const Vec3 place = toIndex * cut.points.row(row).transpose();
    EXPECT_NEAR(place[Eigen::Index(layer.axis)], layer.at, 1e-6);
    return Point(place[Eigen::Index(layer.along())], place[Eigen::Index(layer.across())]);
  };
  std::vector<Piece> pieces;
  for (std::size_t line = 0; line < cut.lines(); ++line) {
    EXPECT_TRUE(cut.closed[line]);
    const int begin = cut.first[line], end = cut.first[line + 1];
    for (int row = begin; row < end; ++row)
      pieces.push_back({flat(row), flat(row + 1 < end ? row + 1 : begin)});
  }
  return pieces;
}

/// What is asked of contours, in voxels of the map, by how many voxels wide the stairs of its labels are: a
/// segmentation that was copied to finer voxels keeps the stairs of its own, and the surface smooths them.
struct Asked {
  int stairs = 1;
  double onBorder = 0.3; ///< Mean distance of contours from the border, at most, over all layers.
  double covered = 0.5;  ///< Mean distance of the border from contours.
};
/// Where a surface runs along a layer its border is that of a terrace, which is smoothed away.
constexpr double kOnBorderInOne = 0.75, kCoveredInOne = 2;

/// Holds the contours of a segment's surface of `triangles` (0: all) against its voxels, in every layer along
/// every axis of the voxels, the outermost too.
void expectOnBorder(const LabelMap& map, std::size_t segment, int triangles, const Asked& asked) {
  Progress progress;
  LabelSurfaceOptions options;
  options.segments = {segment};
  options.triangles = triangles;
  const geometry::TriangleMesh mesh = labelSurfaces(map, options, progress).front().mesh;
  const auto& item = map.segments[segment];
  std::vector<char> inside(map.voxelCount());
  for (std::size_t v = 0; v < inside.size(); ++v)
    inside[v] = map.layers[std::size_t(item.layer)][v] == segment + 1;
  int seen = 0;
  double onBorder = 0, covered = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int at = item.low[axis]; at <= item.high[axis]; ++at) {
      const Layer layer{map, axis, at};
      const std::vector<Piece> edges = borders(layer, inside, item), lines = contour(layer, mesh);
      SCOPED_TRACE(item.name + ", axis " + std::to_string(axis) + ", layer " + std::to_string(at));
      ASSERT_FALSE(edges.empty());
      // A nub of one, two or three stairs is all corners: it is rounded by half a stair, or off.
      const bool nub = edges.size() < std::size_t(12 * asked.stairs);
      if (nub && lines.empty())
        continue;
      ASSERT_FALSE(lines.empty());
      const double off = meanDistance(lines, edges), bare = meanDistance(edges, lines);
      EXPECT_LE(off, kOnBorderInOne * asked.stairs);
      EXPECT_LE(bare, kCoveredInOne * asked.stairs);
      if (nub)
        continue;
      onBorder += off;
      covered += bare;
      ++seen;
    }
  ASSERT_GE(seen, 15) << item.name;
  EXPECT_LE(onBorder / seen, asked.onBorder) << item.name;
  EXPECT_LE(covered / seen, asked.covered) << item.name;
}

/// An egg in a corner of an oblique, left-handed grid of uneven spacing.
LabelMap eggInObliqueGrid() {
  LabelMap map;
  map.size = {40, 32, 24};
  map.indexToLps.linear() = Eigen::AngleAxisd(0.4, Vec3(1, 2, -1).normalized()).toRotationMatrix() *
                            Vec3(-1.2, 1.2, 2).asDiagonal();
  map.indexToLps.translation() = Vec3(31, -17, 240);
  map.layers.emplace_back(map.voxelCount());
  Segment egg;
  egg.label = 1;
  egg.name = "egg";
  egg.low = map.size;
  for (int k = 0; k < map.size[2]; ++k)
    for (int j = 0; j < map.size[1]; ++j)
      for (int i = 0; i < map.size[0]; ++i)
        if (Vec3((i - 14) / 11.0, (j - 17) / 9.0, (k - 10) / 7.0).norm() <= 1) {
          map.layers[0].set(map.indexOf(i, j, k), 1);
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
  expectOnBorder(eggInObliqueGrid(), 0, 0, {});
}

/// An egg with a bump, so that no axis can be taken for another, on the grid of a phantom.
tests::LabelImage bumpyEgg(const tests::LabelImage& grid, std::int16_t inside, std::int16_t outside) {
  tests::LabelImage image = grid;
  for (int k = 0; k < image.size[2]; ++k)
    for (int j = 0; j < image.size[1]; ++j)
      for (int i = 0; i < image.size[0]; ++i) {
        const Vec3 place = image.indexToLps * Vec3(i, j, k);
        const bool in = ((place - Vec3(6, 4, -6)).array() / Vec3(17, 25, 19).array()).matrix().norm() <= 1 ||
                        (place - Vec3(16, 20, 4)).norm() <= 13;
        image.at(i, j, k) = in ? inside : outside;
      }
  return image;
}

/// Each voxel's label says whether the scan is bright at that place of the patient.
void expectAlike(const LabelMap& map, const Scan& scan) {
  std::size_t differing = 0;
  for (int k = 0; k < map.size[2]; ++k)
    for (int j = 0; j < map.size[1]; ++j)
      for (int i = 0; i < map.size[0]; ++i) {
        const bool in = map.layers[0][map.indexOf(i, j, k)] != 0;
        const double value = scan.at(map.indexToLps * Vec3(i, j, k)).value_or(-1e9);
        differing += std::abs(value - (in ? 100 : -50)) > 1 ? 1U : 0U;
      }
  EXPECT_EQ(differing, 0U);
}

TEST(ContourOnBorder, OfAPhantomInEveryOrientationWhateverTheFormats) {
  Progress progress;
  for (const auto& [name, grid] : tests::orientedPhantoms()) {
    SCOPED_TRACE(name);
    const tests::TemporaryFolder folder;
    const tests::LabelImage labels = bumpyEgg(grid, 1, 0), values = bumpyEgg(grid, 100, -50);
    const std::array maps = {readLabelMap(folder.put("labels.nii", tests::niftiFile(labels)), progress),
                             readLabelMap(folder.put("labels.nrrd", tests::nrrdFile(labels)), progress)};
    std::filesystem::create_directories(folder / "dicom");
    for (int k = 0; k < values.size[2]; ++k)
      folder.put("dicom/" + std::to_string(k), tests::dicomBytes(tests::dicomSlice(values, k)));
    const std::array scans = {readScan(folder.put("ct.nii", tests::niftiFile(values)), {}, progress),
                              readScan(folder.put("ct.nrrd", tests::nrrdFile(values)), {}, progress),
                              readScan(folder / "dicom", {}, progress)};
    for (const LabelMap& map : maps) {
      expectOnBorder(map, 0, 0, {});
      for (const Scan& scan : scans)
        expectAlike(map, scan);
    }
  }
}

/// The organs of one of the shared segmentations.
void expectOrgansOnBorder(const std::string& name, const std::vector<std::string>& organs, int triangles,
                          const Asked& asked = {}) {
  const std::filesystem::path file = std::filesystem::path(VISCERA_SHARED_ORGANS) / "ct" / name;
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << file << " is not there";
  Progress progress;
  const LabelMap map = readLabelMap(file, progress);
  for (const std::size_t segment : segmentsNamed(map, organs, file.string()))
    expectOnBorder(map, segment, triangles, asked);
}

constexpr int kTrianglesOfTheWindow = LabelSurfaceOptions().triangles;

TEST(ContourOnBorder, OfTheLargeOrgansOfARealPatient) {
  expectOrgansOnBorder("example_seg.nii.gz", {"liver", "spleen", "kidney_left", "stomach"}, 0);
  expectOrgansOnBorder("example_seg.nii.gz", {"liver"}, kTrianglesOfTheWindow);
}

// Its voxels of 0.98 mm are copies of voxels of 3 mm.
TEST(ContourOnBorder, OfTheLiverOfARealDicomSeries) {
  const Asked asked{3, 0.5, 0.6};
  for (const int triangles : {0, kTrianglesOfTheWindow})
    expectOrgansOnBorder("example_seg_dicom.nii.gz", {"liver"}, triangles, asked);
}

} // namespace
} // namespace viscera::medical_io
