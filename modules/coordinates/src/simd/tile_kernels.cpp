#include "simd/tile_kernels.h"

#include "simd/pack.h"

namespace viscera::coordinates::simd::VISCERA_ISA {
namespace {

constexpr int kTile = 16;

/// Packs of x, y and z become rows of three. The loops have constant bounds, which the compiler turns into
/// shuffles.
inline void interleave(const Pack (&xyz)[3], double* rows) {
  for (int lane = 0; lane < kWidth; ++lane)
    for (int axis = 0; axis < 3; ++axis)
      rows[3 * lane + axis] = xyz[axis][lane];
}

inline void separate(const double* rows, Pack (&xyz)[3]) {
  for (int axis = 0; axis < 3; ++axis) {
    double lanes[kWidth];
    for (int lane = 0; lane < kWidth; ++lane)
      lanes[lane] = rows[3 * lane + axis];
    xyz[axis] = load(lanes);
  }
}

void multiply(const double* tile, const double* pose, long handles, double* points) {
  for (int first = 0; first < kTile; first += 2 * kWidth) {
    Pack low[3] = {}, high[3] = {};
    const double* column = tile + first;
    for (long handle = 0; handle < handles; ++handle, column += kTile) {
      const Pack a = load(column), b = load(column + kWidth);
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] += a * pose[3 * handle + axis];
        high[axis] += b * pose[3 * handle + axis];
      }
    }
    interleave(low, points + 3 * first);
    interleave(high, points + 3 * (first + kWidth));
  }
}

void addColumn(const double* column, const double* delta, double* points) {
  for (int lane = 0; lane < kTile; ++lane)
    for (int axis = 0; axis < 3; ++axis)
      points[3 * lane + axis] += column[lane] * delta[axis];
}

void addTransposed(const double* tile, const double* rows, long handles, double* sums) {
  for (int first = 0; first < kSumLanes; first += kWidth) {
    Pack low[3], high[3];
    separate(rows + 3 * first, low);
    separate(rows + 3 * (first + kSumLanes), high);
    const double* column = tile + first;
    double* sum = sums + first;
    for (long handle = 0; handle < handles; ++handle, column += kTile)
      for (int axis = 0; axis < 3; ++axis, sum += kSumLanes)
        store(sum, load(sum) + load(column) * low[axis] + load(column + kSumLanes) * high[axis]);
  }
}

void measure(const double* tile, const double* positions, long handles, const double* points, double* found) {
  for (int first = 0; first < kTile; first += kWidth) {
    Pack point[3], sum[3] = {}, unity{}, least = splat(1e300);
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = load(points + axis * kTile + first);
    for (long handle = 0; handle < handles; ++handle) {
      const Pack weight = load(tile + handle * kTile + first);
      for (int axis = 0; axis < 3; ++axis)
        sum[axis] += weight * (positions[3 * handle + axis] - point[axis]);
      unity += weight;
      least = smaller(weight, least);
    }
    for (int axis = 0; axis < 3; ++axis)
      store(found + axis * kTile + first, sum[axis]);
    store(found + 3 * kTile + first, unity);
    store(found + 4 * kTile + first, select(unity == unity, least, unity)); // A NaN stays visible.
  }
}

} // namespace

extern const TileKernels kTileKernels;
const TileKernels kTileKernels = {multiply, addColumn, addTransposed, measure};

} // namespace viscera::coordinates::simd::VISCERA_ISA
