#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"
#include "viscera/deformation/volume_lock.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/elasticity/material.h"

/// Poses of least elastic energy: the handles that are not moved go where the tissue would take them.
namespace viscera::elasticity {

/// The energy of a deformation gradient F by the shear modulus, finite for folded tissue too:
/// `|F|^2 / 2 - 3 / 2 - (J - 1) + ratio (J - 1)^2 / 2`, with J = det F. For small strains it is Hooke's law
/// where `ratio` is 1 + lambda / mu (Smith, De Goes and Kim 2018, doi:10.1145/3180491, without the
/// logarithm).
class StableNeoHookean {
public:
  /// `poisson` above 0 and below 0.5. Throws `UsageError` for other values.
  explicit StableNeoHookean(double poisson);

  double energy(const Eigen::Matrix3d& f) const;
  /// First Piola-Kirchhoff, dW/dF.
  Eigen::Matrix3d stress(const Eigen::Matrix3d& f) const;
  /// The second derivative, symmetric.
  Tangent tangent(const Eigen::Matrix3d& f) const;
  /// The same with its negative eigenvalues set to zero, by their closed form in the frame of F's singular
  /// values (section 4 of the paper).
  Tangent projectedTangent(const Eigen::Matrix3d& f) const;

private:
  double ratio_;
};

/// The tissue of an organ: derivatives of the coordinates at witness points, and how much of the organ each
/// of them stands for.
struct WitnessedTissue {
  std::shared_ptr<const deformation::WitnessGradients> gradients;
  Values volumesMm3; ///< Of the first witnesses; those behind have none.
};

/// The volume that each witness stands for, mm^3: its share of the tetrahedra around it, whose other corners
/// on the skin have none. `witnesses` numbers. O(t).
Values witnessVolumes(const deformation::WitnessMesh& mesh);

/// A pose of least energy, and how it was found.
struct RelaxedPose {
  Points pose;            ///< `n x 3` mm.
  double energy = 0;      ///< As `LeastEnergy::energy`.
  int steps = 0;          ///< Newton steps.
  bool converged = false; ///< The last step moved no handle by more than the tolerance.
};

/// The elastic energy of tissue in any pose of its handles, and the pose in which it is least while some of
/// the handles stay. The gradient of the deformation is linear in the handles, so that the energy at the
/// witness points has closed derivatives; Newton's method with a line search minimises it, and keeps the
/// volumes of a lock as equality constraints (sequential quadratic programming with an l1 merit function,
/// Nocedal and Wright 2006, algorithm 18.3).
///
/// Handles that hardly touch the tissue would have no place of their own: weak springs between neighbouring
/// handles, which a rigid motion does not stretch, let them follow. They have a thousandth of the tissue's
/// stiffness.
///
/// Immutable, thread-safe. Results are bitwise independent of the number of threads.
class LeastEnergy {
public:
  struct Options {
    /// Coordinates of a few handles cannot keep the volume everywhere: nearer to 0.5 the tissue would be too
    /// stiff to bend.
    double poisson = 0.45;
    Threads threads = {};
  };
  struct Relaxing {
    double tolerance = 1e-4; ///< Of a handle's last step, by the diagonal of the handles at rest.
    int mostSteps = 40;
  };

  /// `rest` are the handles at rest, `n x 3` mm. Witnesses without coordinates are left out. Throws
  /// `DataError` when none is left, or where coordinates are not linear in the pose (Green coordinates).
  /// O(witnesses x handles).
  LeastEnergy(const std::vector<WitnessedTissue>& tissue, const Points& rest, const Options& options);
  LeastEnergy(const std::vector<WitnessedTissue>& tissue, const Points& rest)
      : LeastEnergy(tissue, rest, Options()) {}

  Eigen::Index handles() const { return rest_.rows(); }
  Eigen::Index witnesses() const { return shares_.size(); }

  /// The mean energy of the tissue per volume and shear modulus, without unit: zero at rest and in rigid
  /// motions. O(witnesses x handles).
  double energy(const Points& pose) const;
  /// The same with its derivative with respect to the handles, resized to `n x 3`, 1/mm: cheaper together.
  double energy(const Points& pose, Points& gradient) const;
  /// Its derivative with respect to the handles, `n x 3`, 1/mm.
  Points gradient(const Points& pose) const;
  /// Its second derivative with respect to the handles `free`, `3 f x 3 f`, 1/mm^2, made positive
  /// semi-definite at each witness; row `3 i + a` is handle `free[i]` along axis a. In single precision.
  /// O(witnesses x free^2).
  Eigen::MatrixXd stiffness(const Points& pose, const std::vector<int>& free) const;

  /// Moves the handles `free` (ascending) from where they are in `start` to where the energy is least; the
  /// others stay. With a `lock` the volumes are kept to about 1e-8, for `VolumeLock::restore` to finish; the
  /// energy may then be above that of `start`, else it is not. Without free handles the pose is `start`. A
  /// start near to the answer, such as that of the drag before, costs least.
  RelaxedPose relax(const Points& start, const std::vector<int>& free, const Relaxing& relaxing,
                    const deformation::VolumeLock* lock = nullptr) const;
  RelaxedPose relax(const Points& start, const std::vector<int>& free,
                    const deformation::VolumeLock* lock = nullptr) const {
    return relax(start, free, Relaxing(), lock);
  }

private:
  struct Spring {
    Eigen::Index a, b;
    double lengthMm;
  };
  Points springs(const Points& pose, double& energy) const;
  void addSprings(const Points& pose, const std::vector<int>& free, Eigen::MatrixXd& stiffness) const;
  double evaluate(const Points& pose, Points* gradient) const;

  Points rest_;
  StableNeoHookean material_;
  Threads threads_;
  Values shares_; ///< Of each witness in the whole volume.
  /// `handles x 3 witnesses`: column `3 w + J` holds the derivatives of all coordinates at w along axis J.
  Eigen::MatrixXd derivatives_;
  std::vector<Spring> springs_;
};

} // namespace viscera::elasticity
