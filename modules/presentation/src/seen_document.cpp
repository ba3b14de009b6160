#include "seen_document.h"

#include <utility>

namespace viscera::presentation {

const document::DocumentState& SeenDocument::of(const document::DocumentState& state,
                                                const OrgansSeen& wanted) {
  if (wanted.empty())
    return state;
  std::shared_ptr<const document::OrganList> made = seen_.organs;
  if (organs_ != state.organs || wanted_ != wanted) {
    auto organs = std::make_shared<document::OrganList>(*state.organs);
    for (auto& organ : *organs) {
      const auto found = wanted.find(organ->id);
      if (found == wanted.end())
        continue;
      auto other = std::make_shared<document::Organ>(*organ);
      other->look.visible = found->second.visible;
      other->look.opacity = found->second.opacity;
      organ = std::move(other);
    }
    organs_ = state.organs;
    wanted_ = wanted;
    made = std::move(organs);
  }
  seen_ = state;
  seen_.organs = std::move(made);
  return seen_;
}

} // namespace viscera::presentation
