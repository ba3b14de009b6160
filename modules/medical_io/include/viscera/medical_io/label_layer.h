#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace viscera::medical_io {

/// The voxels of one layer of a label map, i fastest: 0, or the number of a segment. Takes one byte a voxel
/// as long as no number is above 255, else two. Several threads may read it, and may set different voxels to
/// numbers up to `largest()`.
class LabelLayer {
public:
  LabelLayer() = default;
  /// All voxels are 0.
  explicit LabelLayer(std::size_t voxels) : bytes_(voxels) {}
  /// Takes the memory of the voxels.
  explicit LabelLayer(std::vector<std::uint8_t> voxels) : bytes_(std::move(voxels)) {}
  explicit LabelLayer(std::vector<std::uint16_t> voxels) : words_(std::move(voxels)), wide_(true) {}

  std::size_t size() const { return wide_ ? words_.size() : bytes_.size(); }
  std::uint16_t operator[](std::size_t voxel) const { return wide_ ? words_[voxel] : bytes_[voxel]; }
  /// The same; throws `std::out_of_range` for a voxel that is not there.
  std::uint16_t at(std::size_t voxel) const { return wide_ ? words_.at(voxel) : bytes_.at(voxel); }

  /// The largest number for which `set` takes no memory.
  std::uint16_t largest() const {
    return wide_ ? std::numeric_limits<std::uint16_t>::max() : std::numeric_limits<std::uint8_t>::max();
  }
  /// O(1); for the first number above 255 O(voxels).
  void set(std::size_t voxel, std::uint16_t number) {
    if (number > largest()) {
      words_.assign(bytes_.begin(), bytes_.end());
      bytes_ = {};
      wide_ = true;
    }
    if (wide_)
      words_[voxel] = number;
    else
      bytes_[voxel] = static_cast<std::uint8_t>(number);
  }

  /// Calls `visit` with the voxels, a `std::span` of `const std::uint8_t` or of `const std::uint16_t`: for
  /// loops over many of them.
  template <class Visit>
  decltype(auto) visit(const Visit& visit) const {
    return wide_ ? visit(std::span<const std::uint16_t>(words_))
                 : visit(std::span<const std::uint8_t>(bytes_));
  }

private:
  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint16_t> words_; ///< Instead of `bytes_`, where a number needs it.
  bool wide_ = false;
};

} // namespace viscera::medical_io
