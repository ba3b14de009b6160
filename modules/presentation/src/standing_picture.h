#pragma once

#include <memory>
#include <optional>

#include "viscera/presentation/presenter.h"
#include "viscera/scene/standing_slices.h"

namespace viscera::presentation {

/// The three slices of the scan that stand in the 3D view, through the place where they meet.
class StandingPicture {
public:
  StandingPicture(scene::OrganView& view, Threads threads) : slices_(view), threads_(threads) {}

  /// Compares with what it showed last, and takes new slices only where something is different.
  void update(const Scene& scene);

private:
  /// What the slices were made with.
  struct Made {
    std::shared_ptr<const document::ScanItem> scan;
    ScanLook look;
    std::optional<std::uint64_t> bent;
    bool operator==(const Made&) const = default;
  };

  scene::StandingSlices slices_;
  Threads threads_;
  std::optional<Made> made_; ///< None: none is shown.
};

} // namespace viscera::presentation
