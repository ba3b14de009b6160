#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <variant>

#include "viscera/core/progress.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/scan.h"

/// Writes scans and label maps, and distinguishes image files of the two kinds.
namespace viscera::medical_io {

/// Writes a scan as NIfTI (.nii, .nii.gz) or NRRD (.nrrd), little-endian, with its samples as they are.
/// NIfTI keeps slope and intercept; NRRD knows none, so there values are written: as whole numbers of 16 or
/// 32 bits where slope and intercept are whole, else as 32-bit fractions. Position, directions and shear are
/// kept (NIfTI: in 32-bit fractions, as an sform in RAS). Atomic. No names, dates or other texts of a patient
/// are written. Throws `CannotCreateError`, also for another ending; `DataError` for a side above 32767
/// voxels in NIfTI. O(voxels).
void writeScan(const std::filesystem::path& file, const Scan& scan);

/// Writes a label map in the same way, with the labels that its file had; NRRD (.seg.nrrd, .nrrd) with names
/// and colours as 3D Slicer keeps them, and all layers; NIfTI has one layer: of several the first with a
/// label counts. Throws as `writeScan`, and `DataError` for two segments of one label in NIfTI.
void writeLabelMap(const std::filesystem::path& file, const LabelMap& map);

/// Writes one file over time: NIfTI with a fourth dimension, or a sequence of 3D Slicer (.seq.nrrd), phases
/// being `intervalMs` apart. All phases have one grid and one type of samples, without slope. Throws as
/// `writeScan`, and `DataError` for others and for none. Memory: all samples once more. O(voxels x phases).
void writeScanSeries(const std::filesystem::path& file, std::span<const Scan> phases, double intervalMs);
/// The same of label maps of one grid, of the first of their layers with a label; names and colours, which
/// NRRD keeps, are those of the first. Throws as `writeLabelMap`, and `DataError` for labels above 32767.
void writeLabelSeries(const std::filesystem::path& file, std::span<const LabelMap> phases, double intervalMs);

/// The meaning of the voxels of an image file.
enum class ImageContents { values, labels };

/// Tells a scan from a label map: by its kind for DICOM, by its name for .seg.nrrd; else by the values of the
/// first phase, which are probably labels where they are whole up to rounding, none is below zero, and they
/// are few (eight) or mostly equal to their neighbours. A file that names segments is a label map. Reads the
/// file, and keeps none of its voxels. Throws as `readScan`.
ImageContents imageContents(const std::filesystem::path& fileOrFolder, Progress& progress);

/// What an image file holds.
using ScanOrLabels = std::variant<Scan, LabelMap>;

/// Reads an image as what it holds (`imageContents`), with one reading of its bytes and one unpacking;
/// `options` are for a scan, of which another phase than the first is read again; `labelPhase` is for label
/// maps over time, of which none is read unless one is chosen. A label map takes one byte
/// a voxel, for more than 255 labels two. Throws as `readScan` and `readLabelMap`. O(voxels).
ScanOrLabels readScanOrLabels(const std::filesystem::path& fileOrFolder, const ScanOptions& options,
                              Progress& progress, std::optional<int> labelPhase = {});

} // namespace viscera::medical_io
