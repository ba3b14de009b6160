#pragma once

#include <functional>
#include <vector>

#include <vtkCommand.h>

#include "viscera/core/arrays.h"

class vtkVisceraHandleSetWidget;

namespace viscera::scene {

/// What a handle widget says with each of its events (the events' call data points to one of these).
struct HandleEvent {
  int handle = -1;              ///< The handle under the cursor or in the hand; -1: none.
  Vec3 position = Vec3::Zero(); ///< Where that handle is now, mm.
  Vec3 start = Vec3::Zero();    ///< Where it was when it was grabbed, mm.
  std::vector<int> moving; ///< During a drag every handle that moves with it, ascending; else the selection.
  Vec3 delta() const { return position - start; } ///< The same for every handle of `moving`.
};

/// Calls `listener` for every event of that number (one of `vtkVisceraHandleSetWidget`'s). Returns the
/// observer's tag for `RemoveObserver`. What the listener captures has to live as long as the widget or until
/// it is removed.
unsigned long observe(vtkVisceraHandleSetWidget* widget, unsigned long event,
                      std::function<void(const HandleEvent&)> listener);

} // namespace viscera::scene
