#pragma once

#include <cstddef>
#include <optional>

#include "viscera/core/arrays.h"
#include "viscera/geometry/plane_cut.h"

namespace viscera::presentation {

/// A contour that is bent by hand: the place that was grabbed follows, and its neighbours along the contour
/// follow by a Gaussian of their distance, so that a few centimetres of it move. Points are mm, in the plane
/// of the contour.
class ContourBend {
public:
  /// How far along the contour the bend falls to 1/e^2, mm.
  static constexpr double kUsualRadiusMm = 40;

  /// Grabs the place of `cut` nearest to `place`; the contour gets a point there. Throws `UsageError` for a
  /// cut without lines and a radius that is not positive. O(points).
  ContourBend(const geometry::PlaneCut& cut, const Vec3& place, double radiusMm = kUsualRadiusMm);

  /// Moves the grabbed place to `place`. The bend is that of the whole drag, whichever way it went.
  /// O(points).
  void dragTo(const Vec3& place);
  /// How far it was dragged, mm.
  double byMm() const { return by_.norm(); }

  const Points& points() const { return bent_; } ///< The whole line as it is bent, in its order.
  bool closed() const { return closed_; }
  /// Those of its points that moved by a twentieth of the drag and more: what the user has said.
  Points corrected() const { return among(bent_); }
  /// The same points as they were.
  Points covered() const { return among(line_); }

private:
  Points among(const Points& line) const;

  Points line_, bent_;
  Values shares_; ///< Of the drag that each point takes part in, 0 to 1.
  bool closed_ = false;
  Vec3 grabbed_ = Vec3::Zero(), by_ = Vec3::Zero();
};

} // namespace viscera::presentation
