#pragma once

#include "viscera/document/scan_item.h"
#include "window/measure/measure_tool.h"
#include "window/measure/slice_measuring.h"
#include "window/modes/mode.h"
#include "window/quiz/quiz_tool.h"
#include "window/work/actions.h"

namespace viscera::app {

/// The mode Explore, in which the user looks at organs and measures them.
class ExploreMode final : public Mode {
  Q_OBJECT

public:
  /// `slices` have to live longer.
  ExploreMode(const ModeParts& parts, SlicePanes& slices, Actions& actions);

  std::vector<const char*> actions() const override {
    return {"measure.distance", "measure.angle",     "measure.rectangle",
            "measure.sphere",   "measure.removeAll", "",
            "view.parts",       "quiz.start"};
  }
  QWidget* makePage(const Actions& actions) override;
  presentation::Shown shown() const override { return {}; }
  live::WantedPose pose() const override { return live::WantedPose::sequence; }
  UsefulPanels panels() const override {
    return {false, parts_.playback.sequence() || document::hasImagesOverTime(workspace_.state()), false};
  }
  QString hint() const override;
  void enter() override { tool_.setEnabled(true); }
  void leave() override;
  bool escape() override;
  /// True for points of a measurement, drags of such a point and answers to the quiz.
  bool takesClicks() const override { return measuring() || tool_.hovered() || quiz_.active(); }
  void click(const ClickedPlace* place) override;

  /// Whether clicks are points of a measurement.
  bool measuring() const { return tool_.active(); }
  const QuizTool& quiz() const { return quiz_; }

private:
  void showMeasuring();
  QAction* makeMeasure(Actions& actions, MeasureTool::Kind kind, const char* id,
                       const Actions::Description& description);

  void addQuiz(Actions& actions);
  QWidget* makeCut(const Actions& actions);

  MeasureTool tool_;
  SlicePanes& slices_;
  Subscription studyFollowed_;
  SliceMeasuring onSlices_;
  QuizTool quiz_;
};

} // namespace viscera::app
