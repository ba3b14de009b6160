#pragma once

#include <memory>
#include <vector>

#include "viscera/document/document.h"

namespace viscera::presentation {

/// Finds the organ that each handle is nearest to at rest, so that a view can highlight the handles of one
/// organ. Caches the last result.
///
///     for (std::size_t row = 0; row < rig.handles.size(); ++row)
///       representation->SetHandleInBackground(row, !owners.isOf(state, row, organ));
class HandleOwners {
public:
  /// Whether the handle of this row belongs to the organ, to a cavity of it, or to the organ that it is a
  /// cavity of. O(handles x organs) after the rig or the organs have changed, O(1) else.
  bool isOf(const document::DocumentState& state, std::size_t row, document::OrganId organ);

private:
  std::shared_ptr<const document::Rig> rig_;
  std::shared_ptr<const document::OrganList> organs_;
  std::vector<std::shared_ptr<const document::Organ>>
      owners_; ///< One for each handle; null where there is no organ.
};

} // namespace viscera::presentation
