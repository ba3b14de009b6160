#pragma once

#include <QObject>

#include "viscera/live/live_bend.h"
#include "window/workspace.h"

namespace viscera::app {

/// What bends the scan along with the pose: one for the slices, the 3D view and the status line, which
/// belongs to the workspace.
class ScanBend final : public QObject {
  Q_OBJECT

public:
  /// That of a workspace, made when it is first asked for.
  static live::LiveBend& of(Workspace& workspace);

private:
  explicit ScanBend(Workspace& workspace)
      : QObject(&workspace),
        bend_(workspace.document(), workspace.live(), workspace.registry(), workspace.jobs()) {}

  live::LiveBend bend_;
};

} // namespace viscera::app
