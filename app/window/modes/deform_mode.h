#pragma once

#include "window/modes/mode.h"
#include "window/pose_editor.h"
#include "window/timeline/volume_monitor.h"
#include "window/view/view_model.h"

namespace viscera::app {

/// Moving the handles in the pose: volumes are kept, handles are turned and scaled, drags are mirrored.
class DeformMode final : public Mode {
  Q_OBJECT

public:
  /// What the mode works with; all have to live longer.
  struct Parts {
    Workspace& workspace;
    PoseEditor& poses;
    VolumeMonitor& volumes;
    ViewModel& view;
  };

  DeformMode(const Parts& parts, Actions& actions);

  std::vector<const char*> actions() const override { return {"handles.gizmo", "handles.compensate"}; }
  QWidget* makePage(const Actions& actions) override;
  presentation::Shown shown() const override;
  motion::WantedPose pose() const override { return motion::WantedPose::document; }

private:
  void makePoseActions(Actions& actions);
  void makeVolumeActions(Actions& actions);
  void makeCompensate(Actions& actions);
  void makeMirrorActions(Actions& actions);

  Parts parts_;
};

} // namespace viscera::app
