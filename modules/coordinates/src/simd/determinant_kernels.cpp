#include "simd/determinant_kernels.h"

#include "simd/pack.h"

namespace viscera::coordinates::simd::VISCERA_ISA {
namespace {

/// Packs of a row that stay in registers: two of them and four rows of sums fit everywhere.
constexpr int kColumns = 2 * kWidth;

bool gather(const double* weights, long stride, long k, long first, const long* starts, const int* corners,
            long points, double* panel) {
  bool felt = false;
  for (long point = 0; point < points; ++point)
    for (int column = 0; column < kPanel; column += kColumns, panel += kColumns) {
      Pack low{}, high{};
      for (long item = starts[point]; item < starts[point + 1]; item += 2) {
        const double *q = weights + corners[item] * stride, *r = weights + corners[item + 1] * stride;
        const double atQ = q[k], atR = r[k];
        felt = felt || atQ != 0 || atR != 0;
        q += first + column;
        r += first + column;
        low += load(q) * atR - load(r) * atQ;
        high += load(q + kWidth) * atR - load(r + kWidth) * atQ;
      }
      store(panel, low);
      store(panel + kWidth, high);
    }
  return felt;
}

void multiply(const double* strip, const double* panel, long points, double* sums, long stride) {
  for (int first = 0; first < kPanel; first += kColumns) {
    Pack low[kStrip], high[kStrip];
    for (int row = 0; row < kStrip; ++row) {
      low[row] = load(sums + row * stride + first);
      high[row] = load(sums + row * stride + first + kWidth);
    }
    const double *left = strip, *right = panel + first;
    for (long point = 0; point < points; ++point, left += kStrip, right += kPanel) {
      const Pack a = load(right), b = load(right + kWidth);
      for (int row = 0; row < kStrip; ++row) {
        low[row] += a * left[row];
        high[row] += b * left[row];
      }
    }
    for (int row = 0; row < kStrip; ++row) {
      store(sums + row * stride + first, low[row]);
      store(sums + row * stride + first + kWidth, high[row]);
    }
  }
}

} // namespace

extern const DeterminantKernels kDeterminantKernels;
const DeterminantKernels kDeterminantKernels = {gather, multiply};

} // namespace viscera::coordinates::simd::VISCERA_ISA
