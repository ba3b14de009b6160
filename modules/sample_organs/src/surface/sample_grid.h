#pragma once

#include <array>
#include <vector>

#include "implicit/implicit_node.h"
#include "surface/progress_span.h"
#include "viscera/core/parallel.h"

namespace viscera::sample_organs {

/// Values of an implicit surface on a regular grid, x fastest. Exact near the surface; elsewhere only the
/// sign is.
struct SampleGrid {
  Vec3 origin = Vec3::Zero(); ///< mm
  double spacing = 1;         ///< mm
  std::array<int, 3> size = {0, 0, 0};
  std::vector<float> values; ///< mm, negative inside; never nearer to zero than a small share of the spacing.
};

/// Samples a box around the node's extent. Divides blocks of 32^3 points down to 2^3 wherever the surface may
/// pass. Bitwise independent of the number of threads. Throws `DataError` for a field that is not finite, and
/// for a grid of more than 2^30 points; `Cancelled`.
SampleGrid sampleGrid(const ImplicitNode& node, double spacing, Threads threads,
                      const ProgressSpan& progress);

} // namespace viscera::sample_organs
