#pragma once

#include "viscera/core/arrays.h"
#include "window/slices/slice_grip.h"

namespace viscera::app {

class Picture;
class SlicePanes;

/// Drags handles with the mouse on slices, each in the slice's plane. It moves the handles of the 3D view, so
/// that undo, locks, mirrors and dependent handles work in the same way.
class HandleGrip final : public SliceGrip {
public:
  /// Both have to live longer.
  HandleGrip(SlicePanes& panes, Picture& picture) : panes_(panes), picture_(picture) {}

  bool press(int direction, const Eigen::Vector2d& pixel, Qt::KeyboardModifiers modifiers) override;
  void drag(int direction, const Eigen::Vector2d& pixel) override;
  void release(int direction, const Eigen::Vector2d& pixel, bool moved) override;
  std::optional<Qt::CursorShape> hover(int direction, const std::optional<Eigen::Vector2d>& pixel) override;

private:
  SlicePanes& panes_;
  Picture& picture_;
  Vec3 start_ = Vec3::Zero();                        ///< Where the handle was when it was grabbed, mm.
  Eigen::Vector2d offset_ = Eigen::Vector2d::Zero(); ///< From the mouse to its middle then, pixels.
};

} // namespace viscera::app
