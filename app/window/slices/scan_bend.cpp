#include "window/slices/scan_bend.h"

namespace viscera::app {

live::LiveBend& ScanBend::of(Workspace& workspace) {
  auto* present = workspace.findChild<ScanBend*>(QString(), Qt::FindDirectChildrenOnly);
  return (present ? present : new ScanBend(workspace))->bend_;
}

} // namespace viscera::app
