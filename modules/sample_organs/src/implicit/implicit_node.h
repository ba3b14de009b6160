#pragma once

#include <cmath>
#include <memory>
#include <optional>

#include <Eigen/Geometry>

#include "viscera/core/arrays.h"

/// The nodes of implicit surfaces, from which sample organs are built.
namespace viscera::sample_organs {

/// An axis-parallel box, mm; empty at first.
using Extent = Eigen::AlignedBox3d;

/// The box grown by `margin` mm on every side.
inline Extent grown(const Extent& box, double margin) {
  return {Vec3(box.min().array() - margin), Vec3(box.max().array() + margin)};
}

/// Squared distance in mm from a point to the box, 0 inside.
inline double distance2(const Extent& box, const Vec3& point) {
  return (box.min() - point).cwiseMax(point - box.max()).cwiseMax(0.0).squaredNorm();
}

/// Distance, colour and edge scale at a point.
struct Shade {
  double distance = 0;           ///< As `ImplicitNode::distance`, mm.
  Vec3 color = {0.8, 0.45, 0.4}; ///< Red green blue, 0 to 1.
  double edgeScale = 1;          ///< Wanted edge length here relative to the surface's.
};

/// Random variation of a colour, as in natural tissue.
struct Mottle {
  double amount = 0.05;   ///< Largest change of brightness, a share.
  double wavelength = 12; ///< mm
};

/// The look of a node in a definition; paint and edge scale override those of its children.
struct Finish {
  std::optional<Vec3> paint;
  std::optional<double> edgeScale;
  std::optional<Mottle> mottle;
};

/// One node of an implicit-surface tree. Immutable once built, so any number of threads may evaluate it.
class ImplicitNode {
public:
  explicit ImplicitNode(const Extent& extent) : extent_(extent) {}
  ImplicitNode(const ImplicitNode&) = delete;
  ImplicitNode& operator=(const ImplicitNode&) = delete;
  virtual ~ImplicitNode() = default;

  /// Negative inside, zero on the surface; about the distance in mm near the surface, and never more than
  /// about a third above it further out.
  double distance(const Vec3& point) const { return distanceUpTo(point, kUnlimited); }

  /// The distance where it is below `limit` mm, else any value that is not: cheaper, because farther parts
  /// need not be evaluated.
  virtual double distanceUpTo(const Vec3& point, double limit) const = 0;

  /// A value of `limit` without effect, mm.
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

/// A safety factor, because blended and stretched distances may be smaller than the true one: a part is left
/// out of a sum only when its box is farther than this many times the relevant distance.
inline constexpr double kDistanceShortfall = 1.5;

using NodePtr = std::shared_ptr<const ImplicitNode>;

/// Gradient of the distance by central differences of 0.05 mm; about a unit vector. Six evaluations.
Vec3 gradient(const ImplicitNode& node, const Vec3& point);

/// Moves a point onto the surface by at most `steps` Newton steps of at most 3 mm each.
Vec3 projected(const ImplicitNode& node, Vec3 point, int steps);

} // namespace viscera::sample_organs
