#pragma once

#include <vector>

#include "viscera/core/arrays.h"

/// Numbers that follow a cycle: known at evenly spaced instants, smooth between them.
namespace viscera::lesson {

/// `samples x modes` numbers over a cycle, the first at 0.
using Course = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// How a course goes on behind its last sample: at the first one, a step later; or it ends there, at the end
/// of the cycle, and jumps.
enum class CourseEnd { cycles, stops };

/// The weights of a cubic B-spline that runs through all samples (Unser 1999, doi 10.1109/79.799930), as many
/// as samples. O(samples modes).
Course splineThrough(const Course& samples, CourseEnd end);

/// The value of a spline at `fraction` of the cycle, [0, 1]: `modes` numbers. As the page does it.
Eigen::VectorXd valueAt(const Course& spline, CourseEnd end, double fraction);

/// The fraction of the cycle at which a sample is.
double fractionOf(Eigen::Index sample, Eigen::Index samples, CourseEnd end);

} // namespace viscera::lesson
