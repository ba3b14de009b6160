#pragma once

#include <memory>

#include "viscera/document/document.h"
#include "viscera/presentation/view_state.h"

namespace viscera::presentation {

/// Copies a document's state with the visibility and opacity of organs that a slide sets. Returns the same
/// list of organs as before while nothing has changed, so that pictures detect by the pointer that no update
/// is needed.
class SeenDocument {
public:
  /// Returns the state itself if `wanted` is empty, else a copy that is valid until the next call. O(organs).
  const document::DocumentState& of(const document::DocumentState& state, const OrgansSeen& wanted);

private:
  std::shared_ptr<const document::OrganList> organs_; ///< The document's organs in the last call.
  OrgansSeen wanted_;
  document::DocumentState seen_;
};

} // namespace viscera::presentation
