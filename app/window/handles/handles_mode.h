#pragma once

#include "window/modes/mode.h"
#include "window/work/handle_placer.h"

namespace viscera::app {

/// The mode Handles, in which the user edits the handles at rest: they are placed, moved and removed, and
/// everything is bound anew.
class HandlesMode final : public Mode {
  Q_OBJECT

public:
  HandlesMode(const ModeParts& parts, Actions& actions);

  std::vector<const char*> actions() const override;
  QWidget* makePage(const Actions& actions) override;
  presentation::Shown shown() const override {
    return {.rest = true, .handles = true, .movable = true, .regions = true};
  }
  live::WantedPose pose() const override { return live::WantedPose::rest; }
  UsefulPanels panels() const override { return {true, false, false}; }
  /// Shows in the view how long each binding took while this mode is on.
  void enter() override;
  void leave() override { disconnect(bound_); }
  bool takesClicks() const override { return true; }
  /// Adds a handle a little off the surface.
  void click(const ClickedPlace* place) override;

private:
  void makeRigActions(Actions& actions);
  void makeViewActions(Actions& actions);
  void selectAll();
  void removeSelected();

  QMetaObject::Connection bound_;
};

} // namespace viscera::app
