#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"

namespace viscera::geometry {

/// Stands for "no such voxel" in squared distances.
inline constexpr float kNoneSquared = 1e18F;

/// Finds for every voxel the squared distance, mm^2, to the nearest with `mask` at `value`, measured along
/// the axes for which `along` is true only (exact; Felzenszwalb and Huttenlocher 2012, doi
/// 10.4086/toc.2012.v008a019). `kNoneSquared` or more where there is none. O(voxels); bitwise independent of
/// the number of threads.
std::vector<float> squaredDistances(const std::vector<std::uint8_t>& mask, std::uint8_t value,
                                    const std::array<int, 3>& size, const Vec3& spacing,
                                    const std::array<bool, 3>& along, Threads threads);

} // namespace viscera::geometry
