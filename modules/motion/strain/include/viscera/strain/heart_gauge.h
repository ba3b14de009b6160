#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/strain/heart_axes.h"
#include "viscera/strain/heart_strain.h"
#include "viscera/strain/wall_fields.h"

/// Measures the strain of a heart: what belongs to the heart at rest once, then any motion of it.
namespace viscera::strain {

/// A surface of a heart at rest.
struct HeartSurface {
  std::string name;
  Triangles triangles; ///< `m x 3`, outward, closed.
  Points rest;         ///< `n x 3` mm.
  /// Whether each triangle closes a valve; empty: `valveCaps` finds it.
  std::vector<bool> caps = {};
};

/// The surfaces of a heart at rest.
struct HeartSurfaces {
  std::optional<HeartSurface> left = {}; ///< The left ventricle's cavity; never none.
  std::optional<HeartSurface> right = {};
  std::optional<HeartSurface> outer = {}; ///< The epicardium, or the whole heart.
  std::optional<HeartSurface> atrium = {};
};

/// Fills the deformation gradients at the points of a wall in one phase, against the heart at rest. Called
/// from several threads.
using GradientsAt =
    std::function<void(std::size_t phase, std::vector<Eigen::Matrix3d>& gradients, Threads threads)>;

/// The surfaces of a heart in all phases of a motion: row i is the same place in each.
struct HeartPhases {
  std::vector<double> seconds; ///< Ascending, at least one.
  std::size_t reference = 0;   ///< The phase that has no strain: the end of diastole.
  /// `n x 3` mm, one for each phase; empty for a surface that the heart does not have.
  std::vector<Points> left, right, outer, atrium;
  GradientsAt gradientsAt; ///< Of a heart whose wall is known.
};

/// A contour through vertices of one of the surfaces, instead of one that is found.
struct ListedContour {
  std::string name; ///< As the contours of `HeartStrain`: "fourChamber", "base", "rightFreeWall"; or another.
  std::string surface;                ///< Name of a surface.
  std::vector<std::int32_t> vertices; ///< Rows of its points, in order.
  bool closed = false;
};

/// A heart at rest, prepared for measuring its strain. Immutable; thread-safe.
///
/// Contours are material lines of the endocardium: in planes through the long axis at 90 degrees (4-chamber),
/// 150 (2-chamber) and 30 (3-chamber) behind the anterior insertion, from one side of the valves' rims over
/// the apex to the other, and across the axis at 1/4, 1/2 and 3/4 of its length. Segments are means over
/// witness points by the volume for which each stands, or over triangles of the endocardium where no wall is
/// known.
///
///     const FoundAxes axes = findAxes(cavity, nullptr);
///     const HeartGauge gauge({.left = surface}, axes, nullptr, {});
///     const HeartStrain strain = gauge.read(beat, progress);
///     const double gls = strain.gls->peak.value; // -0.17: shorter by 17 %.
class HeartGauge {
public:
  /// `wall` is null where none is known. `listed` contours take the place of those of the same name. Throws
  /// `DataError` for a listed contour with a surface or a vertex that does not exist or less than two
  /// vertices. Milliseconds.
  HeartGauge(HeartSurfaces surfaces, FoundAxes axes, std::shared_ptr<const WallPoints> wall,
             const std::vector<ListedContour>& listed, Threads threads = {});

  const HeartSurfaces& surfaces() const;
  const FoundAxes& axes() const;
  const std::shared_ptr<const WallPoints>& wall() const;

  /// Measures a motion. What is known of the heart at rest is not measured again in a phase at rest. Throws
  /// `DataError` for a reference that is no phase and for surfaces without points in each phase; `Cancelled`.
  /// O(phases x (points of the wall x handles + vertices log vertices)). Does not depend on the number of
  /// threads.
  HeartStrain read(const HeartPhases& phases, Progress& progress, Threads threads = {}) const;

private:
  struct Parts;
  class Measuring;
  std::shared_ptr<const Parts> parts_;
};

} // namespace viscera::strain
