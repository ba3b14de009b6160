#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "file_bytes.h"
#include "viscera/medical_io/label_map.h"

namespace viscera::medical_io {

/// How a number is stored.
enum class Scalar { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// Bytes of one.
std::size_t sizeOf(Scalar scalar);

/// What a file says of one segment.
struct StatedSegment {
  std::int64_t label = 0;
  int layer = 0;
  std::string name;          ///< Empty: the file does not say.
  std::optional<Vec3> color; ///< 0 to 1.
};

/// What a file of several volumes says of the time between them.
struct RawTimes {
  std::vector<double> values; ///< One a volume, in `unit`; empty: only `step` is known.
  double step = 0;            ///< Between two volumes, in `unit`; 0: not stated.
  std::string unit;           ///< "s", "ms", "us" or another; empty: not stated.
};

/// What a format's reader found, before it is made a label map: the grid is checked, the values are not.
struct RawLabels {
  std::array<int, 3> size = {};
  int layers = 1;
  bool layersFirst = false; ///< The layers' values lie beside each other, not one volume behind the other.
  Eigen::Affine3d indexToLps = Eigen::Affine3d::Identity();
  Scalar scalar = Scalar::uint8;
  std::endian order = std::endian::little;
  double slope = 1, intercept = 0; ///< value = slope * stored + intercept
  std::string storage;             ///< The values, from `offset` on.
  std::size_t offset = 0;
  std::vector<StatedSegment> stated;
  std::optional<RawTimes> times; ///< Of volumes that are phases, which stand in for layers.
  std::string space;
  std::vector<std::string> warnings;

  std::uint64_t valueCount() const; ///< Of all layers; saturated.
  std::uint64_t byteCount() const;  ///< That the values should have; saturated.
  std::string_view values() const { return std::string_view(storage).substr(offset); }
};

/// The size of a grid axis as an int. Throws `DataError` when it is not positive or above 65535.
int axisSize(const FileBytes& file, std::int64_t size, std::string_view axis);

/// Throws `DataError` when `raw.storage` holds fewer bytes than the grid promises.
void requireAllValues(const RawLabels& raw, const FileBytes& file);

/// Throws `DataError` when the matrix is not finite or singular, or the grid is larger than 1000 km.
void requireUsableGrid(const RawLabels& raw, const FileBytes& file);

/// The readers, one a format. They may take the bytes out of `file`, but leave its name.
RawLabels readNifti(FileBytes& file);
/// The same for a file of several volumes, one a phase: they are the layers.
RawLabels readNiftiSeries(FileBytes& file);
RawLabels readNrrd(FileBytes& file);
RawLabels readMetaImage(FileBytes& file);
/// Parses with DCMTK.
RawLabels readDicomSegmentation(FileBytes& file);

} // namespace viscera::medical_io
