#include "viscera/medical_io/image_beside.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include "viscera/core/error.h"

namespace viscera::medical_io {
namespace {

namespace fs = std::filesystem;

constexpr double kSameVoxelSpacing = 1e-3; ///< Of the spacing.

/// The size and spacing that two images of one patient have in common, for any order and direction of their
/// axes.
struct Voxels {
  std::array<int, 3> size = {};
  Vec3 spacing = Vec3::Zero();

  bool agree(const Voxels& other) const {
    return size == other.size && (spacing - other.spacing).norm() <= kSameVoxelSpacing * spacing.norm();
  }
};

Voxels voxelsOf(const ScanSeries& series) {
  std::array<int, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const auto key = [&](int axis) {
      return std::pair(series.size[std::size_t(axis)], series.spacing[axis]);
    };
    return key(a) < key(b);
  });
  Voxels voxels;
  for (std::size_t k = 0; k < 3; ++k) {
    voxels.size[k] = series.size[std::size_t(order[k])];
    voxels.spacing[Eigen::Index(k)] = series.spacing[order[k]];
  }
  return voxels;
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

/// The largest series there; none when it cannot be read.
std::optional<ScanSeries> seriesAt(const fs::path& image, Progress& progress) {
  try {
    const std::vector<ScanSeries> all = listScans(headOf(image), progress);
    return all.empty() ? std::nullopt : std::optional(all.front());
  } catch (const Cancelled&) {
    throw;
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
  for (const fs::path& entry : entriesOf(image.parent_path()))
    if (entry != image && (wanted == ImageContents::values ? isScan(entry) : isLabelMap(entry)))
      candidates.push_back(entry);
  const std::string name = image.filename().string();
  std::stable_sort(candidates.begin(), candidates.end(), [&](const fs::path& a, const fs::path& b) {
    return commonStart(a.filename().string(), name) > commonStart(b.filename().string(), name);
  });
  candidates.resize(std::min(candidates.size(), kMostBeside));
  return candidates;
}

} // namespace

std::optional<fs::path> imageBeside(const fs::path& image, ImageContents wanted, Progress& progress) {
  std::error_code error;
  fs::path place = fs::absolute(image, error).lexically_normal();
  if (!place.has_filename())
    place = place.parent_path();
  const auto own = seriesAt(place, progress);
  if (!own)
    return std::nullopt;
  if (own->files.size() > 1 && !fs::is_directory(place, error))
    place = place.parent_path(); // One of the files of a series.
  for (const fs::path& candidate : candidatesFor(place, wanted)) {
    progress.throwIfCancelled();
    const auto other = seriesAt(candidate, progress);
    if (other && voxelsOf(*own).agree(voxelsOf(*other)) && holds(candidate, wanted, progress))
      return candidate;
  }
  return std::nullopt;
}

} // namespace viscera::medical_io
