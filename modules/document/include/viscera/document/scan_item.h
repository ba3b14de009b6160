#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "viscera/core/progress.h"
#include "viscera/document/command.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/scan.h"
#include "viscera/medical_io/scan_over_time.h"

namespace viscera::document {

/// The scan of the document: an image of the patient whose organs the document has. Immutable once in a
/// document, and shared by all states that have it. A session names its place, or holds it.
struct ScanItem {
  std::string name;                             ///< "CT, Abdomen 5.0", or its file's.
  std::shared_ptr<const medical_io::Scan> scan; ///< Never null.
  std::filesystem::path file; ///< Where it was read from: a file, or a folder of DICOM files; empty: nowhere.
  std::string series;         ///< Which of several there, as `medical_io::ScanOptions`.
  int phase = 0;              ///< Which of several in time.
  std::string hash = {};      ///< `scanHash` of what was read; empty: not known.
  /// All phases of the scan, of which `scan` is one; null for a scan of one instant.
  std::shared_ptr<const medical_io::ScanOverTime> time = {};
};

/// The volume of a scan that belongs to a fraction of its cycle: `scan` where it has one instant. Null where
/// the phase is damaged, or its file has changed. Decodes it where it is not kept. For any thread.
std::shared_ptr<const medical_io::Scan> scanAt(const ScanItem& item, double fraction);

/// Whether the document's images are over time: a cine study, or a scan of several phases.
bool hasImagesOverTime(const DocumentState& state);

/// The fraction of the cycle at which `scan` was taken; 0 for a scan of one instant.
double fractionOf(const ScanItem& item);

/// A hash of the grid, the samples and what values they stand for: 16 hexadecimal digits. O(voxels), on all
/// threads.
std::string scanHash(const medical_io::Scan& scan);

/// Whether two scans have the same contents to the last bit, wherever they are stored; nothing is equal to
/// nothing only. O(voxels) for two scans in different places.
bool identical(const std::shared_ptr<const ScanItem>& a, const std::shared_ptr<const ScanItem>& b);

/// Makes a scan of the document from one that was read, named by its modality and description, else by its
/// file.
ScanItem scanItem(medical_io::Scan scan, const std::filesystem::path& file,
                  const medical_io::ScanOptions& options = {});

/// Reads a scan for a document, with its hash and, of one over time, all of its phases, without accessing a
/// document. A damaged phase gives way to the next one. Throws what `medical_io::readScan` throws.
ScanItem openScanFile(const std::filesystem::path& file, const medical_io::ScanOptions& options,
                      Progress& progress);

/// A scan with its hash, or a label map.
using ScanItemOrLabels = std::variant<ScanItem, medical_io::LabelMap>;

/// Reads a file or folder that may be a scan, with all of its phases; none when it is something else. Image
/// formats hold scans and label maps alike: what looks like labels comes back as a label map, from the same
/// reading. None also for a file that cannot be read as a scan but may be a label map: who reads it as such
/// says what is wrong. Throws `NoInputError`, `DataError` for a scan that is damaged, `Cancelled`.
std::optional<ScanItemOrLabels> openImage(const std::filesystem::path& file, Progress& progress);

/// The phase of the label maps over time in `file` that belongs to the scan, which is itself one of as many
/// phases; none for any other file or scan. Reads headers. Throws as `medical_io::listScans`.
std::optional<int> phaseOfLabels(const std::filesystem::path& file, const ScanItem* scan, Progress& progress);

/// Opens a scan in the document, in place of the present one and of a cine study.
Command openScan(ScanItem item);

/// Removes the scan from the document. Throws `UsageError` when there is none.
Command closeScan();

} // namespace viscera::document
