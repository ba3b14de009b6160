#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/medical_io/scan.h"

class DcmFileFormat;

/// Reads the headers of DICOM files, by DCMTK, without their pixels.
namespace viscera::medical_io {

/// How pixel values are stored; the same for all frames of a file.
struct DicomPixelFormat {
  int allocated = 16; ///< Bits a pixel takes: 8, 16, 32; 1 for a segmentation.
  int stored = 16;    ///< Bits of them that count ...
  int high = 15;      ///< ... of which this is the highest.
  bool isSigned = false;
  /// Stored values from the first to the second are no measurement.
  std::optional<std::array<std::int64_t, 2>> padding;

  bool operator==(const DicomPixelFormat&) const = default;
};

/// One image: a slice at a place, of a phase.
struct DicomFrame {
  std::size_t file = 0;                             ///< In the list of headers.
  int frame = 0;                                    ///< In the file.
  Vec3 position = Vec3::Zero();                     ///< Of the first pixel's centre, mm LPS.
  Vec3 row = Vec3::UnitX(), column = Vec3::UnitY(); ///< Unit vectors along a row and along a column.
  double betweenColumns = 1, betweenRows = 1;       ///< mm: the steps along a row and along a column.
  double betweenSlices = 0;                         ///< As stated in the file, mm; 0: not stated.
  double thickness = 0;                             ///< The same, or else the thickness of a slice.
  double sliceThickness = 0;                        ///< Of the slice itself, mm; 0: not stated.
  double slope = 1, intercept = 0;
  std::optional<double> temporalPosition, triggerMs, percent, acquisitionSeconds;
  std::optional<double> intervalMs; ///< From one R wave to the next.
  std::int64_t instance = 0;        ///< Its number in the series.
  std::string echo;                 ///< Identifies the echo.
  std::string uid;                  ///< Of the image; with the frame's number for a file of several.
  int segment = 0;                  ///< Of a segmentation: which one it is a slice of; 0: not stated.

  Vec3 normal() const { return row.cross(column).normalized(); }
};

/// A file with one frame or more.
struct DicomHeader {
  std::filesystem::path file;
  std::string classUid, instanceUid, frameOfReference;
  std::string seriesUid, description, modality, transferSyntax;
  std::string patientName, studyDate; ///< As `Scan` has them.
  std::string patientId, studyUid;
  std::string seriesDate; ///< "20240301"; empty: not stated.
  std::optional<double> heightM, weightKg; ///< Of the patient, as stated.
  int seriesNumber = 0;
  int cardiacImages = 0; ///< Phases of a cycle, as stated; 0: not stated.
  bool packed = false;   ///< Pixels are compressed.
  std::string rescaleType;
  int columns = 0, rows = 0;
  DicomPixelFormat format;
  std::optional<ValueWindow> window;
  std::optional<double> temporalResolutionMs;
  std::vector<DicomFrame> frames; ///< `file` is not set.
  Text assumed;                   ///< What it does not say, and what is taken instead; mostly empty.
  Text notAScan;                  ///< Why it has no frames that could be slices: "is a colour image".
};

/// Reads the header of a loaded file; of a segmentation also the number of the segment of each frame. Throws
/// `DataError` for a damaged one.
DicomHeader dicomHeaderOf(const std::filesystem::path& file, DcmFileFormat& format);

/// Reads one. Throws `DataError` for a damaged file, `NoInputError`.
DicomHeader readDicomHeader(const std::filesystem::path& file);

/// What can still be read of a damaged file before its pixels: whose it is, and its first frame, if any. Does
/// not throw.
DicomHeader remainsOfDicomHeader(const std::filesystem::path& file);

/// The headers of several files, one for each; of a damaged one only its name and an error.
struct FolderHeaders {
  std::vector<std::filesystem::path> files;
  std::vector<DicomHeader> headers;
  std::vector<std::optional<DataError>> errors;
};

/// Reads the headers on several threads; progress runs from 0 to `until`. Throws `NoInputError`, `Cancelled`.
FolderHeaders readDicomHeaders(std::vector<std::filesystem::path> files, Progress& progress, double until);

} // namespace viscera::medical_io
