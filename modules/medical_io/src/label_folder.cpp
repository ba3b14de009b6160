#include <algorithm>
#include <utility>

#include "file_bytes.h"
#include "image_formats/raw_image.h"
#include "label_segments.h"
#include "viscera/core/error.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/medical_io/label_map.h"

namespace viscera::medical_io {
namespace {

/// Grids of masks of one patient are the same up to rounding.
constexpr double kSameGridVoxels = 0.01;
constexpr std::size_t kMostMasks = 2000;
constexpr int kMostAtATime = 8; ///< Masks in memory.

/// Voxels in a file of their own come with their header.
bool isHalfOfAnother(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  return extension == ".img" || extension == ".img.gz";
}

std::vector<std::filesystem::path> masksIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (std::error_code ignored;
        entry->is_regular_file(ignored) && isLabelMap(entry->path()) && !isHalfOfAnother(entry->path()))
      files.push_back(entry->path());
  if (error)
    throw NoInputError(phrase("It cannot be opened: %1", error.message()), folder.string(),
                       "check that you may read it");
  if (files.empty())
    throw DataError("It holds no label map", folder.string(),
                    "name a folder with one mask for each organ, such as liver.nii.gz");
  if (files.size() > kMostMasks)
    throw DataError(phrase("It holds more than %1 masks", kMostMasks), folder.string(),
                    "name the folder of one patient");
  std::sort(files.begin(), files.end());
  return files;
}

bool sameGrid(const LabelMap& a, const LabelMap& b) {
  if (a.size != b.size)
    return false;
  const Eigen::Affine3d between = a.indexToLps.inverse() * b.indexToLps;
  const Vec3 last(a.size[0] - 1, a.size[1] - 1, a.size[2] - 1);
  return (between * Vec3::Zero()).norm() < kSameGridVoxels &&
         (between * last - last).norm() < kSameGridVoxels &&
         (between.linear() - Eigen::Matrix3d::Identity()).norm() * last.norm() < kSameGridVoxels;
}

/// Puts the masks of one patient together.
class Patient {
public:
  void add(const std::filesystem::path& file, LabelMap mask) {
    if (mask.segments.size() > 1)
      throw DataError(phrase("It has %1 labels; a mask in a folder has one", mask.segments.size()),
                      file.string(), "open it by itself, or remove it from the folder");
    if (map_.layers.empty()) {
      map_.size = mask.size;
      map_.indexToLps = mask.indexToLps;
      map_.space = mask.space;
      map_.warnings = mask.warnings;
    } else if (!sameGrid(map_, mask)) {
      throw DataError("its voxels lie elsewhere than those of the other masks", file.string(),
                      "put masks of one image into a folder of their own");
    }
    const Segment& only = mask.segments.front();
    Segment& segment = map_.segments.emplace_back(only);
    segment.label = static_cast<std::int64_t>(map_.segments.size());
    segment.layer = addToFreeLayer(map_.layers, mask.layers.at(static_cast<std::size_t>(only.layer)),
                                   static_cast<std::uint16_t>(map_.segments.size()));
    segment.named = true;
    segment.name = toUtf8(stemOf(file));
    segment.colored = false;
  }

  void addEmpty(const std::filesystem::path& file) { empty_.push_back(toUtf8(stemOf(file))); }

  LabelMap take(const std::filesystem::path& folder) {
    if (map_.segments.empty())
      throw DataError("It holds only empty masks", folder.string(), "check that the segmentation was saved");
    if (!empty_.empty())
      map_.warnings.push_back(phrase("%n {mask is|masks are} empty (%2)", empty_.size(),
                                     empty_.front() + (empty_.size() > 1 ? ", ..." : "")));
    completeSegments(map_);
    return std::move(map_);
  }

private:
  LabelMap map_;
  std::vector<std::string> empty_;
};

} // namespace

LabelMap readLabelFolder(const std::filesystem::path& folder, Progress& progress) {
  const std::vector<std::filesystem::path> files = masksIn(folder);
  Patient patient;
  // A few at a time: they are put together in the order of their names, and each takes memory for all its
  // voxels.
  const auto batch = static_cast<std::size_t>(std::min(Threads{}.resolved(), kMostAtATime));
  for (std::size_t begin = 0; begin < files.size(); begin += batch) {
    progress.report(static_cast<double>(begin) / static_cast<double>(files.size()),
                    files[begin].filename().string());
    progress.throwIfCancelled();
    std::vector<LabelMap> masks(std::min(batch, files.size() - begin));
    parallelRanges(static_cast<Eigen::Index>(masks.size()), 1, {}, [&](Eigen::Index at, Eigen::Index) {
      Progress quiet;
      masks[static_cast<std::size_t>(at)] = readLabelFile(files[begin + static_cast<std::size_t>(at)], quiet);
    });
    for (std::size_t i = 0; i < masks.size(); ++i) {
      if (masks[i].segments.empty())
        patient.addEmpty(files[begin + i]);
      else
        patient.add(files[begin + i], std::move(masks[i]));
    }
  }
  progress.report(1);
  return patient.take(folder);
}

} // namespace viscera::medical_io
