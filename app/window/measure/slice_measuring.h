#pragma once

#include "viscera/core/arrays.h"
#include "window/measure/measure_tool.h"
#include "window/slices/slice_grip.h"

namespace viscera::app {

class SlicePanes;

/// Handles the mouse for measuring on slices: while the user measures, a click adds a point, and a drag adds
/// both its ends; otherwise points that lie on no organ can be dragged in the slice.
class SliceMeasuring final : public SliceGrip {
public:
  /// Both have to live longer.
  SliceMeasuring(MeasureTool& tool, SlicePanes& panes) : tool_(tool), panes_(panes) {}

  bool press(int direction, const Eigen::Vector2d& pixel, Qt::KeyboardModifiers modifiers) override;
  void drag(int direction, const Eigen::Vector2d& pixel) override;
  void release(int direction, const Eigen::Vector2d& pixel, bool moved) override;
  std::optional<Qt::CursorShape> hover(int direction, const std::optional<Eigen::Vector2d>& pixel) override;

private:
  document::MeasuredPoint pointAt(const Vec3& place, int axis) const;
  document::MeasuredPoint pointAt(int direction, const Eigen::Vector2d& pixel) const;
  static int axisOf(int direction);
  /// Whether the chosen kind can be measured on what the slices show: a study has no values of regions.
  bool measuresHere() const;

  MeasureTool& tool_;
  SlicePanes& panes_;
  bool drawing_ = false;      ///< The press added the first point, so the release may add the next one.
  Vec3 start_ = Vec3::Zero(); ///< Where the grabbed point was drawn at first, mm.
  Eigen::Vector2d offset_ = Eigen::Vector2d::Zero(); ///< From the mouse to that point at the press, pixels.
};

} // namespace viscera::app
