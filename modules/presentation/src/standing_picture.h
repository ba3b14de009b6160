#pragma once

#include <memory>
#include <optional>

#include "viscera/presentation/presenter.h"
#include "viscera/scene/standing_slices.h"

namespace viscera::presentation {

/// Draws the three orthogonal slices of the scan in the 3D view, through the place where they meet.
class StandingPicture {
public:
  StandingPicture(scene::OrganView& view, Threads threads) : slices_(view), threads_(threads) {}

  /// Compares the scene with the last one, and makes new slices only if something differs.
  void update(const Scene& scene);

private:
  /// The inputs from which the slices were made.
  struct Made {
    std::shared_ptr<const document::ScanItem> scan;
    ScanLook look;
    std::optional<std::uint64_t> warped;
    bool operator==(const Made&) const = default;
  };

  scene::StandingSlices slices_;
  Threads threads_;
  std::optional<Made> made_; ///< None: no slice is shown.
};

} // namespace viscera::presentation
