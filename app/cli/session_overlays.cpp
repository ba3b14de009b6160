#include "cli/session_overlays.h"

#include "window/group_layout.h"
#include "window/measure/measure_scene.h"
#include "window/view/label_scene.h"
#include "window/view/region_scene.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;

/// Those of the handles at rest, which the window shows while they are edited.
void addRegions(const StagedSession& staged, const ordered_json& view, const plugin::Registry& systems) {
  const scene::LayoutParts shown{.regions = switchedOn(view, "handles.regions", true),
                                 .zones = switchedOn(view, "handles.zones", false),
                                 .superRegions = switchedOn(view, "handles.superRegions", false)};
  const document::DocumentState& state = staged.document.state();
  staged.stage.view().regions().setHulls(
      regionHulls(*state.rig, layoutOf(state, systems), shown, traitsOf(state, systems).needsCage));
}

} // namespace

SessionOverlays::SessionOverlays(const StagedSession& staged, const ordered_json& view,
                                 const plugin::Registry& systems)
    : labels_(staged.stage.view()), measurements_(staged.stage.view()) {
  if (switchedOn(view, "view.ghost", false))
    addGhosts(staged);
  if (switchedOn(view, "view.labels", false))
    addLabels(staged);
  if (switchedOn(view, "view.measurements", true))
    addMeasurements(staged);
  if (view.value("mode", std::string()) == "handles")
    addRegions(staged, view, systems);
}

void SessionOverlays::addGhosts(const StagedSession& staged) {
  for (const auto& organ : staged.document.organs()) {
    auto ghost = std::make_unique<scene::GhostOutline>(organ->mesh);
    ghost->setColor(staged.stage.view().theme().muted);
    ghost->setRenderer(staged.stage.view().renderer());
    ghost->setVisible(organ->look.visible);
    ghosts_.push_back(std::move(ghost));
  }
}

void SessionOverlays::addLabels(const StagedSession& staged) {
  labels_.setTheme(staged.stage.view().theme());
  labels_.setItems(labelItems(staged.document, [&](document::OrganId id) { return staged.actors.at(id); }));
  labels_.setShown(true);
}

void SessionOverlays::addMeasurements(const StagedSession& staged) {
  measurements_.setTheme(staged.stage.view().theme());
  measurements_.setItems(
      measurementItems(staged.document.state(),
                       [&](document::OrganId id) -> const Points& { return staged.live.points(id); }));
}

} // namespace viscera::app::cli
