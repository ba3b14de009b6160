#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "image_formats/data_file.h"
#include "image_formats/image_marks.h"
#include "image_formats/raw_image.h"
#include "viscera/core/phrase.h"

/// GIPL, the Guys Image Processing Lab's format (.gipl), as ITK reads it; big-endian.
namespace viscera::medical_io {
namespace {

constexpr std::size_t kGiplHeaderBytes = 256;
// Where the fields are.
constexpr std::size_t kGiplType = 8, kGiplSpacing = 10, kGiplOrigin = 204;

Scalar scalarOfGipl(const FileBytes& file, std::uint16_t type) {
  static constexpr std::array<std::pair<std::uint16_t, Scalar>, 8> kTypes = {{{7, Scalar::int8},
                                                                              {8, Scalar::uint8},
                                                                              {15, Scalar::int16},
                                                                              {16, Scalar::uint16},
                                                                              {31, Scalar::uint32},
                                                                              {32, Scalar::int32},
                                                                              {64, Scalar::float32},
                                                                              {65, Scalar::float64}}};
  if (const auto scalar = lookUp(kTypes, type))
    return *scalar;
  file.fail(phrase("its voxels are no plain numbers (%1)", "type " + std::to_string(type)),
            "save it with one value per voxel");
}

ImageHeader giplHeaderOf(const FileBytes& file) {
  const auto at = [&]<class T>(T, std::size_t place, std::size_t i) {
    return loadValue<T>(file.view().data() + place + sizeof(T) * i, std::endian::big);
  };
  if (file.bytes.size() < kGiplHeaderBytes)
    file.fail(diagnostic("the file is cut off: it has %n {byte|bytes}, its header alone has %2",
                         file.bytes.size(), kGiplHeaderBytes));
  if (!hasGiplMark(file.view()))
    file.fail(diagnostic("It is not a GIPL image: its mark is missing"),
              "check what the file is and where it came from");
  ImageHeader header;
  RawImage& raw = header.image;
  raw.indexToLps.linear().setZero();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int size = at(std::uint16_t{}, 0, axis), column = static_cast<int>(axis);
    // Images in two dimensions may say 0 for the third.
    raw.size[axis] =
        axisSize(file, axis < 2 ? size : std::max(size, 1), std::string_view("ijk").substr(axis, 1));
    raw.indexToLps.linear()(column, column) = double(at(float{}, kGiplSpacing, axis));
    raw.indexToLps.translation()[column] = at(double{}, kGiplOrigin, axis);
  }
  raw.layers = std::max<int>(at(std::uint16_t{}, 0, 3), 1);
  raw.overTime = raw.layers > 1;
  raw.scalar = scalarOfGipl(file, at(std::uint16_t{}, kGiplType, 0));
  raw.order = std::endian::big;
  raw.space = "LPS";
  raw.warnings.push_back("the file does not state its axes: LPS is assumed");
  header.stored.headerEnd = kGiplHeaderBytes;
  return header;
}

} // namespace

bool hasGiplMark(std::string_view bytes) {
  // Some programs write it one word too early.
  static constexpr std::array<std::size_t, 2> kPlaces = {252, 248};
  static constexpr std::array<std::uint32_t, 2> kMarks = {0xefffe9b0, 0x2ae389b8};
  return bytes.size() >= kGiplHeaderBytes &&
         std::any_of(kPlaces.begin(), kPlaces.end(), [&](std::size_t place) {
           const auto mark = loadValue<std::uint32_t>(bytes.data() + place, std::endian::big);
           return std::find(kMarks.begin(), kMarks.end(), mark) != kMarks.end();
         });
}

ImageHeader giplHeader(FileBytes& file) {
  return headerBehindGzip(file, giplHeaderOf);
}

} // namespace viscera::medical_io
