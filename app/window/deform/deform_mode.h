#pragma once

#include "window/deform/elastic_ghost.h"
#include "window/modes/mode.h"
#include "window/view/pose_editor.h"

namespace viscera::app {

/// The mode Deform, in which the user moves handles in the pose: volumes are kept, handles are turned and
/// scaled, drags are mirrored.
class DeformMode final : public Mode {
  Q_OBJECT

public:
  DeformMode(const ModeParts& parts, Actions& actions);

  std::vector<const char*> actions() const override {
    return {"handles.gizmo", "handles.follow", "handles.exactly", "handles.compensate", "pose.elasticity"};
  }
  QWidget* makePage(const Actions& actions) override;
  presentation::Shown shown() const override {
    return {.handles = true, .movable = true, .compensating = true, .tools = true};
  }
  live::WantedPose pose() const override { return live::WantedPose::document; }
  UsefulPanels panels() const override { return {true, false, true}; }

private:
  void makePoseActions(Actions& actions);
  void makeVolumeActions(Actions& actions);
  void makeCompensate(Actions& actions);
  void makeMirrorActions(Actions& actions);

  ElasticGhost ghost_;
};

} // namespace viscera::app
