#include "image_formats/analyze_header.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "file_bytes.h"

namespace viscera::medical_io {
namespace {

constexpr std::size_t kAnalyzeBytes = 348;
// Where the fields are.
constexpr std::size_t kDim = 40, kDatatype = 70, kBits = 72, kPixdim = 76, kOrient = 252, kOriginator = 253,
                      kMagic = 344;

struct Orientation {
  std::string_view axes;
  std::array<int, 3> row; ///< The row of LPS along which i, j and k lead ...
  std::array<int, 3> sign;
};
/// Orientations by the number in `orient`: transverse, coronal, sagittal; then the same with j the other way.
constexpr std::array<Orientation, 6> kOrientations = {{{"LAS", {0, 1, 2}, {1, -1, 1}},
                                                       {"LSA", {0, 2, 1}, {1, 1, -1}},
                                                       {"ASL", {1, 2, 0}, {-1, 1, 1}},
                                                       {"LPS", {0, 1, 2}, {1, 1, 1}},
                                                       {"LIA", {0, 2, 1}, {1, -1, -1}},
                                                       {"AIL", {1, 2, 0}, {-1, -1, 1}}}};

/// A number, or a digit.
const Orientation& orientationOf(char orient) {
  const int number = orient >= '0' && orient <= '5' ? orient - '0' : orient;
  return kOrientations[number >= 0 && number < 6 ? static_cast<std::size_t>(number) : 0];
}

} // namespace

std::optional<std::endian> orderOfAnalyze(std::string_view bytes) {
  if (bytes.size() < kAnalyzeBytes || bytes[kMagic] == 'n')
    return std::nullopt;
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const auto dimensions = loadValue<std::int16_t>(bytes.data() + kDim, order);
    const auto bits = loadValue<std::int16_t>(bytes.data() + kBits, order);
    const auto datatype = loadValue<std::int16_t>(bytes.data() + kDatatype, order);
    if (loadValue<std::uint32_t>(bytes.data(), order) == kAnalyzeBytes && dimensions >= 1 &&
        dimensions <= 7 && datatype > 0 && bits >= 0)
      return order;
  }
  return std::nullopt;
}

AnalyzeGrid analyzeGrid(std::string_view bytes, std::endian order) {
  AnalyzeGrid grid;
  const Orientation& orientation = orientationOf(bytes[kOrient]);
  grid.axes = orientation.axes;
  grid.warnings.push_back(phrase("it is an Analyze 7.5 image, which does not say where it lies: its axes are "
                                 "taken as %1, and left and right may be exchanged",
                                 grid.axes));
  Vec3 origin = Vec3::Zero(); // SPM counts voxels from 1.
  bool hasOrigin = true, hasSizes = true;
  grid.indexToLps.linear().setZero();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto size = loadValue<std::int16_t>(bytes.data() + kDim + 2 * (axis + 1), order);
    const auto at = loadValue<std::int16_t>(bytes.data() + kOriginator + 2 * axis, order);
    const double stated = std::abs(double(loadValue<float>(bytes.data() + kPixdim + 4 * (axis + 1), order)));
    const bool usable = std::isfinite(stated) && stated > 0;
    hasSizes = hasSizes && usable;
    hasOrigin = hasOrigin && at >= 1 && at <= size;
    origin[static_cast<int>(axis)] = at - 1;
    grid.indexToLps.linear()(orientation.row[axis], static_cast<int>(axis)) =
        orientation.sign[axis] * (usable ? stated : 1);
  }
  if (hasOrigin)
    grid.indexToLps.translation() = -(grid.indexToLps.linear() * origin);
  if (!hasSizes)
    grid.warnings.push_back("it does not say how large its voxels are; 1 mm is assumed");
  return grid;
}

} // namespace viscera::medical_io
