#pragma once

#include <memory>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/geometry/carried_points.h"
#include "viscera/geometry/named_vessel.h"
#include "viscera/geometry/swept_tubes.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::live {

/// The coronary arteries and the veins of a heart as tubes. They are no organs of the document: their lines
/// are carried by the heart's surfaces, and the tubes are swept around them, so that they stay round.
/// Immutable; thread-safe.
class HeartVessels {
public:
  enum class Kind { arteries, veins };
  /// A drawn vessel is that much thicker than its bump on the outer surface, mm, which it so covers.
  static constexpr double kOverMm = 0.5;

  /// `carriers` are the points that carry them, at rest. Bluish vessels are veins. O(points log carriers).
  HeartVessels(std::vector<geometry::NamedVessel> vessels, const Points& carriers, Threads threads = {});

  /// Arteries first; `first(i)` is the row of a vessel's first point among all lines.
  const std::vector<geometry::NamedVessel>& vessels() const { return vessels_; }
  Eigen::Index first(std::size_t vessel) const { return first_.at(vessel); }
  /// The surface at rest; without triangles where there are none of that kind.
  const std::shared_ptr<const geometry::TriangleMesh>& mesh(Kind kind) const { return side(kind).mesh; }
  Vec3 color(Kind kind) const { return side(kind).color; }

  /// Writes the points of all lines for the carriers as they are now.
  void linesAt(const Points& carriers, Points& lines, Threads threads = {}) const;
  /// Writes the points of a surface for those lines.
  void surfaceAt(Kind kind, const Points& lines, Points& out) const;

private:
  struct Side {
    Eigen::Index begin = 0, rows = 0; ///< Of all lines.
    geometry::SweptTubes tubes;
    Vec3 color = Vec3::Ones();
    std::shared_ptr<const geometry::TriangleMesh> mesh;
  };
  Side sideOf(std::size_t begin, std::size_t end, const Points& lines) const;
  const Side& side(Kind kind) const { return sides_.at(kind == Kind::arteries ? 0 : 1); }

  std::vector<geometry::NamedVessel> vessels_;
  std::vector<Eigen::Index> first_;
  geometry::CarriedPoints carried_;
  std::vector<Side> sides_;
};

} // namespace viscera::live
