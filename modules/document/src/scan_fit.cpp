#include "viscera/document/scan_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/document/scan_item.h"
#include "viscera/medical_io/label_map.h"

namespace viscera::document {
namespace {

/// Grids whose corners are farther apart, in voxels, are not the same.
constexpr double kSameVoxel = 0.01;
/// An organ of whose box less lies in the scan is outside.
constexpr double kInsidePart = 0.5;
constexpr std::size_t kNamed = 3;

/// Says the voxels and the middle of all of them.
Text described(const std::array<int, 3>& size, const Eigen::Affine3d& indexToLps) {
  const Vec3 spacing = indexToLps.linear().colwise().norm();
  const Vec3 middle = indexToLps * (0.5 * Vec3(size[0] - 1, size[1] - 1, size[2] - 1));
  return phrase("%1 x %2 x %3 voxels of %4 x %5 x %6 mm around %7, %8, %9", size[0], size[1], size[2],
                inDigits(spacing.x()), inDigits(spacing.y()), inDigits(spacing.z()), inFixed(middle.x(), 1),
                inFixed(middle.y(), 1), inFixed(middle.z(), 1));
}

/// Whether both have the same voxels, whatever the order of axes in their files and the ends at which these
/// begin.
bool isSameGrid(const medical_io::ScanSeries& grid, const medical_io::Scan& scan) {
  const Eigen::Affine3d toScan = scan.indexToLps.inverse() * grid.indexToLps;
  std::array<bool, 3> met{};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Vec3 step = toScan.linear().col(axis);
    Eigen::Index along = 0;
    step.cwiseAbs().maxCoeff(&along);
    const int count = grid.size[static_cast<std::size_t>(axis)];
    const Vec3 off = step - (step[along] > 0 ? 1 : -1) * Vec3::Unit(along);
    if (std::exchange(met[static_cast<std::size_t>(along)], true) || count * off.norm() > kSameVoxel ||
        count != scan.size[static_cast<std::size_t>(along)])
      return false;
  }
  const Vec3 first = toScan.translation(); // A corner of the scan.
  for (Eigen::Index k = 0; k < 3; ++k)
    if (std::min(std::abs(first[k]), std::abs(first[k] - (scan.size[static_cast<std::size_t>(k)] - 1))) >
        kSameVoxel)
      return false;
  return true;
}

/// Describes the grid of a label map, from its header, if it differs from the scan's; else empty, also if it
/// is not known. `known` caches the results.
Text otherGridOf(const std::filesystem::path& file, const medical_io::Scan& scan,
                 std::map<std::filesystem::path, Text>& known) {
  if (const auto found = known.find(file); found != known.end())
    return found->second;
  Text& other = known[file];
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) || !medical_io::isLabelMap(file))
    return other;
  try {
    Progress progress;
    const auto grids = medical_io::listScans(file, progress);
    if (grids.size() == 1 && !isSameGrid(grids.front(), scan))
      other = described(grids.front().size, grids.front().indexToLps);
  } catch (const Error&) {
    // A label map of a form that scans do not have (DICOM-SEG): nothing is known of its grid.
  }
  return other;
}

double volumeOf(const Bounds& box) {
  return (box.high - box.low).cwiseMax(0.0).prod();
}

bool isOutside(const Organ& organ, const Bounds& scan) {
  const Bounds own = boundsOf(organ.mesh->points);
  const Bounds common = {own.low.cwiseMax(scan.low), own.high.cwiseMin(scan.high)};
  return volumeOf(common) < kInsidePart * volumeOf(own);
}

/// "liver, spleen and 4 more".
Text shortList(const std::vector<std::string>& names) {
  std::vector<Text> first;
  for (std::size_t i = 0; i < std::min(kNamed, names.size()); ++i)
    first.push_back(named(names[i]));
  const Text list = listOf(first);
  return names.size() > kNamed ? phrase("%1 and %2 more", list, names.size() - kNamed) : list;
}

} // namespace

std::vector<Text> scanFit(const DocumentState& state) {
  std::vector<Text> sentences;
  if (!state.scan)
    return sentences;
  const medical_io::Scan& scan = *state.scan->scan;
  const Bounds box = scan.bounds();
  std::vector<std::string> otherGrid, outside;
  std::map<std::filesystem::path, Text> grids; // Those that are others than the scan's.
  Text grid;
  for (const auto& organ : *state.organs) {
    if (const Text other = otherGridOf(organ->file, scan, grids); !other.empty()) {
      otherGrid.push_back(organ->name);
      grid = other;
    }
    if (isOutside(*organ, box))
      outside.push_back(organ->name);
  }
  if (!otherGrid.empty())
    sentences.push_back(phrase("The label map of %1 has another grid (%2) than the scan (%3); each lies "
                               "where its file says, and nothing is resampled",
                               shortList(otherGrid), grid, described(scan.size, scan.indexToLps)));
  if (!outside.empty())
    sentences.push_back(phrase("%2 {lies|lie} outside of the scan; check whether both are of one patient and "
                               "their files agree on the axes (RAS or LPS)",
                               outside.size(), shortList(outside)));
  return sentences;
}

} // namespace viscera::document
