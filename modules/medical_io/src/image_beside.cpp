#include "viscera/medical_io/image_beside.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include "dicom/dicom_folder.h"
#include "dicom/dicom_mark.h"
#include "dicom/segmentation_source.h"
#include "viscera/core/error.h"

namespace viscera::medical_io {
namespace {

namespace fs = std::filesystem;

constexpr double kSamePlace = 0.1; ///< Of a voxel: centres that are nearer are the same.
/// So many files are looked at when the scan of a segmentation is searched for.
constexpr std::size_t kMostSearched = 20'000;

/// Whether the voxels of two images have the same size, number and places, for any order and direction of
/// their axes.
bool isOnSameGrid(const ScanSeries& a, const ScanSeries& b) {
  const Eigen::Affine3d toB = b.indexToLps.inverse() * a.indexToLps;
  std::array<int, 3> size = {}; // Of `a`, along the axes of `b`.
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 direction = toB.linear().col(axis).cwiseAbs();
    Eigen::Index along = 0;
    direction.maxCoeff(&along);
    size[std::size_t(along)] = a.size[std::size_t(axis)];
    if (!((direction - Vec3::Unit(along)).norm() <= kSamePlace))
      return false;
  }
  if (size != b.size)
    return false;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index;
    for (int axis = 0; axis < 3; ++axis)
      index[axis] = (corner >> axis & 1) != 0 ? a.size[std::size_t(axis)] - 1 : 0;
    const Vec3 there = toB * index;
    for (int axis = 0; axis < 3; ++axis) {
      const double last = b.size[std::size_t(axis)] - 1;
      if (!(std::min(std::abs(there[axis]), std::abs(there[axis] - last)) <= kSamePlace))
        return false;
    }
  }
  return true;
}

