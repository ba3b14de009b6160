#pragma once

#include <vector>

#include "viscera/coordinates/binding.h"
#include "viscera/coordinates/zeroed_memory.h"
#include "viscera/core/arrays.h"

namespace viscera::coordinates {

/// Sums determinants of coordinates over the triangles of a surface, the coefficients of its volume form. The
/// coordinates of a triangle's three corners p, q, r by three handles i, j, k are a 3 x 3 matrix, whose
/// determinants are summed over all triangles: `D_ijk = sum_pqr det [a_i(p) a_j(p) a_k(p); a_i(q) a_j(q)
/// a_k(q); a_i(r) a_j(r) a_k(r)]`. By the formula of Cauchy and Binet, `D_ijk / 6` are the coefficients of
/// the surface's volume as a cubic form of the handles. Immutable, thread-safe.
///
///     const CornerDeterminants determinants(binding, triangles);
///     CornerDeterminants::Sums sums;
///     determinants.ofHandle(7, sums); // sums(i, j) is D_ij7 for i < j < 7
class CornerDeterminants {
public:
  using Sums = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// Takes a copy of the coordinates: O(points x handles) memory. Throws `std::bad_alloc`.
  CornerDeterminants(const Binding& binding, const Triangles& triangles);

  Eigen::Index handles() const { return handles_; }

  /// `sums(i, j)` becomes `D_ijk` for `i < j < k`; its other entries are undefined, and its size is at least
  /// `k x k`. `O(points x k^2)`, one half of a product of matrices; AVX-512, AVX2 or plain code, by
  /// `vectorBits`.
  void ofHandle(Eigen::Index k, Sums& sums) const;

private:
  const double* row(Eigen::Index point) const { return weights_.get() + point * stride_; }
  Eigen::Index points_;
  Eigen::Index handles_;
  Eigen::Index stride_;      ///< Numbers in a row of weights: the handles, padded.
  ZeroedMemory weights_;     ///< `points x stride`.
  std::vector<long> starts_; ///< Of each point's corners, two for each triangle at it.
  std::vector<int> corners_; ///< The triangle's next corner q and its last one r, in turns.
};

} // namespace viscera::coordinates
