#include "window/group_layout.h"

namespace viscera::app {

coordinates::SpaceLayout layoutOf(const document::DocumentState& state, const plugin::Registry& systems) {
  if (!systems.contains(state.system->id) || state.rig->handles.empty())
    return {};
  try {
    return systems.find(state.system->id)->layout(document::handleSet(*state.rig), state.system->parameters);
  } catch (const Error&) {
    return {}; // A flat group, say: binding fails for the same reason and tells it.
  }
}

const coordinates::SpaceLayout& GroupLayout::now() {
  const document::DocumentState& state = workspace_.state();
  if (state.rig != rig_ || state.system != system_) {
    rig_ = state.rig;
    system_ = state.system;
    layout_ = layoutOf(state, workspace_.registry());
  }
  return layout_;
}

} // namespace viscera::app