/// The entries of a folder in their order; none of one that cannot be read.
std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    entries.push_back(at->path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// A folder of masks is known by the first of them.
fs::path headOf(const fs::path& image) {
  std::error_code error;
  if (!fs::is_directory(image, error) || isScan(image))
    return image;
  for (const fs::path& entry : entriesOf(image))
    if (!fs::is_directory(entry, error) && isLabelMap(entry))
      return entry;
  return image;
}

/// The series there, the largest first; none when it cannot be read.
std::vector<ScanSeries> seriesIn(const fs::path& image, Progress& progress) {
  try {
    return listScans(headOf(image), progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    return {};
  }
}

/// The series that is read when this image is named; none when it cannot be read.
std::optional<ScanSeries> seriesAt(const fs::path& image, Progress& progress) {
  const std::vector<ScanSeries> all = seriesIn(image, progress);
  for (const ScanSeries& series : all)
    if (std::find(series.files.begin(), series.files.end(), image) != series.files.end())
      return series;
  return all.empty() ? std::nullopt : std::optional(all.front());
}

std::optional<SegmentationSource> segmentationAt(const fs::path& file) {
  try {
    return dicomKind(file) == DicomKind::segmentation ? std::optional(segmentationSource(file))
                                                      : std::nullopt;
  } catch (const Error&) {
    return std::nullopt;
  }
}

bool holds(const fs::path& image, ImageContents wanted, Progress& progress) {
  try {
    return imageContents(headOf(image), progress) == wanted;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    return false;
  }
}

std::size_t commonStart(const std::string& a, const std::string& b) {
  const auto ends = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(ends.first - a.begin());
}

/// Images beside this one, those with the likest names first.
std::vector<fs::path> candidatesFor(const fs::path& image, ImageContents wanted) {
  std::vector<fs::path> candidates;
  bool hasSlice = false; // One file stands for all DICOM series of the folder.
  for (const fs::path& entry : entriesOf(image.parent_path())) {
    if (entry == image || !(wanted == ImageContents::values ? isScan(entry) : isLabelMap(entry)))
      continue;
    const bool isSlice = dicomKind(entry) == DicomKind::image;
    if (!isSlice || !hasSlice)
      candidates.push_back(entry);
    hasSlice = hasSlice || isSlice;
  }
  const std::string name = image.filename().string();
  std::stable_sort(candidates.begin(), candidates.end(), [&](const fs::path& a, const fs::path& b) {
    return commonStart(a.filename().string(), name) > commonStart(b.filename().string(), name);
  });
  candidates.resize(std::min(candidates.size(), kMostBeside));
  return candidates;
}

/// How to name a series so that it is read: its folder when that holds no other images, or one of its files.
fs::path placeOf(const ScanSeries& series, const fs::path& apartFrom) {
  const fs::path file = series.files.front(), folder = file.parent_path();
  if (folder == apartFrom)
    return file;
  bool alone = true;
  visitFiles(folder, [&](const fs::path& one) {
    alone = std::find(series.files.begin(), series.files.end(), one) != series.files.end() ||
            dicomKind(one) != DicomKind::image;
    return alone;
  });
  return alone ? folder : file;
}

/// The DICOM files of a kind in a folder, in those below it, and then in those beside it, as studies are
/// exported: the images in one folder, their segmentation in the next.
std::vector<fs::path> dicomAround(const fs::path& folder, DicomKind kind, Progress& progress) {
  std::vector<fs::path> found;
  std::set<fs::path> seen;
  const auto search = [&](const fs::path& root) {
    std::vector<fs::path> here;
    visitFiles(root, [&](const fs::path& file) {
      progress.throwIfCancelled();
      if (seen.insert(file).second && dicomKind(file) == kind)
        here.push_back(file);
      return seen.size() < kMostSearched;
    });
    std::sort(here.begin(), here.end());
    found.insert(found.end(), here.begin(), here.end());
  };
  search(folder);
  std::error_code error;
  const fs::path parent = folder.parent_path();
  if (parent.has_relative_path() && parent != fs::temp_directory_path(error)) // Not the whole disk.
    search(parent);
  return found;
}

/// The series from which a segmentation was made.
std::optional<fs::path> scanOf(const SegmentationSource& segmentation, const fs::path& file,
                               Progress& progress) {
  std::set<fs::path> done; // Folders.
  for (const fs::path& image : dicomAround(file.parent_path(), DicomKind::image, progress)) {
    progress.throwIfCancelled();
    if (done.contains(image.parent_path()) || frameOfReferenceIn(image) != segmentation.frameOfReference)
      continue;
    done.insert(image.parent_path());
    for (const ScanSeries& series : seriesIn(image, progress))
      if (isMadeFrom(segmentation, series))
        return placeOf(series, file.parent_path());
  }
  return std::nullopt;
}

/// A segmentation that was made from a series.
std::optional<fs::path> segmentationOf(const ScanSeries& series, const fs::path& place, Progress& progress) {
  std::error_code error;
  const fs::path folder = fs::is_directory(place, error) ? place : place.parent_path();
  for (const fs::path& file : dicomAround(folder, DicomKind::segmentation, progress)) {
    progress.throwIfCancelled();
    const auto segmentation = segmentationAt(file);
    if (segmentation && isMadeFrom(*segmentation, series))
      return file;
  }
  return std::nullopt;
}

/// The place of the candidate's series on the grid of `own`; none when it has none. A DICOM segmentation says
/// itself whose it is.
std::optional<fs::path> matchAt(const fs::path& candidate, const ScanSeries& own, Progress& progress) {
  if (dicomKind(headOf(candidate)) == DicomKind::segmentation)
    return std::nullopt;
  const std::vector<ScanSeries> all = seriesIn(candidate, progress);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (isOnSameGrid(own, all[i]))
      return i == 0 ? candidate : all[i].files.front();
  return std::nullopt;
}

} // namespace

std::optional<fs::path> imageBeside(const fs::path& image, ImageContents wanted, Progress& progress) {
  std::error_code error;
  fs::path place = fs::absolute(image, error).lexically_normal();
  if (!place.has_filename())
    place = place.parent_path();
  if (const auto segmentation = segmentationAt(place))
    return wanted == ImageContents::values ? scanOf(*segmentation, place, progress) : std::nullopt;
  const auto own = seriesAt(place, progress);
  if (!own)
    return std::nullopt;
  if (wanted == ImageContents::labels && !own->frameOfReference.empty())
    if (auto found = segmentationOf(*own, place, progress))
      return found;
  if (own->files.size() > 1 && !fs::is_directory(place, error))
    place = place.parent_path(); // One of the files of a series.
  for (const fs::path& candidate : candidatesFor(place, wanted)) {
    progress.throwIfCancelled();
    const auto match = matchAt(candidate, *own, progress);
    if (match && holds(candidate, wanted, progress))
      return match;
  }
  return std::nullopt;
}

} // namespace viscera::medical_io
