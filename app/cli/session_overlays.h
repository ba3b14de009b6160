#pragma once

#include <memory>
#include <vector>

#include "cli/session_maps.h"
#include "viscera/scene/ghost_outline.h"
#include "viscera/scene/measurement_glyphs.h"
#include "viscera/scene/organ_labels.h"

namespace viscera::app::cli {

/// What the window drew over and around a session's organs: ghosts of their rest shapes, labels,
/// measurements, and the groups' regions. Has to live until the picture is taken.
class SessionOverlays {
public:
  /// Call when all organs are posed. `staged` lives longer.
  SessionOverlays(const StagedSession& staged, const nlohmann::ordered_json& view,
                  const plugin::Registry& systems);

private:
  void addGhosts(const StagedSession& staged);
  void addLabels(const StagedSession& staged);
  void addMeasurements(const StagedSession& staged);

  scene::OrganLabels labels_;
  scene::MeasurementGlyphs measurements_;
  std::vector<std::unique_ptr<scene::GhostOutline>> ghosts_;
};

} // namespace viscera::app::cli
