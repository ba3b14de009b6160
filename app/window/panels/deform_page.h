#pragma once

#include "window/actions.h"
#include "window/timeline/volume_monitor.h"
#include "window/widgets/page.h"
#include "window/workspace.h"

namespace viscera::app {

/// Deform: the volume as it changes, back to rest, the ghost of the rest shape, and the place of the current
/// handle.
class DeformPage final : public Page {
  Q_OBJECT

public:
  DeformPage(Workspace& workspace, VolumeMonitor& volumes, const Actions& actions, QWidget* parent = nullptr);

private:
  void sync();

  Workspace& workspace_;
  QLabel* now_ = nullptr;
  QLabel* rest_ = nullptr;
  QLabel* change_ = nullptr;
  QLabel* moved_ = nullptr;
  QLabel* farthest_ = nullptr;
  std::vector<session::Subscription> subscriptions_;
};

} // namespace viscera::app
