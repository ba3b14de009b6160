#pragma once

/// The loops of `CornerDeterminants`, compiled for several instruction sets.
namespace viscera::coordinates::simd {

/// Columns (handles) that the loops take at once, and rows of sums.
inline constexpr int kPanel = 16;
inline constexpr int kStrip = 4;

struct DeterminantKernels {
  /// Fills the panel (`points x kPanel`) from rows of `weights` with `stride` numbers each: its row p is the
  /// sum of `w(r, k) w(q, first to first + 15) - w(q, k) w(r, first to first + 15)` over the pairs of corners
  /// q, r from `starts[p]` to `starts[p + 1]`. Says whether any w(q, k) or w(r, k) was not zero.
  bool (*gather)(const double* weights, long stride, long k, long first, const long* starts,
                 const int* corners, long points, double* panel);

  /// `sums` (`kStrip x kPanel`, `stride` numbers a row) grow by the transposed strip (`points x kStrip`)
  /// times the panel (`points x kPanel`).
  void (*multiply)(const double* strip, const double* panel, long points, double* sums, long stride);
};

namespace baseline {
extern const DeterminantKernels kDeterminantKernels;
}
namespace avx2 {
extern const DeterminantKernels kDeterminantKernels;
}
namespace avx512 {
extern const DeterminantKernels kDeterminantKernels;
}

} // namespace viscera::coordinates::simd
