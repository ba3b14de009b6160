#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/strain/aha_segments.h"
#include "viscera/strain/heart_axes.h"
#include "viscera/strain/material_contour.h"
#include "viscera/strain/strain_curve.h"
#include "viscera/strain/wall_fields.h"

/// The strain of a heart over the phases of a cycle, by the two definitions of docs/strain.md: of the length
/// of contours (what echo and feature tracking report) and of the material at witness points.
namespace viscera::strain {

/// A surface in all phases with the same triangles: vertex i is the same place in each.
struct MovingSurface {
  std::string name;
  Triangles triangles;        ///< `m x 3`, outward, closed.
  Points rest;                ///< `n x 3` mm, at which axes and segments are found.
  std::vector<Points> phases; ///< `n x 3` mm.
  /// For each triangle whether it closes a valve, as `capsOf` finds it; empty: it is found for each reading.
  std::vector<bool> caps = {};
};

/// The caps of a surface other than the left ventricle's cavity: of one without fans, the flat part at its
/// end `towardsBase`. O(n + m).
std::vector<bool> capsOf(const MovingSurface& surface, const Vec3& towardsBase);

/// The surfaces of a heart in motion; null for those that are not known.
struct MovingHeart {
  const MovingSurface* leftCavity = nullptr; ///< Never null.
  const MovingSurface* rightCavity = nullptr;
  const MovingSurface* outer = nullptr; ///< The epicardium, or the whole heart.
  const MovingSurface* leftAtrium = nullptr;
  std::vector<double> seconds; ///< Of the phases, ascending.
  std::size_t reference = 0;   ///< The phase that has no strain: the end of diastole.
};

/// The deformation gradients at the points of a wall in one phase, against the heart at rest.
using GradientsAt = std::function<void(std::size_t phase, std::vector<Eigen::Matrix3d>& gradients)>;

/// The moving tissue of a left ventricle's wall.
struct MovingWall {
  const WallPoints* points = nullptr;
  GradientsAt gradientsAt; ///< May be called from several threads.
};

/// A contour of length strain with its curve.
struct ContourStrain {
  std::string name;          ///< "fourChamber"
  double referenceMm = 0;    ///< Its length in the reference phase.
  std::vector<double> curve; ///< Change of length, a part; one a phase.
  Peak peak;                 ///< The shortest; of an atrium the longest.
};

/// One segment over the phases. Strain is engineering strain, a part.
struct SegmentStrain {
  int number = 0;
  int witnesses = 0;   ///< Witness points, or triangles of the endocardium where no wall is known.
  bool enough = false; ///< Whether they are `kFewestWitnesses` at least.
  std::vector<double> longitudinal, circumferential;
  std::vector<double> radial;      ///< Empty where no wall is known.
  std::vector<double> area;        ///< Change of the endocardium's area.
  std::vector<double> thicknessMm; ///< Empty where no outer surface is known; NaN where it is not measured.
  std::vector<double> thickening;  ///< Its change against the reference, a part; as `thicknessMm`.
};

inline constexpr int kFewestWitnesses = 20;

/// Everything that is measured.
struct HeartStrain {
  explicit HeartStrain(const FoundAxes& found)
      : axes(found.axes), oriented(found.oriented), septumDegrees(found.septumDegrees) {}

  HeartAxes axes;
  bool oriented;        ///< As in `FoundAxes`.
  double septumDegrees; ///< As in `FoundAxes`.
  std::vector<double> seconds;
  std::size_t reference = 0;
  bool wall = false; ///< Whether segments are of the wall, not of the endocardium alone.

  std::vector<ContourStrain> longitudinal;    ///< In the 4-, 2- and 3-chamber plane.
  std::vector<ContourStrain> circumferential; ///< At base, middle, apex.
  std::optional<ContourStrain> gls, gcs;      ///< Means of these curves.
  std::optional<ContourStrain> grs;           ///< Of the material across the wall; peak is the largest.
  std::optional<ContourStrain> materialLongitudinal, materialCircumferential; ///< Means over the wall.
  std::optional<ContourStrain> rightFreeWall;
  std::optional<ContourStrain> leftReservoir;
  std::vector<ContourStrain> others; ///< Listed contours of other names.
  std::vector<ContourStrain> areas;  ///< Of each surface without its valves.

  std::array<SegmentStrain, kSegments> segments; ///< By number; the first is number 1.
  std::vector<double> twistDegrees;        ///< Apex against base, seen from the apex; empty: not measured.
  std::vector<double> torsionDegreesPerCm; ///< The same by the distance of both rings.
  /// Standard deviation of the times to the peak of shortening of segments 1 to 16, s; along and around.
  double dispersionLongitudinal = 0, dispersionCircumferential = 0;

  const SegmentStrain& segment(int number) const { return segments[static_cast<std::size_t>(number - 1)]; }
};

/// A contour through vertices of one of the surfaces, instead of one that is found.
struct ListedContour {
  std::string name; ///< As the contours of `HeartStrain`: "fourChamber", "base", "rightFreeWall"; or another.
  std::string surface;                ///< Name of a surface.
  std::vector<std::int32_t> vertices; ///< Rows of its points, in order.
  bool closed = false;
};

/// The strain of a contour in all phases. `phases` are the points of its surface.
ContourStrain contourStrain(const std::string& name, const MaterialContour& contour,
                            const std::vector<Points>& phases, const std::vector<double>& seconds,
                            std::size_t reference);

/// Measures the strain of a heart.
///
/// Contours are material lines of the endocardium: in planes through the long axis at 90 degrees (4-chamber),
/// 150 (2-chamber) and 30 (3-chamber) behind the anterior insertion, from one side of the valves' rims over
/// the apex to the other, and across the axis at 1/4, 1/2 and 3/4 of its length. `listed` ones take the place
/// of those of the same name. Segments are means over witness points by the volume for which each stands, or
/// over triangles of the endocardium where `wall` is null.
///
/// Throws `DataError` for surfaces that axes cannot be found for, for a reference that is no phase, and for a
/// listed contour with a surface or a vertex that does not exist or less than two vertices; `Cancelled`.
/// O(phases x (points of the wall x handles + vertices log vertices)). Does not depend on the number of
/// threads.
///
///     const FoundAxes axes = findAxes(cavity, nullptr, {});
///     const HeartStrain strain = heartStrain(heart, axes, nullptr, {}, progress);
///     const double gls = strain.gls->peak.value; // -0.17: shorter by 17 %.
HeartStrain heartStrain(const MovingHeart& heart, const FoundAxes& axes, const MovingWall* wall,
                        const std::vector<ListedContour>& listed, Progress& progress, Threads threads = {});

} // namespace viscera::strain
