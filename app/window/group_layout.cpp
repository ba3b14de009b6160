#include "window/group_layout.h"

#include "viscera/presentation/space_parts.h"

namespace viscera::app {

const coordinates::SpaceLayout& GroupLayout::now() {
  const document::DocumentState& state = workspace_.state();
  if (state.rig != rig_ || state.system != system_) {
    rig_ = state.rig;
    system_ = state.system;
    layout_ = presentation::layoutOf(state, workspace_.registry());
  }
  return layout_;
}

} // namespace viscera::app
