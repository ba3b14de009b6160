#pragma once

#include "viscera/coordinates/space_layout.h"
#include "window/workspace.h"

namespace viscera::app {

/// How the chosen coordinates divide the space around the handles at rest, for everybody in the window who
/// shows something of it. Computed when asked for after a change, about a millisecond.
class GroupLayout final {
public:
  explicit GroupLayout(const Workspace& workspace) : workspace_(workspace) {}

  /// Of the document as it is now; empty when the coordinates treat all space alike, and when these handles
  /// or groups cannot be used (the live binding says why).
  const coordinates::SpaceLayout& now();

private:
  const Workspace& workspace_;
  std::shared_ptr<const document::Rig> rig_; ///< For which `layout_` was computed.
  std::shared_ptr<const document::SystemChoice> system_;
  coordinates::SpaceLayout layout_;
};

} // namespace viscera::app
