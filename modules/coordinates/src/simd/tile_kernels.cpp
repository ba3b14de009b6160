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

/// The factors of the numbers of a tile's points.
inline Pack factors(const double*, long, int) {
  return splat(1);
}
inline Pack factors(const float* tile, long handles, int first) {
  return load(tile + handles * kTile + first) + 1.0;
}

template <class Number>
void multiply(const Number* tile, const double* pose, long handles, double* points) {
  for (int first = 0; first < kTile; first += 2 * kWidth) {
    Pack low[3] = {}, high[3] = {};
    const Number* column = tile + first;
    for (long handle = 0; handle < handles; ++handle, column += kTile) {
      const Pack a = load(column), b = load(column + kWidth);
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] += a * pose[3 * handle + axis];
        high[axis] += b * pose[3 * handle + axis];
      }
    }
    const Pack lowFactor = factors(tile, handles, first), highFactor = factors(tile, handles, first + kWidth);
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] *= lowFactor;
      high[axis] *= highFactor;
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

void addColumnSingle(const float* tile, long handle, long handles, const double* delta, double* points) {
  const float *column = tile + handle * kTile, *more = tile + handles * kTile;
  for (int lane = 0; lane < kTile; ++lane) {
    const double weight = static_cast<double>(column[lane]) * (1.0 + static_cast<double>(more[lane]));
    for (int axis = 0; axis < 3; ++axis)
      points[3 * lane + axis] += weight * delta[axis];
  }
}

template <class Number>
void addTransposed(const Number* tile, const double* rows, long handles, double* sums) {
  for (int first = 0; first < kSumLanes; first += kWidth) {
    Pack low[3], high[3];
    separate(rows + 3 * first, low);
    separate(rows + 3 * (first + kSumLanes), high);
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] *= factors(tile, handles, first);
      high[axis] *= factors(tile, handles, first + kSumLanes);
    }
    const Number* column = tile + first;
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
      // sum a_i (v_i - p), which is sum a_i v_i - p where unity holds, without the digits that large
      // positions would take from the difference.
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

void roundTile(double* tile, long handles, float* single) {
  for (int first = 0; first < kTile; first += kWidth) {
    Pack kept{}, lost{};
    for (long handle = 0; handle < handles; ++handle) {
      const Pack exact = load(tile + handle * kTile + first);
      float* rounded = single + handle * kTile + first;
      store(rounded, select(magnitude(exact) < kLeastSingle, Pack{}, exact));
      const Pack back = load(rounded);
      kept += back;
      lost += exact - back;
    }
    // Rounding a_i to b_i makes the factor f = sum a_i / sum b_i = 1 + sum (a_i - b_i) / sum b_i; what is
    // kept is f - 1, which a single number holds to more digits than f.
    const Pack more = lost / kept;
    const Mask usable =
        (magnitude(lost) < kMostCorrection * magnitude(kept)) & (magnitude(more) >= kLeastSingle);
    store(single + handles * kTile + first, select(usable, more, Pack{}));
    const Pack factor = factors(single, handles, first);
    for (long handle = 0; handle < handles; ++handle)
      store(tile + handle * kTile + first, load(single + handle * kTile + first) * factor);
  }
}

} // namespace

extern const TileKernels kTileKernels;
const TileKernels kTileKernels = {multiply<double>, addColumn,           addTransposed<double>,
                                  measure,          roundTile,           multiply<float>,
                                  addColumnSingle,  addTransposed<float>};

} // namespace viscera::coordinates::simd::VISCERA_ISA
