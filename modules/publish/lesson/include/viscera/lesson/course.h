#pragma once

#include <vector>

#include "viscera/core/arrays.h"

/// Splines through numbers that change over a cycle, known at some instants and smooth between them.
namespace viscera::lesson {

/// One row for each instant, one column for each mode (or other quantity over the cycle).
using Table = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Whether a course continues with its first instant after the last one, or ends there.
enum class CourseEnd { cycles, stops };

/// A piecewise cubic curve (Hermite's form) of several numbers over a cycle.
struct Course {
  std::vector<double> instants; ///< Fractions of the cycle, ascending: k >= 2, the first 0, the last 1.
  Table values;                 ///< `k x modes`.
  Table slopes;                 ///< `k x modes`, a cycle.
};

/// The twice differentiable cubic spline through `values` (`k x modes`; of a cycle the last row is the first
/// one, de Boor 2001, chapter 4). O(k modes).
Course splineThrough(std::vector<double> instants, Table values, CourseEnd end);

/// The value of a course at `fraction` of the cycle, [0, 1]: `modes` numbers. The page computes it in the
/// same way.
Eigen::VectorXd valueAt(const Course& course, double fraction);

/// The fraction of the cycle at which the `sample` is of `samples` that are spread evenly.
double fractionOf(Eigen::Index sample, Eigen::Index samples, CourseEnd end);

} // namespace viscera::lesson
