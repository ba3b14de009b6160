#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "file_bytes.h"
#include "scalar.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_series.h"

namespace viscera::medical_io {

/// Name and colour of one segment as stated in a file.
struct StatedSegment {
  std::int64_t label = 0;
  int layer = 0;
  std::string name;          ///< Empty: the file does not say.
  std::optional<Vec3> color; ///< 0 to 1.
};

/// The times between the volumes of a file, as stated in it.
struct RawTimes {
  std::vector<double> values; ///< One a volume, in `unit`; empty: only `step` is known.
  double step = 0;            ///< Between two volumes, in `unit`; 0: not stated.
  std::string unit;           ///< "s", "ms", "us" or another; empty: not stated.
};

/// Seconds of a unit of time as files write it: "s", "ms", "msec"; 0 for another.
double secondsAUnit(std::string_view unit);

/// An image as read by a format's reader, before it is converted to a label map or a scan; the values are not
/// checked.
struct RawImage {
  std::array<int, 3> size = {};
  int layers = 1;
  bool layersFirst = false; ///< The layers' values lie beside each other, not one volume behind the other.
  std::string listKind;     ///< NRRD: of the axis that counts the layers, "list", "rgb-color"; may be empty.
  bool overTime = false;    ///< The layers are the phases of a series, and not parts of one image.
  Eigen::Affine3d indexToLps = Eigen::Affine3d::Identity();
  Scalar scalar = Scalar::uint8;
  std::endian order = std::endian::little;
  double slope = 1, intercept = 0; ///< value = slope * stored + intercept
  std::string storage;             ///< The values, from `offset` on.
  std::size_t offset = 0;
  std::vector<StatedSegment> stated;
  std::optional<RawTimes> times; ///< Of volumes that are phases, which stand in for layers.
  std::string space;
  std::vector<Text> warnings;

  std::uint64_t valueCount() const; ///< Of all layers; saturated.
  std::uint64_t byteCount() const;  ///< That the values should have; saturated.
  std::string_view values() const { return std::string_view(storage).substr(offset); }
};

/// The size of a grid axis as an int. Throws `DataError` when it is not positive or above 65535.
int axisSize(const FileBytes& file, std::int64_t size, std::string_view axis);

/// Throws `DataError` when `raw.storage` holds fewer bytes than the grid promises.
void requireAllValues(const RawImage& raw, const FileBytes& file);

/// Throws `DataError` when the matrix is not finite or singular, or the grid is larger than 1000 km.
void requireUsableGrid(const RawImage& raw, const FileBytes& file);

/// Parses with DCMTK; of a structure set fills the contours.
RawImage readDicomSegmentation(FileBytes& file);

/// Takes a phase of `count`.
using TakePhase = std::function<void(std::size_t phase, std::size_t count, RawImage&& image)>;

/// Reads a DICOM segmentation of several temporal positions, each as an image on the grid of all, and says
/// their times as far as the file states them. Throws `DataError` for one of a single instant, too.
std::vector<DicomPhase> readDicomSegmentations(const FileBytes& file, const TakePhase& take);

/// The contours of a DICOM RT Structure Set, filled on a grid of their own (`structureGrid`).
RawImage readStructureLabels(const FileBytes& file);

/// Makes layers of numbers the image's values.
void storeLayers(const std::vector<LabelLayer>& layers, RawImage& raw);

/// Reads as `readLabelMap`, of one file, but with only the names and colours that the file itself has, and
/// without segments when no voxel has a label.
LabelMap readLabelFile(const std::filesystem::path& file, Progress& progress);

/// Makes a label map from a raw image: checks grid and values, numbers labels, counts their voxels.
LabelMap labelMapOf(RawImage&& raw, const FileBytes& file, Progress& progress);

/// Takes names and colours from a table beside `file` where the file itself has none.
void nameByTable(LabelMap& map, const std::filesystem::path& file);

/// The box, in mm LPS, around the voxels (not only their centres) of an image.
Bounds boundsOfVoxels(const std::array<int, 3>& size, const Eigen::Affine3d& indexToLps);

} // namespace viscera::medical_io
