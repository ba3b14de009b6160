#pragma once

#include <memory>

#include "viscera/document/document.h"
#include "viscera/presentation/view_state.h"

namespace viscera::presentation {

/// The document with its organs as a view wants them to be seen. Remembers the organs that it made: while
/// nothing is different they are the very same list, by which pictures tell that there is nothing to do.
class SeenDocument {
public:
  /// The state itself where the view has no wish, else one that is good until the next call. O(organs).
  const document::DocumentState& of(const document::DocumentState& state, const OrgansSeen& wanted);

private:
  std::shared_ptr<const document::OrganList> organs_; ///< Of the document.
  OrgansSeen wanted_;
  document::DocumentState seen_;
};

} // namespace viscera::presentation
