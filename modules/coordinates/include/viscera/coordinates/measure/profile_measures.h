#pragma once

#include "viscera/core/arrays.h"

/// Small measures of coordinates that are known, `points x handles`.
namespace viscera::coordinates {

/// The root mean square of the second differences from row to row: noise is large here, a smooth curve is
/// not. Rows that are not numbers are passed over; not a number where no three rows in a row are.
double roughness(const Eigen::MatrixXd& coordinates);

/// The mean over the points of what the nearer half of the handles have of all influence, by absolute values:
/// 1 for a system that is very local, 1/2 for one that does not look at distances. Rows without coordinates
/// (zeros) do not count.
double nearHalfShare(const Points& handles, const Points& points, const Eigen::MatrixXd& coordinates);

} // namespace viscera::coordinates
