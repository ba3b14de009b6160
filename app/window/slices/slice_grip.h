#pragma once

#include <QtCore/qnamespace.h>

#include <optional>

#include "viscera/core/arrays.h"

namespace viscera::app {

/// The interface of tools that drag things on slices (handles, measured points); they get the left button
/// before the slice itself. Pixels are those of the slice's picture, `direction` is one of
/// `medical_io::sliceDirections`.
class SliceGrip {
public:
  virtual ~SliceGrip() = default;

  /// The left button was pressed. Returns true if this tool handles the drag until the release.
  virtual bool press(int direction, const Eigen::Vector2d& pixel, Qt::KeyboardModifiers modifiers) = 0;
  virtual void drag(int direction, const Eigen::Vector2d& pixel) = 0;
  /// `moved`: farther than the distance of a click.
  virtual void release(int direction, const Eigen::Vector2d& pixel, bool moved) = 0;
  /// The mouse moves with no button down, or has left the slice. Returns the cursor for what a press would
  /// do; none if this tool would not handle it.
  virtual std::optional<Qt::CursorShape> hover(int direction,
                                               const std::optional<Eigen::Vector2d>& pixel) = 0;
};

} // namespace viscera::app
