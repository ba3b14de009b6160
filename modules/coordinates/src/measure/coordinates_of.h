#pragma once

#include <limits>

#include "viscera/coordinates/binding.h"

namespace viscera::coordinates {

/// `points x handles`; rows of points without coordinates are not numbers.
inline Eigen::MatrixXd coordinatesOf(const Binding& binding) {
  Eigen::MatrixXd values(binding.pointCount(), binding.handleCount());
  for (int handle = 0; handle < static_cast<int>(values.cols()); ++handle)
    values.col(handle) = binding.influence(handle);
  for (const int failed : binding.report().failures)
    values.row(failed).setConstant(std::numeric_limits<double>::quiet_NaN());
  return values;
}

} // namespace viscera::coordinates
