#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/elasticity/elastic_organ.h"
#include "viscera/elasticity/static_solution.h"
#include "viscera/geometry/triangle_mesh.h"

/// A pose of handles beside the elastic organ that the same handles grip: how far one is from the other.
namespace viscera::live {

/// A pose to compare. What it refers to must live as long as the question.
struct ElasticQuestion {
  const Points& surface; ///< The organ's vertices at rest, `n x 3` mm.
  const Points& posed;   ///< The same in the pose of the handles.
  const Points& rest;    ///< The handles at rest, `h x 3` mm.
  const Points& pose;    ///< The same in the pose.
  elasticity::GripOptions grips = {};
  /// The patches move as the posed surface does at their nodes, in place of as the handles do.
  bool gripSurface = false;
  Threads threads = {};
};

/// How far two surfaces with the same vertices are apart, mm.
struct SurfacesApart {
  double medianMm = 0, p95Mm = 0, maxMm = 0;
};

/// The distances of corresponding vertices, summed up. Both have the same number of rows, one at least.
/// O(n log n).
SurfacesApart surfacesApart(const Points& a, const Points& b);

/// The elastic organ beside the pose.
struct ElasticComparison {
  Points elastic;     ///< The organ's vertices as elasticity moves them, `n x 3` mm.
  Values distancesMm; ///< Of each vertex in the pose from the same one there.
  SurfacesApart apart;
  elasticity::Grips grips;
  elasticity::StaticSolution solution;
};

/// Solves the elastic organ under the handles of the question and compares. `organ` was made of the same
/// surface. Takes a second for 600 tetrahedra, more where the drag is large. Throws `DataError` when no
/// handle moves, `elasticity::NoEquilibrium`, and `Cancelled`. The same answer for any number of threads.
ElasticComparison besideElasticity(const elasticity::ElasticOrgan& organ, const ElasticQuestion& question,
                                   Progress& progress);

/// The same drag on a mesh of one size.
struct MeshOfSize {
  Eigen::Index tetrahedra = 0; ///< As many as there are, not as were asked for.
  double edgeMm = 0;           ///< Of a regular tetrahedron of their mean volume.
  SurfacesApart fromFinest;    ///< Its elastic surface from that on the finest mesh; 0 for this itself.
  SurfacesApart fromPose;      ///< Its elastic surface from that of the handles' pose.
  double smallestJacobian = 1;
  double seconds = 0; ///< Of one solution, with the mesh. Differs between runs, as nothing else here does.
};

/// How the elastic displacement depends on the size of tetrahedra.
struct MeshConvergence {
  std::vector<MeshOfSize> meshes; ///< Ascending by tetrahedra.
  /// The slope of the logarithm of the median distance from the finest over that of the edge, by least
  /// squares over all meshes but the finest; NaN with less than two of them.
  double order = 0;
};

/// Solves the question on meshes of `surface` with about as many tetrahedra as `sizes` says, one after the
/// other. Throws what `besideElasticity` and the constructor of `ElasticOrgan` throw, and `UsageError` for
/// less than two sizes.
MeshConvergence meshConvergence(const geometry::TriangleMesh& surface,
                                const std::shared_ptr<const elasticity::Material>& material,
                                const std::vector<int>& sizes, const ElasticQuestion& question,
                                Progress& progress);

} // namespace viscera::live
