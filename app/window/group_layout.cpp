#include "window/group_layout.h"

namespace viscera::app {

const coordinates::SpaceLayout& GroupLayout::now() {
  const session::DocumentState& state = workspace_.state();
  if (state.rig != rig_ || state.system != system_) {
    rig_ = state.rig;
    system_ = state.system;
    layout_ = compute();
  }
  return layout_;
}

coordinates::SpaceLayout GroupLayout::compute() const {
  if (!workspace_.registry().contains(system_->id) || rig_->handles.empty())
    return {};
  try {
    return workspace_.registry().find(system_->id)->layout(session::handleSet(*rig_), system_->parameters);
  } catch (const Error&) {
    return {}; // A flat group, say: binding fails for the same reason and tells it.
  }
}

} // namespace viscera::app
