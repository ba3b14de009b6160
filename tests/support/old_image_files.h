#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

#include "label_files.h"

/// Writes label maps of FreeSurfer, GIPL and Analyze 7.5 byte by byte, independently of the program's
/// readers.
namespace viscera::tests {

/// Appends a value, the most significant byte first or last.
template <typename T>
void appendIn(std::string& bytes, std::endian order, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof value);
  if (order != std::endian::native)
    std::reverse(std::begin(raw), std::end(raw));
  bytes.append(raw, sizeof(T));
}

template <typename T>
void appendVoxels(std::string& bytes, const LabelImage& image) {
  for (const std::int16_t voxel : image.voxels)
    appendIn(bytes, std::endian::big, static_cast<T>(voxel));
}

/// A volume of FreeSurfer (.mgh) of one of its types: 0 bytes, 1 integers, 3 fractions, 4 shorts, 10 shorts
/// without a sign.
inline std::string mghFile(const LabelImage& image, int type) {
  const Eigen::Affine3d ras = Eigen::Scaling(-1.0, -1.0, 1.0) * image.indexToLps;
  const Vec3 spacing = ras.linear().colwise().norm();
  const Vec3 middle = ras * (0.5 * Vec3(image.size[0], image.size[1], image.size[2]));
  std::string bytes;
  const auto number = [&](std::int32_t value) { appendIn(bytes, std::endian::big, value); };
  const auto fraction = [&](double value) { appendIn(bytes, std::endian::big, float(value)); };
  number(1);
  for (const int n : image.size)
    number(n);
  number(1);
  number(type);
  number(0);
  appendIn<std::int16_t>(bytes, std::endian::big, 1);
  for (int axis = 0; axis < 3; ++axis)
    fraction(spacing[axis]);
  for (int axis = 0; axis < 3; ++axis)
    for (int row = 0; row < 3; ++row)
      fraction(ras.linear()(row, axis) / spacing[axis]);
  for (int row = 0; row < 3; ++row)
    fraction(middle[row]);
  bytes.resize(284);
  switch (type) {
  case 0:
    appendVoxels<std::uint8_t>(bytes, image);
    break;
  case 1:
    appendVoxels<std::int32_t>(bytes, image);
    break;
  case 3:
    appendVoxels<float>(bytes, image);
    break;
  default:
    appendVoxels<std::int16_t>(bytes, image);
  }
  return bytes;
}

/// A GIPL file, whose axes are parallel to those of LPS.
inline std::string giplFile(const LabelImage& image, int type) {
  std::string bytes;
  for (const int n : image.size)
    appendIn(bytes, std::endian::big, static_cast<std::uint16_t>(n));
  appendIn<std::uint16_t>(bytes, std::endian::big, 1);
  appendIn(bytes, std::endian::big, static_cast<std::uint16_t>(type));
  for (int axis = 0; axis < 3; ++axis)
    appendIn(bytes, std::endian::big, float(image.indexToLps.linear()(axis, axis)));
  bytes.resize(204);
  for (int axis = 0; axis < 3; ++axis)
    appendIn(bytes, std::endian::big, double(image.indexToLps.translation()[axis]));
  bytes.resize(252);
  appendIn<std::uint32_t>(bytes, std::endian::big, 0xefffe9b0);
  switch (type) {
  case 8:
    appendVoxels<std::uint8_t>(bytes, image);
    break;
  case 31:
  case 32:
    appendVoxels<std::int32_t>(bytes, image);
    break;
  case 64:
    appendVoxels<float>(bytes, image);
    break;
  case 65:
    appendVoxels<double>(bytes, image);
    break;
  default:
    appendVoxels<std::int16_t>(bytes, image);
  }
  return bytes;
}

/// The header of an Analyze 7.5 image of shorts; the voxels are `voxelBytes` in the same order.
inline std::string analyzeHeader(const LabelImage& image, std::endian order = std::endian::little) {
  std::string bytes(348, '\0');
  const auto put = [&](std::size_t place, auto value) {
    std::string field;
    appendIn(field, order, value);
    bytes.replace(place, field.size(), field);
  };
  put(0, std::int32_t{348});
  put(32, std::int32_t{16384});
  bytes[38] = 'r';
  put(40, std::int16_t{4});
  put(48, std::int16_t{1});
  put(70, std::int16_t{4});
  put(72, std::int16_t{16});
  const Vec3 spacing = image.indexToLps.linear().colwise().norm();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put(42 + 2 * axis, static_cast<std::int16_t>(image.size[axis]));
    put(80 + 4 * axis, static_cast<float>(spacing[int(axis)]));
  }
  return bytes;
}

} // namespace viscera::tests
