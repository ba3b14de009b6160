#include "viscera/presentation/view_state.h"

#include <tuple>

namespace viscera::presentation {

bool StressLook::operator==(const StressLook& other) const {
  const auto parts = [](const StressLook& look) {
    return std::tie(look.quantity, look.onSurface, look.pinned, look.range.low, look.range.high, look.peak,
                    look.cut, look.style, look.offset, look.threshold, look.limit, look.below, look.glyphs,
                    look.handles, look.others, look.witnesses, look.probe);
  };
  return parts(*this) == parts(other) && normal == other.normal;
}

bool ViewState::operator==(const ViewState& other) const {
  const auto parts = [](const ViewState& view) {
    return std::tie(view.mode, view.shown, view.camera, view.handles, view.influence, view.ghost, view.labels,
                    view.measurements, view.orientationCube, view.scaleBar, view.gizmo, view.mirror,
                    view.layout.regions, view.layout.zones, view.layout.superRegions, view.chartOfCycle,
                    view.stress, view.selection, view.motions, view.playing);
  };
  return parts(*this) == parts(other) && shownPose.rows() == other.shownPose.rows() &&
         shownPose == other.shownPose;
}

} // namespace viscera::presentation
