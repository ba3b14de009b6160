#include "voxel_pieces.h"

#include <algorithm>

#include "viscera/core/disjoint_sets.h"

namespace viscera::medical_io {
namespace {

/// Inside voxels beside each other in one row.
struct RowRun {
  int begin = 0;
  int end = 0;
};

/// Joins the runs of neighbouring rows into pieces.
class PieceFinder {
public:
  explicit PieceFinder(const VoxelBox& box) : box_(box) {
    for (std::size_t row = 0; row < rows(); ++row) {
      firstOfRow_.push_back(runs_.size());
      addRuns(row);
    }
    firstOfRow_.push_back(runs_.size());
    pieces_ = DisjointSets(runs_.size());
    const auto width = static_cast<std::size_t>(box_.size[1]);
    for (std::size_t row = 0; row < rows(); ++row) {
      if (row % width > 0)
        joinRows(row - 1, row);
      if (row >= width)
        joinRows(row - width, row);
    }
  }

  /// Voxels of the piece that every run is in, at the piece's first run; 0 at its others.
  std::vector<std::int64_t> sizes() {
    std::vector<std::int64_t> result(runs_.size(), 0);
    for (std::size_t run = 0; run < runs_.size(); ++run)
      result[pieces_.root(run)] += runs_[run].end - runs_[run].begin;
    return result;
  }

  void keepOnly(std::size_t piece, VoxelBox& box) {
    for (std::size_t row = 0; row < rows(); ++row)
      for (std::size_t run = firstOfRow_[row]; run < firstOfRow_[row + 1]; ++run)
        if (pieces_.root(run) != piece)
          std::fill_n(box.inside.begin() + begin(row) + runs_[run].begin, runs_[run].end - runs_[run].begin,
                      0);
  }

private:
  std::size_t rows() const {
    return static_cast<std::size_t>(box_.size[1]) * static_cast<std::size_t>(box_.size[2]);
  }
  std::ptrdiff_t begin(std::size_t row) const { return static_cast<std::ptrdiff_t>(row) * box_.size[0]; }

  void addRuns(std::size_t row) {
    const auto first = box_.inside.begin() + begin(row), last = first + box_.size[0];
    for (auto at = std::find(first, last, 1); at != last;) {
      const auto end = std::find(at, last, 0);
      runs_.push_back({static_cast<int>(at - first), static_cast<int>(end - first)});
      at = std::find(end, last, 1);
    }
  }

  void joinRows(std::size_t a, std::size_t b) {
    std::size_t i = firstOfRow_[a], j = firstOfRow_[b];
    while (i < firstOfRow_[a + 1] && j < firstOfRow_[b + 1]) {
      if (runs_[i].begin < runs_[j].end && runs_[j].begin < runs_[i].end)
        pieces_.join(i, j);
      runs_[i].end < runs_[j].end ? ++i : ++j;
    }
  }

  const VoxelBox& box_;
  std::vector<RowRun> runs_;
  std::vector<std::size_t> firstOfRow_;
  DisjointSets pieces_{0};
};

} // namespace

VoxelBox voxelsOf(const LabelMap& map, std::size_t segment) {
  const Segment& from = map.segments[segment];
  const LabelLayer& layer = map.layers[static_cast<std::size_t>(from.layer)];
  const auto number = static_cast<std::uint16_t>(segment + 1);
  VoxelBox box;
  std::size_t voxels = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = from.low[axis] - 1;
    box.size[axis] = from.high[axis] - from.low[axis] + 3;
    voxels *= static_cast<std::size_t>(box.size[axis]);
  }
  box.inside.assign(voxels, 0);
  box.count = from.voxels;
  const int length = from.high[0] - from.low[0] + 1;
  layer.visit([&](const auto& all) {
    for (int k = from.low[2]; k <= from.high[2]; ++k)
      for (int j = from.low[1]; j <= from.high[1]; ++j) {
        const auto* row = all.data() + map.indexOf(from.low[0], j, k);
        const std::size_t slice =
            static_cast<std::size_t>(k - box.low[2]) * static_cast<std::size_t>(box.size[1]);
        std::uint8_t* out =
            box.inside.data() +
            (slice + static_cast<std::size_t>(j - box.low[1])) * static_cast<std::size_t>(box.size[0]) + 1;
        std::transform(row, row + length, out,
                       [&](auto v) { return static_cast<std::uint8_t>(v == number ? 1 : 0); });
      }
  });
  return box;
}

VoxelPieces voxelPieces(VoxelBox& box, bool keepLargest) {
  PieceFinder finder(box);
  const std::vector<std::int64_t> sizes = finder.sizes();
  const auto largest = std::max_element(sizes.begin(), sizes.end());
  VoxelPieces pieces;
  pieces.count = static_cast<int>(sizes.end() - sizes.begin() - std::count(sizes.begin(), sizes.end(), 0));
  pieces.largest = largest == sizes.end() ? 0 : *largest;
  if (keepLargest && pieces.count > 1) {
    finder.keepOnly(static_cast<std::size_t>(largest - sizes.begin()), box);
    box.count = pieces.largest;
  }
  return pieces;
}

} // namespace viscera::medical_io
