#pragma once

#include <array>
#include <optional>
#include <vector>

#include "implicit/centerline.h"
#include "implicit/implicit_node.h"
#include "implicit/segment_tree.h"
#include "implicit/tube_relief.h"

namespace viscera::sample_organs {

/// A dimple in a flat end, so that a cut vessel looks hollow.
struct Lumen {
  double wall = 2;  ///< mm left around it.
  double depth = 6; ///< mm
};

/// Everything about a tube but its axis.
struct TubeShape {
  Vec3 flattenDirection = Vec3::UnitX();        ///< Unit.
  double flattenFactor = 1;                     ///< Thickness along that direction relative to a round tube.
  std::array<bool, 2> flatEnd = {false, false}; ///< Start, end: cut flat instead of a half ball.
  std::array<std::optional<Lumen>, 2> lumen;    ///< Only in flat ends.
  double rim = 0.8;                             ///< Radius in mm that rounds the edge of a flat end.
  TubeRelief relief;
  double step = 1; ///< mm between samples of the axis.
};

/// A tube of varying radius along a smooth axis. Its bends must be wider than its radius.
class Tube final : public ImplicitNode {
public:
  /// At least two points, positive radii.
  Tube(const std::vector<AxisPoint>& points, TubeShape shape);

  double distanceUpTo(const Vec3& point, double limit) const override;

  /// Length of the axis, mm.
  double length() const { return axis_.back().arc; }

private:
  Tube(std::vector<AxisSample> axis, TubeShape shape);
  Shade shadeUnfinished(const Vec3& point) const override;
  bool isNearLumen(int end, const Vec3& point) const;
  Vec3 rounded(const Vec3& point) const;
  double searchLimit(double limit) const;
  double reliefDistance(const Vec3& point, const NearestOnAxis& nearest) const;
  double cutFlat(int end, const Vec3& point, double arc, double distance) const;
  double stretched(const Vec3& away, double distance) const;

  std::vector<AxisSample> axis_; ///< In the space where the tube is round.
  TubeShape shape_;
  SegmentTree tree_;
  double widest_ = 0; ///< Largest radius of the axis, mm.
};

} // namespace viscera::sample_organs
