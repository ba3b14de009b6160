#pragma once

#include <filesystem>

#include <Eigen/Core>

namespace viscera::app::cli {

/// `points x handles` coordinates, row major.
using Weights = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Writes a matrix as NumPy's own format, version 1.0: `numpy.load` gives `rows x cols` of float64. Atomic.
/// Throws `CannotCreateError`. The format:
/// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
void writeNpy(const std::filesystem::path& file, const Weights& matrix);

} // namespace viscera::app::cli
