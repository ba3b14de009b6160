#pragma once

#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/document/command.h"

namespace viscera::document {

/// Moves handles in the pose to `positions` (`handles x 3` mm). Locked ones stay where they are. Throws
/// `UsageError` for a handle that is not there.
Command moveHandles(std::vector<HandleId> handles, Points positions);

/// Sets the whole pose (`n x 3` mm, in the order of the rig), locked handles included. Throws `DataError` for
/// another size.
Command setPose(Points pose, std::string name = "Set pose");

/// Back to rest, exactly; locked handles too.
Command resetPose();

} // namespace viscera::document
