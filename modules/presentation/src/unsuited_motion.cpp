#include "viscera/presentation/unsuited_motion.h"

#include <cstddef>

#include "viscera/live/unsuited_motion.h"

namespace viscera::presentation {

int motionOf(const ViewState& view) {
  return view.playing ? view.playing->motion : view.motions.empty() ? -1 : 0;
}

Text unsuitedMotion(const document::DocumentState& state, const ViewState& view,
                    const sequences::Sequence& sequence) {
  const int motion = motionOf(view);
  const auto chosen = static_cast<std::size_t>(motion);
  const auto organ =
      motion >= 0 && chosen < view.motions.size() ? state.organ(view.motions[chosen].organ) : nullptr;
  return organ ? live::unsuitedTo(sequence.id(), organ->name) : Text();
}

} // namespace viscera::presentation
