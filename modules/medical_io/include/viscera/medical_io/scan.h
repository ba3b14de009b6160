#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"

/// Reads scans: images whose voxels are measured values, such as a CT or an MR.
namespace viscera::medical_io {

/// A level and a width of values, as a display maps them to black and white.
struct ValueWindow {
  double level = 40;  ///< The value that is drawn middle grey.
  double width = 400; ///< From black to white; positive.
};

/// Something doubtful in the files of a scan, and where.
struct ScanFinding {
  enum class Kind {
    missingSlice,
    doubledSlice,
    unevenSpacing,
    tilt,
    order,
    mixedSizes,
    damaged,
    other,
    partRead, ///< Slices of the series are left out; first in the list, as is the next.
    resampled ///< All slices, on an even grid that was made from them.
  };
  Kind kind = Kind::other;
  Text sentence; ///< What, where, and what was done about it.
};

/// A scan read from its files: the stored samples, in one block of memory, and their meaning. It does not
/// change after reading; several threads may read it.
///
///     Progress progress;
///     const Scan scan = readScan("ct.nii.gz", {}, progress);
///     const std::optional<double> hu = scan.at(Vec3(12, -40, 310));
struct Scan {
  /// The samples of voxels (i, j, k), i fastest, as the file stores them.
  using Samples = std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                               std::vector<std::uint16_t>, std::vector<std::int32_t>,
                               std::vector<std::uint32_t>, std::vector<float>>;

  std::array<int, 3> size = {}; ///< Voxels along i, j and k.
  /// Maps (i, j, k) to mm LPS; the centre of the first voxel is (0, 0, 0). May be oblique, left-handed and
  /// sheared (a tilted gantry); never singular.
  Eigen::Affine3d indexToLps = Eigen::Affine3d::Identity();
  Samples samples;
  double slope = 1;                  ///< Value = slope * sample + intercept.
  double intercept = 0;              ///< See `slope`.
  std::optional<double> padding;     ///< The sample that marks voxels without a measurement.
  std::string modality;              ///< "CT", "MR", "PT", ...; empty when the file does not say.
  std::string unit;                  ///< "HU" for a CT; else empty.
  std::string description;           ///< Of the series; empty when the file does not say.
  std::string patientName;           ///< DICOM: "Doe, Jane"; else empty. Written to reports only.
  std::string studyDate;             ///< DICOM: "20240301", year, month and day; else empty. The same.
  std::string space;                 ///< "RAS" or "LPS" (or another): what the file was written in.
  std::string transferSyntax;        ///< DICOM: how the pixels were packed, in words; else empty.
  std::vector<double> phaseTimesMs;  ///< Times of all phases of the series; empty for one.
  int phase = 0;                     ///< Which of them this is.
  std::optional<ValueWindow> window; ///< What the file proposes.
  std::vector<ScanFinding> findings; ///< Doubts about the files, one sentence each.

  std::size_t voxelCount() const {
    return std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]);
  }
  std::size_t indexOf(int i, int j, int k) const {
    return (std::size_t(k) * std::size_t(size[1]) + std::size_t(j)) * std::size_t(size[0]) + std::size_t(i);
  }
  /// Distance of neighbouring voxels along i, j and k, mm.
  Vec3 spacing() const { return indexToLps.linear().colwise().norm(); }
  /// The box, in mm LPS, around the voxels (not only their centres) of the whole image.
  Bounds bounds() const;
  /// The value of a voxel.
  double value(int i, int j, int k) const;
  /// The trilinear value at a point in mm LPS; none outside of the voxels' centres by more than half a voxel,
  /// and none in padding. O(1).
  std::optional<double> at(const Vec3& lps) const;
  /// Least and largest value, padding left out. O(voxels), on all threads.
  std::array<double, 2> range() const;
  /// The initial level and width: those that the file proposes; soft tissue (40 / 400) for a CT; else the 1st
  /// and the 99th percentile. O(voxels).
  ValueWindow firstWindow() const;
};

/// The slices of a series that are read, counted from 1 on in the order of their places.
struct SliceRange {
  int first = 1;          ///< The first that is read.
  int last = 1;           ///< The last one.
  int all = 1;            ///< As many as there are.
  bool resampled = false; ///< All of them, on an even grid that is made from them.
};

/// One of several series (or phases, echoes, or even parts of uneven slices) in a folder, for the user to
/// choose from.
struct ScanSeries {
  std::string id;                                           ///< Value for `ScanOptions::series`.
  std::string description;                                  ///< "Abdomen 5.0 B30f".
  std::string modality;                                     ///< "CT".
  std::array<int, 3> size = {};                             ///< Voxels.
  Vec3 spacing = Vec3::Zero();                              ///< mm.
  Eigen::Affine3d indexToLps = Eigen::Affine3d::Identity(); ///< As `Scan::indexToLps`.
  int phases = 1;                                           ///< The number of volumes over time.
  SliceRange slices;                                        ///< Of a DICOM series; else of one slice.
  std::string frameOfReference; ///< DICOM: UID of the coordinate system that images of one patient share.
  std::vector<std::filesystem::path> files;
};

/// The series and the phase to read; by default the largest series and its first phase. Of slices that are
/// not even the longest even part is read; "@2" behind the series, or alone for the largest one, is the next
/// even part, and "@all" all slices resampled to one even grid.
struct ScanOptions {
  std::string series;
  int phase = 0;
};

/// The series at a place: those of a DICOM folder (or of the folder that a DICOM file lies in), largest
/// first; one for a DICOM segmentation, which states its size and place, and for another format. Reads
/// headers only. Throws as `readScan`.
std::vector<ScanSeries> listScans(const std::filesystem::path& fileOrFolder, Progress& progress);

/// Reads NIfTI, NRRD, MetaImage or a DICOM series (a folder, or any file of it; classic or enhanced). Nothing
/// is resampled unless `options` ask for it; doubts are listed in `findings`. Throws `NoInputError`,
/// `DataError` (what, which file, what to try), `UsageError` for a series or phase that is not there,
/// `Cancelled`. Takes memory for what is in the files, not for what a header promises. O(voxels).
Scan readScan(const std::filesystem::path& fileOrFolder, const ScanOptions& options, Progress& progress);

/// Whether the place may hold a scan, by names and first bytes; only reading checks whether the files are
/// valid.
bool isScan(const std::filesystem::path& fileOrFolder);

} // namespace viscera::medical_io
