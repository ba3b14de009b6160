#pragma once

#include <cstdint>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/error.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/elasticity/elastic_body.h"

/// The equilibrium of an elastic body under prescribed displacements and pressures.
namespace viscera::elasticity {

/// A displacement that a node has along one axis (0, 1, 2); 0 mm holds it.
struct Prescribed {
  std::int32_t node = 0;
  int axis = 0;
  double displacementMm = 0;
};

/// A pressure on faces from outside the body, which follows them as they turn and grow.
struct Pressure {
  std::vector<Face> faces;
  double kpa = 0;
};

/// What acts on a body. Together the prescribed displacements must hold it against rigid motions.
struct Loads {
  std::vector<Prescribed> prescribed; ///< Each node and axis once at most.
  std::vector<Pressure> pressures;
};

/// How the equilibrium is searched.
struct SolveOptions {
  int loadSteps = 1;          ///< At the start; a step that fails is halved.
  double smallestStep = 1e-3; ///< A part of the load; below that the search gives up.
  double tolerance = 1e-8;    ///< The forces out of balance, by all forces.
  int mostIterations = 30;    ///< Newton steps in one load step.
  Threads threads;
};

/// An equilibrium.
struct StaticSolution {
  Values state;         ///< The body's unknowns: displacements (mm), then pressures (kPa).
  Points displacements; ///< `nodes x 3`, mm.
  double energyMj = 0;  ///< The elastic energy stored, mJ (kPa ml).
  double smallestJacobian = 1, largestJacobian = 1; ///< det F over the quadrature points.
  int loadSteps = 0;                                ///< That were needed.
  int iterations = 0;                               ///< Newton steps, all together.
  double imbalance = 0; ///< Of the last Newton step: forces out of balance by all forces.
};

/// Thrown when no equilibrium is found: the load is too large for the mesh, or the body is not held.
class NoEquilibrium final : public DataError {
public:
  /// `reached` is the part of the load up to which there was one.
  explicit NoEquilibrium(double reached);
  double reached() const { return reached_; }

private:
  double reached_;
};

/// The equilibrium of `body` under `loads`: Newton's method on the mixed energy from the body at rest, in
/// load steps that are halved where it fails. The tangent of pressures is made symmetric, which costs
/// iterations on open faces and changes no result. Throws `NoEquilibrium`, `Cancelled`, and `DataError` for a
/// node, an axis or a face that does not exist. The same answer for any number of threads.
StaticSolution solveStatic(const ElasticBody& body, const Loads& loads, const SolveOptions& options,
                           Progress& progress);

/// The von Mises stress of a body over its volume at rest, kPa.
struct TissueStress {
  double mean = 0;
  double p95 = 0; ///< Below it is the stress in 95 % of the volume.
  double max = 0; ///< Over the quadrature points.
};

/// The stress of `body` at `state`, the unknowns of a solution. O(tetrahedra log tetrahedra).
TissueStress tissueStress(const ElasticBody& body, const Values& state);

/// Adds the forces and the symmetric part of the tangent of a pressure `kpa` on a face to the share of its
/// tetrahedron at `state`.
void addPressure(const ElasticBody& body, const Face& face, double kpa, const Values& state,
                 ElementShare& share);

} // namespace viscera::elasticity
