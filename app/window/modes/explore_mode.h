#pragma once

#include "window/actions.h"
#include "window/measure/measure_tool.h"
#include "window/modes/mode.h"
#include "window/view/view_area.h"
#include "window/view/view_model.h"

namespace viscera::app {

/// Looking at the organs and measuring them.
class ExploreMode final : public Mode {
  Q_OBJECT

public:
  /// What the mode works with; all have to live longer.
  struct Parts {
    Workspace& workspace;
    Picture& picture;
    const HandleController& handles;
    ViewArea& area;
    ViewModel& view;
  };

  ExploreMode(const Parts& parts, Actions& actions);

  std::vector<const char*> actions() const override;
  QWidget* makePage(const Actions& actions) override;
  presentation::Shown shown() const override { return {}; }
  motion::WantedPose pose() const override { return motion::WantedPose::sequence; }
  QString hint() const override;
  void enter() override { tool_.setEnabled(true); }
  void leave() override { tool_.setEnabled(false); }
  bool escape() override { return tool_.escape(); }
  void click(const ClickedPlace* place) override;

  /// Whether clicks are points of a measurement.
  bool measuring() const { return tool_.active(); }

private:
  void showMeasuring();
  QAction* makeMeasure(Actions& actions, MeasureTool::Kind kind, const char* id,
                       const Actions::Description& description);

  Parts parts_;
  MeasureTool tool_;
};

} // namespace viscera::app
