#pragma once

#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/lesson/course.h"

/// Compresses a motion to a sum of few modes (singular value decomposition).
namespace viscera::lesson {

/// The displacements of carriers at the instants of a motion, `instants x carriers` for each axis. A carrier
/// is a handle, which moves the vertices by its weights.
struct Instants {
  Table x, y, z; ///< mm from rest.
};

/// `n x c`: the motion of the vertices is this times that of the carriers. Without columns the carriers are
/// the vertices themselves.
using CarrierWeights = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;

/// A motion as a sum of modes: at instant t vertex v is off its place at rest by `sum_k course(t, k) *
/// modes[k].row(v)`.
struct MotionModes {
  std::vector<Points> modes; ///< `n x 3` mm each; the largest |course| of each is 1.
  Table course;              ///< `instants x modes`.
};

/// The modes of the instants (their singular vectors, the method of snapshots, Sirovich 1987), the strongest
/// first, so many that no vertex is off by more than `toleranceMm` at any instant. The Gram matrix of the
/// instants comes from `W'W`, and only those of its rows are made that are needed (pivoted Cholesky): never a
/// matrix of all vertices and instants. O(n c^2 + instants c^2), c carriers. Throws `Cancelled`.
MotionModes modesOf(const Instants& instants, const CarrierWeights& weights, double toleranceMm,
                    Progress& progress, Threads threads);

/// The largest distance of a vertex, mm, when the courses of `modes` differ by one row of `differences`, over
/// all rows: exact, although only few rows are looked at in full. `row` is the one.
struct LargestDifference {
  double mm = 0;
  Eigen::Index row = 0;
};
LargestDifference largestDifference(const std::vector<Points>& modes, const Table& differences);

} // namespace viscera::lesson
