#pragma once

#include "window/actions.h"
#include "window/modes/mode.h"
#include "window/stress/stress_model.h"
#include "window/stress/stress_scene.h"
#include "window/view/view_area.h"

namespace viscera::app {

class ProbeCard;
class StressChart;

/// Stress mode as the window has it: model, view, page, chart, probe card and actions.
class StressMode final : public Mode {
  Q_OBJECT

public:
  StressMode(Workspace& workspace, Playback& playback, Settings& settings, Actions& actions, ViewArea& area,
             OrganScene& organs, HandleScene& handles);
  ~StressMode() override;

  std::vector<const char*> actions() const override;
  QWidget* makePage(const Actions& actions) override;
  QWidget* makeChart() override;
  /// Handles can be moved while the document's pose is shown, not a sequence's.
  presentation::Shown shown() const override;
  WantedPose pose() const override { return WantedPose::sequence; }
  void setTheme(const Theme& theme) override;
  void enter() override { model_.setActive(true); }
  void leave() override { model_.setActive(false); }
  /// Closes the probe or puts a dragged plane back; false when there was nothing to do.
  bool escape() override;
  /// The scene asks for the values there.
  void click(const ClickedPlace*) override {}

  StressModel& model() { return model_; }
  StressScene& scene() { return scene_; }

private:
  void makeActions();
  void syncActions();
  void changeLook(const std::function<void(StressLook&)>& change);

  Playback& playback_;
  Actions& actions_;
  ViewArea& area_;
  StressModel model_;
  StressScene scene_;
  ProbeCard* card_;
  StressChart* chart_ = nullptr;
};

} // namespace viscera::app
