#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"

/// Writes label maps byte by byte, independently of the program's readers.
namespace viscera::tests {

/// Labels on a grid.
struct LabelImage {
  std::array<int, 3> size = {24, 20, 16};
  Eigen::Affine3d indexToLps = Eigen::Affine3d::Identity();
  std::vector<std::int16_t> voxels; ///< i fastest.

  std::int16_t& at(int i, int j, int k) {
    return voxels[(std::size_t(k) * std::size_t(size[1]) + std::size_t(j)) * std::size_t(size[0]) +
                  std::size_t(i)];
  }
  /// Gives the voxels from `low` to `high`, both included, a label.
  void fill(const Eigen::Vector3i& low, const Eigen::Vector3i& high, std::int16_t label) {
    for (int k = low.z(); k <= high.z(); ++k)
      for (int j = low.y(); j <= high.y(); ++j)
        for (int i = low.x(); i <= high.x(); ++i)
          at(i, j, k) = label;
  }
};

inline LabelImage emptyLabels(const std::array<int, 3>& size = {24, 20, 16}) {
  LabelImage image;
  image.size = size;
  image.voxels.assign(std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]), 0);
  return image;
}

/// A ball of `radius` voxels.
inline void addBall(LabelImage& image, const Vec3& center, double radius, std::int16_t label) {
  for (int k = 0; k < image.size[2]; ++k)
    for (int j = 0; j < image.size[1]; ++j)
      for (int i = 0; i < image.size[0]; ++i)
        if ((Vec3(i, j, k) - center).norm() <= radius)
          image.at(i, j, k) = label;
}

template <typename T>
void putBytes(std::string& bytes, std::size_t offset, T value) {
  std::memcpy(bytes.data() + offset, &value, sizeof value);
}

inline std::string voxelBytes(const std::vector<std::int16_t>& voxels) {
  return {reinterpret_cast<const char*>(voxels.data()), voxels.size() * sizeof(voxels[0])};
}

enum class NiftiForm { none, sform, qform, both };

/// NIfTI-1 in one file, as nifti1.h lays it out. The grid has to be without shear for a qform.
inline std::string niftiFile(const LabelImage& image, NiftiForm form = NiftiForm::sform,
                             const std::string& extension = {}) {
  std::string bytes(352, '\0');
  putBytes<std::int32_t>(bytes, 0, 348);
  putBytes<std::int16_t>(bytes, 40, 3);
  Eigen::Affine3d ras = Eigen::Scaling(-1.0, -1.0, 1.0) * image.indexToLps;
  const Vec3 spacing = ras.linear().colwise().norm();
  for (std::size_t d = 0; d < 7; ++d)
    putBytes<std::int16_t>(bytes, 42 + 2 * d, d < 3 ? std::int16_t(image.size[d]) : std::int16_t(1));
  const double handed = ras.linear().determinant() < 0 ? -1 : 1;
  putBytes<float>(bytes, 76, float(handed));
  for (int d = 0; d < 3; ++d)
    putBytes<float>(bytes, 80 + 4 * std::size_t(d), float(spacing[d]));
  putBytes<std::int16_t>(bytes, 70, 4);
  putBytes<std::int16_t>(bytes, 72, 16);
  putBytes<float>(bytes, 112, 1.0F);
  bytes[123] = 2; // mm
  if (form == NiftiForm::qform || form == NiftiForm::both) {
    Eigen::Matrix3d rotation = ras.linear() * spacing.cwiseInverse().asDiagonal();
    rotation.col(2) *= handed;
    Eigen::Quaterniond q(rotation);
    if (q.w() < 0)
      q.coeffs() *= -1;
    putBytes<std::int16_t>(bytes, 252, 1);
    for (std::size_t d = 0; d < 3; ++d) {
      putBytes<float>(bytes, 256 + 4 * d, float(q.vec()[int(d)]));
      putBytes<float>(bytes, 268 + 4 * d, float(ras.translation()[int(d)]));
    }
  }
  if (form == NiftiForm::sform || form == NiftiForm::both) {
    putBytes<std::int16_t>(bytes, 254, 1);
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 4; ++column)
        putBytes<float>(bytes, 280 + 16 * row + 4 * column, float(ras.matrix()(int(row), int(column))));
  }
  std::memcpy(bytes.data() + 344, "n+1", 4);
  if (!extension.empty()) {
    const std::size_t size = (extension.size() + 8 + 15) / 16 * 16;
    bytes[348] = 1;
    std::string block(size, '\0');
    putBytes<std::int32_t>(block, 0, std::int32_t(size));
    putBytes<std::int32_t>(block, 4, 30);
    std::memcpy(block.data() + 8, extension.data(), extension.size());
    bytes += block;
  }
  putBytes<float>(bytes, 108, float(bytes.size()));
  return bytes + voxelBytes(image.voxels);
}

