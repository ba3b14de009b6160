#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::scene {

class OrganView;

/// Draws slices of a scan in a 3D view among its organs. Light does not change their grey levels. Belongs to
/// the thread that renders; the view has to live longer.
class StandingSlices {
public:
  /// A picture in space, its pixels from the lower left, row by row.
  struct Slice {
    Vec3 corner = Vec3::Zero();     ///< The outer corner of the pixel at the lower left, mm.
    Vec3 right = Vec3::UnitX();     ///< From there to the end of its row, mm.
    Vec3 up = Vec3::UnitZ();        ///< From there to the end of its column, mm.
    int width = 0;                  ///< Pixels.
    int height = 0;                 ///< Pixels.
    std::vector<std::uint8_t> grey; ///< `width * height`.
  };

  explicit StandingSlices(OrganView& view);
  ~StandingSlices();
  StandingSlices(const StandingSlices&) = delete;
  StandingSlices& operator=(const StandingSlices&) = delete;

  /// Replaces the slices that are shown; an empty list hides all. O(pixels).
  void show(const std::vector<Slice>& slices);
  /// The number of slices that are shown.
  std::size_t count() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
