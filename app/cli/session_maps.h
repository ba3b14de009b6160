#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/stage.h"
#include "viscera/live/live_stress.h"
#include "viscera/scene/tissue_actor.h"
#include "window/stress/stress_look.h"

namespace viscera::app::cli {

/// A session on a stage: its organs are bound, posed and drawn.
struct StagedSession {
  document::Document& document;
  live::LiveBinding& live;
  JobQueue& jobs;
  PostBox& box;
  Stage& stage;
  std::map<document::OrganId, std::shared_ptr<scene::OrganActor>> actors;
};

/// Whether a switch of the window was on; `standard` where the session does not say.
bool switchedOn(const nlohmann::ordered_json& view, const char* name, bool standard);

/// Whether the window showed the influence of a handle, or a stress map.
bool showsInfluence(const nlohmann::ordered_json& view);
bool showsStress(const nlohmann::ordered_json& view);

/// Colours the organs by the influence, in per cent, of the handle that was selected last; nothing when none
/// was.
void drawInfluence(const StagedSession& staged, const nlohmann::ordered_json& view);

/// The stress map of the organ that was selected, on its surface and on the cut through its inside. Has to
/// live until the picture is taken.
class SessionStress {
public:
  /// Fills the organ with witness points and binds them: a second or more. All of `staged` lives longer.
  SessionStress(const StagedSession& staged, const nlohmann::ordered_json& view,
                const plugin::Registry& systems, Threads threads);
  ~SessionStress();
  SessionStress(const SessionStress&) = delete;
  SessionStress& operator=(const SessionStress&) = delete;

  /// What of the map is not drawn, and why; empty when all is.
  const std::vector<std::string>& leftOut() const { return leftOut_; }

private:
  void draw();
  void drawTissue(const scene::ColorMap& colors, scene::ValueRange range);
  void drawOrgans(const scene::ColorMap& colors, scene::ValueRange range);
  void hideHandles();
  bool onSurface() const;

  const StagedSession& staged_;
  StressLook look_;
  live::LiveStress live_;
  std::unique_ptr<scene::TissueActor> tissue_;
  std::shared_ptr<Values> values_ = std::make_shared<Values>();
  scene::CutPlane plane_;
  double radius_ = 0; ///< Of the organ at rest, mm.
  std::vector<std::string> leftOut_;
};

} // namespace viscera::app::cli
