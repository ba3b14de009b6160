#pragma once

#include <cmath>
#include <memory>
#include <optional>

#include <Eigen/Geometry>

#include "viscera/core/arrays.h"

namespace viscera::sample_organs {

/// An axis-parallel box, mm; empty at first.
using Extent = Eigen::AlignedBox3d;

/// By `margin` mm on every side.
inline Extent grown(const Extent& box, double margin) {
  return {Vec3(box.min().array() - margin), Vec3(box.max().array() + margin)};
}

/// Squared distance in mm from a point to the box, 0 inside.
inline double distance2(const Extent& box, const Vec3& point) {
  return (box.min() - point).cwiseMax(point - box.max()).cwiseMax(0.0).squaredNorm();
}

/// Everything that the tree knows about a point.
struct Shade {
  double distance = 0;           ///< As `ImplicitNode::distance`, mm.
  Vec3 color = {0.8, 0.45, 0.4}; ///< Red green blue, 0 to 1.
  double edgeScale = 1;          ///< Wanted edge length here relative to the surface's.
};

/// Unevenness of a colour, as grown tissue has it.
struct Mottle {
  double amount = 0.05;   ///< Largest change of brightness, a share.
  double wavelength = 12; ///< mm
};

/// What a definition may say about the look of a node; paint and edge scale win over those below the node.
struct Finish {
  std::optional<Vec3> paint;
  std::optional<double> edgeScale;
  std::optional<Mottle> mottle;
};

/// One node of an implicit-surface tree. Immutable once built, so any number of threads may ask it.
class ImplicitNode {
public:
  explicit ImplicitNode(const Extent& extent) : extent_(extent) {}
  ImplicitNode(const ImplicitNode&) = delete;
  ImplicitNode& operator=(const ImplicitNode&) = delete;
  virtual ~ImplicitNode() = default;

  /// Negative inside, zero on the surface; about the distance in mm near the surface, and never more than
  /// about a third above it further out.
  double distance(const Vec3& point) const { return distanceUpTo(point, kUnlimited); }

  /// The distance where it is below `limit` mm, else any value that is not: cheaper, because what is farther
  /// need not be looked for.
  virtual double distanceUpTo(const Vec3& point, double limit) const = 0;

  /// A limit that limits nothing, mm.
  static constexpr double kUnlimited = 1e9;

  /// Distance, colour and edge scale; slower than `distance`.
  Shade shade(const Vec3& point) const;

  /// A box around everything inside.
  const Extent& extent() const { return extent_; }
  double distanceToExtent(const Vec3& point) const { return std::sqrt(distance2(extent_, point)); }

  void setFinish(const Finish& finish) { finish_ = finish; }

protected:
  /// `shade` before this node's own finish.
  virtual Shade shadeUnfinished(const Vec3& point) const { return Shade{distance(point)}; }

private:
  Extent extent_;
  Finish finish_;
};

/// Blended and stretched distances may fall short of the true one; parts are left out of a sum by their box
/// only when it is farther than this many times the distance that matters.
inline constexpr double kDistanceShortfall = 1.5;

using NodePtr = std::shared_ptr<const ImplicitNode>;

/// Gradient of the distance by central differences of 0.05 mm; about a unit vector. Six evaluations.
Vec3 gradient(const ImplicitNode& node, const Vec3& point);

/// Moves a point onto the surface by at most `steps` Newton steps of at most 3 mm each.
Vec3 projected(const ImplicitNode& node, Vec3 point, int steps);

} // namespace viscera::sample_organs
