#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "viscera/presentation/presenter.h"
#include "viscera/scene/standing_slices.h"

namespace viscera::presentation {

/// Draws the three orthogonal slices of the scan in the 3D view, through the place where they meet, or the
/// slices of a cine study that the panes show, each in its own plane.
class StandingPicture {
public:
  StandingPicture(scene::OrganView& view, Threads threads) : slices_(view), threads_(threads) {}

  /// Compares the scene with the last one, and makes new slices only if something differs.
  void update(const Scene& scene);

private:
  /// The inputs from which the slices were made.
  struct Made {
    std::shared_ptr<const document::ScanItem> scan;
    std::shared_ptr<const document::StudyItem> study;
    ScanLook look;
    std::optional<std::uint64_t> warped;
    bool operator==(const Made&) const = default;
  };

  std::vector<scene::StandingSlices::Slice> scanSlices(const Scene& scene);
  std::vector<scene::StandingSlices::Slice> studySlices(const Scene& scene);

  scene::StandingSlices slices_;
  Threads threads_;
  std::optional<Made> made_;                              ///< None: no slice is shown.
  std::shared_ptr<const document::StudyItem> proposedBy_; ///< Whose proposal `proposed_` is.
  medical_io::ValueWindow proposed_;
  std::shared_ptr<const document::ScanItem> scanProposedBy_; ///< The same of a scan, for all of its phases.
  medical_io::ValueWindow scanProposed_;
};

} // namespace viscera::presentation
