#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/medical_io/label_layer.h"

/// Reads label maps: images whose voxels hold the label of an organ.
namespace viscera::medical_io {

/// A segment of a label map: the label, name and colour of one organ.
struct Segment {
  std::int64_t label = 0;        ///< The value that its voxels have in the file; never 0.
  int layer = 0;                 ///< The layer of the map that it is in.
  std::string name;              ///< "liver"; "label 5" when nothing names it. No two segments have the same.
  bool named = false;            ///< Whether the file, or a table beside it, names it.
  Vec3 color = {0.8, 0.45, 0.4}; ///< Red green blue, 0 to 1; the usual colour of its tissue if the file has
                                 ///< none.
  bool colored = false;          ///< Whether the file, or a table beside it, colours it.
  std::int64_t voxels = 0;       ///< The number of its voxels, at least one.
  std::array<int, 3> low = {};   ///< Its first voxel in i, j and k ...
  std::array<int, 3> high = {};  ///< ... and its last.
};

/// A label map read from a file. Only labels of at least one voxel are segments.
struct LabelMap {
  std::array<int, 3> size = {}; ///< Voxels along i, j and k.
  /// Maps (i, j, k) to mm LPS; the centre of the first voxel is (0, 0, 0). May be oblique, left-handed and
  /// sheared; never singular.
  Eigen::Affine3d indexToLps = Eigen::Affine3d::Identity();
  /// Voxels hold 0 for no segment and s + 1 for `segments[s]`. Segments that overlap take several layers.
  std::vector<LabelLayer> layers;
  std::vector<Segment> segments;
  std::string space;                ///< "RAS" or "LPS" (or another): what the file was written in.
  std::vector<double> phaseTimesMs; ///< Of a series: times of all its phases, or their numbers; else empty.
  int phase = 0;                    ///< Which of them this is.
  std::vector<Text> warnings;       ///< Doubts and assumptions, one sentence each.

  std::size_t voxelCount() const {
    return std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]);
  }
  std::size_t indexOf(int i, int j, int k) const {
    return (std::size_t(k) * std::size_t(size[1]) + std::size_t(j)) * std::size_t(size[0]) + std::size_t(i);
  }
  /// Distance of neighbouring voxels along i, j and k, mm.
  Vec3 spacing() const { return indexToLps.linear().colwise().norm(); }
  double voxelVolumeMm3() const { return std::abs(indexToLps.linear().determinant()); }
  double volumeMl(const Segment& segment) const {
    return double(segment.voxels) * voxelVolumeMm3() / kMm3PerMl;
  }
  /// The box, in mm LPS, around the voxels (not only their centres) of the whole image.
  Bounds bounds() const;
};

/// Reads NIfTI and Analyze 7.5 (.nii, .hdr with .img by either name), NRRD (.nrrd, .seg.nrrd, .nhdr),
/// MetaImage (.mha, .mhd), volumes of FreeSurfer (.mgz, .mgh), GIPL (.gipl), each also packed by gzip, or
/// DICOM-SEG (.dcm); a folder goes to `readLabelFolder`. Position, orientation and spacing
/// are the file's: of a NIfTI file the sform, else the qform, else the spacing alone. Names and colours are
/// the file's (segments of .seg.nrrd, MITK and DICOM-SEG, TotalSegmentator's table within NIfTI), else those
/// of a colour table (.ctbl, .txt, .json) beside it; docs/file_formats.md says which. Values that a slope or
/// single precision bent are rounded, and a warning says by how much. `phase` chooses one of several maps
/// over time, from 0 on.
///
/// Throws `UsageError` for a phase that is not there, `DataError` for a series without one chosen, and
/// `NoInputError` when the file is missing or not readable, `DataError` naming file and reason when it is
/// empty, cut off, of another kind than its name says, has no labelled voxel, or holds an image and no labels
/// (fractions, negative values, more than `kMostLabels` different ones), `Cancelled`. Prints nothing, and
/// takes memory for what is in the file, not for what its header promises. O(voxels); may be called from
/// several threads.
LabelMap readLabelMap(const std::filesystem::path& file, Progress& progress, std::optional<int> phase = {});

/// Reads a folder with one mask for each organ, as TotalSegmentator writes it, as one map: `liver.nii.gz`
/// becomes the segment "liver" with the label 1, 2, ... in order of names; voxels of two masks lie in two
/// layers. Empty masks are left out with a warning. Files that are no label maps are passed over. Throws as
/// `readLabelMap`, and `DataError` for a folder without masks, for a mask on another grid than the first, and
/// for one with several labels.
LabelMap readLabelFolder(const std::filesystem::path& folder, Progress& progress);

/// Indices of the segments that `names` ask for, in the order of the map: by name (upper and lower case,
/// spaces and underscores are the same) or by label value; all for no names. Throws `UsageError` that lists
/// the available segments if one is missing. `where` names the map in it.
std::vector<std::size_t> segmentsNamed(const LabelMap& map, const std::vector<std::string>& names,
                                       const Text& where);

/// Whether the name ends like a label map's, or it is a DICOM segmentation of any name, or a folder that
/// holds such a file. Slices of a DICOM series are none: `isScan`. Of other formats the name does not tell a
/// label map from a scan: `imageContents` does. Only reading checks whether the file is valid.
bool isLabelMap(const std::filesystem::path& fileOrFolder);

/// More different values than any label map has: a file with so many is an image.
inline constexpr int kMostLabels = 2000;

} // namespace viscera::medical_io