/// The same in two files.
struct NiftiHalves {
  std::string header; ///< .hdr
  std::string voxels; ///< .img
};

inline NiftiHalves niftiHalves(const LabelImage& image, NiftiForm form = NiftiForm::sform,
                               const std::string& extension = {}) {
  NiftiHalves halves{niftiFile(image, form, extension), voxelBytes(image.voxels)};
  halves.header.resize(halves.header.size() - halves.voxels.size());
  std::memcpy(halves.header.data() + 344, "ni1", 4);
  putBytes<float>(halves.header, 108, 0.0F);
  return halves;
}

/// "(1,2,3)"
inline std::string nrrdVector(const Vec3& v) {
  std::ostringstream out;
  out.precision(17);
  out << '(' << v.x() << ',' << v.y() << ',' << v.z() << ')';
  return out.str();
}

/// What turns LPS into the axes that an NRRD file names.
inline Vec3 turnTo(const std::string& space) {
  return {space.starts_with("right") ? -1.0 : 1.0, space.find("anterior") != space.npos ? -1.0 : 1.0, 1.0};
}

/// An NRRD file with its voxels raw behind the header. `layers` > 0: a list axis of so many comes first, and
/// `image.voxels` holds as many values a voxel. `keys` are lines that end in line breaks.
inline std::string nrrdFile(const LabelImage& image, const std::string& space = "left-posterior-superior",
                            const std::string& keys = {}, int layers = 0) {
  const Eigen::Affine3d grid = Eigen::Scaling(turnTo(space)) * image.indexToLps;
  std::ostringstream out;
  out << "NRRD0004\n# a comment\ntype: short\ndimension: " << (layers > 0 ? 4 : 3) << "\nspace: " << space
      << "\nsizes:";
  if (layers > 0)
    out << ' ' << layers;
  for (const int n : image.size)
    out << ' ' << n;
  out << "\nspace directions:" << (layers > 0 ? " none" : "");
  for (int axis = 0; axis < 3; ++axis)
    out << ' ' << nrrdVector(grid.linear().col(axis));
  out << "\nkinds:" << (layers > 0 ? " list" : "") << " domain domain domain\nendian: little\nencoding: raw\n"
      << "space origin: " << nrrdVector(grid.translation()) << '\n'
      << keys << '\n';
  return out.str() + voxelBytes(image.voxels);
}

/// The header of a MetaImage; ends with the line that names `data`.
inline std::string metaImageHeader(const LabelImage& image, const std::string& data) {
  std::ostringstream out;
  out.precision(17);
  const Vec3 spacing = image.indexToLps.linear().colwise().norm();
  out << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
      << "CompressedData = False\nTransformMatrix =";
  for (int axis = 0; axis < 3; ++axis)
    for (int row = 0; row < 3; ++row)
      out << ' ' << image.indexToLps.linear()(row, axis) / spacing[axis];
  const Vec3& origin = image.indexToLps.translation();
  out << "\nOffset = " << origin.x() << ' ' << origin.y() << ' ' << origin.z()
      << "\nCenterOfRotation = 0 0 0\nElementSpacing = " << spacing.x() << ' ' << spacing.y() << ' '
      << spacing.z() << "\nDimSize = " << image.size[0] << ' ' << image.size[1] << ' ' << image.size[2]
      << "\nElementType = MET_SHORT\nElementDataFile = " << data << '\n';
  return out.str();
}

inline std::string metaImageFile(const LabelImage& image) {
  return metaImageHeader(image, "LOCAL") + voxelBytes(image.voxels);
}

} // namespace viscera::tests
