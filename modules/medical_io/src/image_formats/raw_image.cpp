#include "image_formats/raw_image.h"

#include <cmath>

#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

constexpr std::int64_t kLongestAxis = 65535;
constexpr double kFarthestVoxelMm = 1e9;
/// Part of the volume of a box with the same edges: less is no volume any more.
constexpr double kFlattest = 1e-6;

} // namespace

double secondsAUnit(std::string_view unit) {
  static constexpr std::array<std::pair<std::string_view, double>, 11> kUnits = {{{"s", 1},
                                                                                  {"sec", 1},
                                                                                  {"second", 1},
                                                                                  {"seconds", 1},
                                                                                  {"ms", 1e-3},
                                                                                  {"msec", 1e-3},
                                                                                  {"millisecond", 1e-3},
                                                                                  {"milliseconds", 1e-3},
                                                                                  {"us", 1e-6},
                                                                                  {"usec", 1e-6},
                                                                                  {"microsecond", 1e-6}}};
  return lookUp(kUnits, unit).value_or(0);
}

std::uint64_t RawImage::valueCount() const {
  std::uint64_t count = static_cast<std::uint64_t>(layers);
  for (const int n : size)
    count = saturatedProduct(count, static_cast<std::uint64_t>(n));
  return count;
}

std::uint64_t RawImage::byteCount() const {
  return saturatedProduct(valueCount(), sizeOf(scalar));
}

int axisSize(const FileBytes& file, std::int64_t size, std::string_view axis) {
  if (size < 1 || size > kLongestAxis)
    file.fail(diagnostic("its header is damaged: its size along %1 is %2", axis, size));
  return static_cast<int>(size);
}

void requireAllValues(const RawImage& raw, const FileBytes& file) {
  const std::uint64_t there = raw.storage.size() - raw.offset;
  if (there < raw.byteCount())
    file.fail(diagnostic("the file is cut off: its header promises %1 bytes of voxels, %2 are there",
                         raw.byteCount(), there));
}

void requireUsableGrid(const RawImage& raw, const FileBytes& file) {
  const Eigen::Affine3d& grid = raw.indexToLps;
  if (!grid.matrix().allFinite())
    file.fail(diagnostic("the directions, spacing or origin of its voxels are not finite"));
  const double edges = grid.linear().colwise().norm().prod();
  if (!(std::abs(grid.linear().determinant()) > kFlattest * edges))
    file.fail(diagnostic("the directions and spacing of its voxels enclose no volume"));
  const Vec3 last = grid * Vec3(raw.size[0], raw.size[1], raw.size[2]);
  if (last.norm() > kFarthestVoxelMm || grid.translation().norm() > kFarthestVoxelMm)
    file.fail(diagnostic("its voxels are more than 1000 km away"));
}

Bounds boundsOfVoxels(const std::array<int, 3>& size, const Eigen::Affine3d& indexToLps) {
  Points corners(8, 3);
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index = Vec3::Constant(-0.5);
    for (int axis = 0; axis < 3; ++axis)
      if ((corner >> axis & 1) != 0)
        index[axis] = size[static_cast<std::size_t>(axis)] - 0.5;
    corners.row(corner) = (indexToLps * index).transpose();
  }
  return boundsOf(corners);
}

void storeLayers(const std::vector<LabelLayer>& layers, RawImage& raw) {
  raw.layers = static_cast<int>(layers.size());
  raw.scalar = Scalar::uint16;
  raw.order = std::endian::native;
  raw.storage.reserve(static_cast<std::size_t>(raw.byteCount()));
  for (const LabelLayer& layer : layers)
    layer.visit([&](const auto& voxels) {
      for (const std::uint16_t number : voxels)
        raw.storage.append(reinterpret_cast<const char*>(&number), sizeof number);
    });
}

} // namespace viscera::medical_io
