#pragma once

#include "window/binding_messages.h"
#include "window/group_layout.h"
#include "window/handle_placer.h"
#include "window/modes/mode.h"
#include "window/view/view_area.h"
#include "window/view/view_model.h"

namespace viscera::app {

/// Editing the handles at rest: they are placed, moved and removed, and everything is bound anew.
class HandlesMode final : public Mode {
  Q_OBJECT

public:
  /// What the mode works with; all have to live longer.
  struct Parts {
    Workspace& workspace;
    HandlePlacer& placer;
    GroupLayout& layout;
    BindingMessages& binding;
    ViewArea& area;
    ViewModel& view;
  };

  HandlesMode(const Parts& parts, Actions& actions);

  std::vector<const char*> actions() const override;
  QWidget* makePage(const Actions& actions) override;
  presentation::Shown shown() const override;
  motion::WantedPose pose() const override { return motion::WantedPose::rest; }
  /// While it is on, how long binding took is said over the view.
  void enter() override;
  void leave() override { disconnect(bound_); }
  /// Adds a handle a little off the surface.
  void click(const ClickedPlace* place) override;

private:
  void makeRigActions(Actions& actions);
  void makeViewActions(Actions& actions);

  Parts parts_;
  QMetaObject::Connection bound_;
};

} // namespace viscera::app
