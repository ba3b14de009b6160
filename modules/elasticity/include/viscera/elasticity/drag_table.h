#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "viscera/coordinates/measure/system_properties.h"
#include "viscera/elasticity/elastic_organ.h"

/// Coordinate systems beside elasticity: the same drags of the same handles on the same organs.
namespace viscera::elasticity {

/// How many drags, how far, and on which mesh.
struct DragOptions {
  int drags = 20;             ///< Of one handle each, different ones while there are enough.
  double dragFraction = 0.05; ///< The length of a drag, by the diagonal of the organ's box.
  int points = 400;           ///< Vertices of the surface at which displacements are compared.
  int witnesses = 300;        ///< Places inside at which the rotational stress is compared, at most.
  int handles = 30;           ///< Around an organ.
  double gap = 0.03;          ///< Between handles and organ at least, by the diagonal of the organ's box.
  double poisson = 0.49;      ///< Of the neo-Hookean material.
  std::uint32_t seed = 1;     ///< Of handles and directions.
  OrganOptions organ;         ///< Tetrahedra.
  GripOptions grips;          ///< Patches, and what becomes of those that do not move.
};

/// An organ among its handles, and where it is compared.
struct DragScene {
  std::string organ;
  coordinates::HandleSet handles; ///< With the cage, no groups.
  double diagonalMm = 0;          ///< Of the organ's box.
  std::shared_ptr<const ElasticOrgan> elastic;
  std::vector<Eigen::Index> vertices;   ///< Rows of the surface that are compared.
  Points points;                        ///< Those vertices, `n x 3` mm.
  Points witnesses;                     ///< The middles of tetrahedra, spread evenly, `w x 3` mm.
  std::vector<Eigen::Index> tetrahedra; ///< Those of the witnesses.
  Points surface;                       ///< All vertices, `v x 3` mm.
};

/// The elastic answer to one drag.
struct ElasticDrag {
  int handle = 0;
  double dragMm = 0;
  int halved = 0;       ///< How often the drag was halved until there was an equilibrium.
  std::string refusal;  ///< Why there is none at all; the members below are then empty.
  Points pose;          ///< Of the handles.
  Points displacements; ///< Of the scene's points, mm.
  Values stress;        ///< Rotational stress at the scene's witnesses, rad.
  double smallestJacobian = 1;
  double seconds = 0;
};

/// A scene with all its drags.
struct SolvedScene {
  DragScene scene;
  std::vector<ElasticDrag> drags;

  std::size_t solved() const; ///< Drags with an equilibrium.
};

/// Handles that every coordinate system can use, with a cage and without: all are corners of one convex hull,
/// which is the cage, around the points of a surface (`n x 3` mm). In each of evenly spread directions there
/// is one, `gap` of the diagonal of the surface's box beyond the point that is farthest in this direction, or
/// as far beyond as the hull needs to hold all points. Deterministic. Throws `DataError` for too few handles.
/// O(n handles).
coordinates::HandleSet hullAround(const Points& surface, int handles, double gap);

/// The organ filled with tetrahedra among `handles`. Throws what `ElasticOrgan` throws.
DragScene dragScene(const std::string& name, const geometry::TriangleMesh& surface,
                    coordinates::HandleSet handles, const DragOptions& options, Progress& progress);

/// What a solution is at the points and witnesses of the scene.
ElasticDrag readDrag(const DragScene& scene, const Points& pose, const StaticSolution& solution);

/// Solves the drags of all scenes, several at a time on `threads`: handle after handle in an order drawn by
/// the seed, each in a direction drawn by it. A drag without equilibrium is halved, three times at most.
/// Seconds for a drag on 600 tetrahedra. The same for any number of threads, but for the time. Throws
/// `Cancelled`.
std::vector<SolvedScene> solveDrags(std::vector<DragScene> scenes, const DragOptions& options,
                                    Threads threads, Progress& progress);

/// One drag by a coordinate system beside elasticity.
struct DragDifference {
  double median = 0, p95 = 0; ///< Between the points' places, per cent of the drag.
  /// The root of the mean squared difference by that of the elastic displacements, per cent: 100 for a system
  /// that moves nothing.
  double relative = 0;
  double spearman = 0; ///< Rank correlation of the rotational stress at the witnesses; NaN where one is even.
};

/// A coordinate system on one organ.
struct SystemOnOrgan {
  std::string organ;
  std::string refusal;               ///< Why the system cannot pose the organ; else empty.
  std::vector<DragDifference> drags; ///< One for each solved drag.
  double bindSeconds = 0;            ///< Coordinates of the points, on one thread.
  double poseMilliseconds = 0;       ///< One pose of the points, on one thread.
  Eigen::Index lostWitnesses = 0;    ///< Without coordinates; left out of the rank correlation.
};

/// A coordinate system on all organs.
struct SystemDrags {
  std::string id, name;
  std::vector<SystemOnOrgan> organs;

  std::size_t drags() const;     ///< Of all organs.
  DragDifference middle() const; ///< The median over all drags of each number.
  double bindSeconds() const;    ///< The mean over the organs.
  double poseMilliseconds() const;
};

/// Every variant on every scene, several at a time on `threads`, each with one thread. A system with groups
/// gets three along the organ, with the handles that these add, which stay at rest. Cage systems get the
/// scene's cage. Any exception of a system becomes its refusal; only `Cancelled` is rethrown. The same for
/// any number of threads, but for the times.
std::vector<SystemDrags> compareDrags(const std::vector<coordinates::SystemVariant>& variants,
                                      const std::vector<SolvedScene>& scenes, Threads threads,
                                      Progress& progress);

/// Spearman's rank correlation; equal numbers have the mean of their ranks. NaN where all of one are equal.
double rankCorrelation(const Values& a, const Values& b);

/// The value below which a part of the numbers lies (0.5: the lower median); NaN for none.
double quantileOf(std::vector<double> numbers, double part);

} // namespace viscera::elasticity
