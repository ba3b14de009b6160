#pragma once

#include <QtCore/qnamespace.h>

#include <optional>

#include "viscera/core/arrays.h"

namespace viscera::app {

/// The interface of tools that drag things on slices (handles, measured points); they get the left button
/// before the slice itself. Pixels are those of the slice's picture, `direction` is one of
/// `slices::sliceDirections`.
class SliceGrip {
public:
  virtual ~SliceGrip() = default;

  /// The left button goes down: true when what follows until it is up is his.
  virtual bool press(int direction, const Eigen::Vector2d& pixel, Qt::KeyboardModifiers modifiers) = 0;
  virtual void drag(int direction, const Eigen::Vector2d& pixel) = 0;
  /// `moved`: farther than a hand trembles.
  virtual void release(int direction, const Eigen::Vector2d& pixel, bool moved) = 0;
  /// The mouse is there with no button down, or has left. The cursor that says what a press would do; none
  /// when it is not his.
  virtual std::optional<Qt::CursorShape> hover(int direction,
                                               const std::optional<Eigen::Vector2d>& pixel) = 0;
};

} // namespace viscera::app
