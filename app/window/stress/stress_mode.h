#pragma once

#include "window/modes/mode.h"
#include "window/stress/cut_controller.h"
#include "window/stress/stress_model.h"
#include "window/work/actions.h"

namespace viscera::app {

class ProbeCard;
class StressChart;
class StressExport;
class StressPage;

/// The mode Stress, in which the user looks at the distortion of tissue: model, view, page, chart, probe card
/// and actions.
class StressMode final : public Mode {
  Q_OBJECT

public:
  StressMode(const ModeParts& parts, Actions& actions);

  std::vector<const char*> actions() const override;
  QWidget* makePage(const Actions& actions) override;
  QWidget* makeChart() override;
  /// Handles can be moved while the document's pose is shown, not a sequence's.
  presentation::Shown shown() const override;
  live::WantedPose pose() const override { return live::WantedPose::sequence; }
  /// The chart is there before the sequence is shown: a drag along the timeline must not move the timeline.
  UsefulPanels panels() const override {
    const bool moves = parts_.playback.sequence() != nullptr;
    return {false, moves, moves};
  }
  /// After a mode in which the user has posed the organ, shows the map of that pose, not of the sequence that
  /// was paused before.
  void enter() override;
  void setTheme(const Theme& theme) override;
  /// Closes the probe or cancels the drag of the plane; false when there was nothing to do.
  bool escape() override;
  bool takesClicks() const override { return true; }
  bool press(const QPointF& place) override {
    cut_.probeAt(place);
    return true;
  }

  StressModel& model() { return model_; }
  CutController& cut() { return cut_; }
  StressExport& exports() { return *exports_; }

private:
  void makeActions();
  void addSwitches(); ///< Those of the look.
  void syncActions();

  Actions& actions_;
  StressModel model_;
  CutController cut_;
  ProbeCard* card_ = nullptr;
  StressPage* page_ = nullptr;
  StressChart* chart_ = nullptr;
  StressExport* exports_;
  bool posed_ = false; ///< The last mode showed the document's pose, and no sequence was shown since.
  Subscription subscription_;
};

} // namespace viscera::app
