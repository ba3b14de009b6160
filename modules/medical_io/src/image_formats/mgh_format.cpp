#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "image_formats/data_file.h"
#include "image_formats/image_marks.h"
#include "image_formats/raw_image.h"
#include "viscera/core/phrase.h"

/// FreeSurfer's volumes: .mgh, packed .mgz (freesurfer.net/fswiki/FsTutorial/MghFormat); big-endian.
namespace viscera::medical_io {
namespace {

constexpr std::size_t kMghHeaderBytes = 284;
// Where the fields are.
constexpr std::size_t kMghFrames = 16, kMghType = 20, kMghPlaced = 28, kMghSpacing = 30, kMghDirections = 42,
                      kMghMiddle = 78;

constexpr std::array<std::pair<std::int32_t, Scalar>, 5> kMghTypes = {
    {{0, Scalar::uint8}, {1, Scalar::int32}, {3, Scalar::float32}, {4, Scalar::int16}, {10, Scalar::uint16}}};

Scalar scalarOfMgh(const FileBytes& file, std::int32_t type) {
  if (const auto scalar = lookUp(kMghTypes, type))
    return *scalar;
  file.fail(phrase("its voxels are no plain numbers (%1)", "type " + std::to_string(type)),
            "save it with one value per voxel");
}

std::int32_t numberAt(const FileBytes& file, std::size_t place) {
  return loadValue<std::int32_t>(file.view().data() + place, std::endian::big);
}

/// Three numbers in single precision.
Vec3 vectorAt(const FileBytes& file, std::size_t place) {
  Vec3 vector;
  for (std::size_t i = 0; i < 3; ++i)
    vector[static_cast<int>(i)] =
        double(loadValue<float>(file.view().data() + place + sizeof(float) * i, std::endian::big));
  return vector;
}

/// The header states directions, the sizes of voxels and the point in the middle of the volume, in RAS.
void readMghGrid(const FileBytes& file, RawImage& raw) {
  Vec3 spacing = vectorAt(file, kMghSpacing), middle = vectorAt(file, kMghMiddle);
  Eigen::Matrix3d directions;
  for (int axis = 0; axis < 3; ++axis)
    directions.col(axis) =
        vectorAt(file, kMghDirections + 3 * sizeof(float) * static_cast<std::size_t>(axis));
  if (loadValue<std::int16_t>(file.view().data() + kMghPlaced, std::endian::big) <= 0) {
    // FreeSurfer's own assumption.
    raw.warnings.push_back(
        "it does not say where it lies; coronal slices of 1 mm are assumed, as FreeSurfer does");
    spacing.setOnes();
    middle.setZero();
    directions << -1, 0, 0, 0, 0, 1, 0, -1, 0;
  }
  Eigen::Affine3d ras = Eigen::Affine3d::Identity();
  ras.linear() = directions * spacing.asDiagonal();
  ras.translation() = middle - ras.linear() * (0.5 * Vec3(raw.size[0], raw.size[1], raw.size[2]));
  raw.indexToLps = Eigen::Scaling(-1.0, -1.0, 1.0) * ras;
  raw.indexToLps.makeAffine();
  raw.space = "RAS";
}

ImageHeader mghHeaderOf(const FileBytes& file) {
  if (file.bytes.size() < kMghHeaderBytes)
    file.fail(diagnostic("the file is cut off: it has %n {byte|bytes}, its header alone has %2",
                         file.bytes.size(), kMghHeaderBytes));
  if (numberAt(file, 0) != 1)
    file.fail(diagnostic("It is not a volume of FreeSurfer: it has no version 1"),
              "check what the file is and where it came from");
  ImageHeader header;
  RawImage& raw = header.image;
  for (std::size_t axis = 0; axis < 3; ++axis)
    raw.size[axis] = axisSize(file, numberAt(file, 4 * (axis + 1)), std::string_view("ijk").substr(axis, 1));
  raw.layers = axisSize(file, numberAt(file, kMghFrames), "the volumes");
  raw.overTime = raw.layers > 1;
  raw.scalar = scalarOfMgh(file, numberAt(file, kMghType));
  raw.order = std::endian::big;
  readMghGrid(file, raw);
  header.stored.headerEnd = kMghHeaderBytes;
  return header;
}

} // namespace

bool hasMghMark(std::string_view bytes) {
  if (bytes.size() < kMghHeaderBytes)
    return false;
  const auto number = [&](std::size_t index) {
    return loadValue<std::int32_t>(bytes.data() + 4 * index, std::endian::big);
  };
  const auto isSize = [&](std::size_t index) { return number(index) > 0 && number(index) <= 65535; };
  return number(0) == 1 && isSize(1) && isSize(2) && isSize(3) && isSize(4) && lookUp(kMghTypes, number(5));
}

ImageHeader mghHeader(FileBytes& file) {
  return headerBehindGzip(file, mghHeaderOf);
}

} // namespace viscera::medical_io
