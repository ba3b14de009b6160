#pragma once

#include "simd/pack_math.h"

/// Linear algebra for vectors and symmetric matrices of two or three dimensions, one in each lane of a pack.
/// A symmetric matrix is its lower triangle by rows.
namespace viscera::coordinates::simd::VISCERA_ISA {

template <int Dim>
Pack dot(const Pack (&a)[Dim], const Pack (&b)[Dim]) {
  Pack sum = a[0] * b[0];
  for (int axis = 1; axis < Dim; ++axis)
    sum += a[axis] * b[axis];
  return sum;
}

/// `step = -H^-1 g` by an LDL^T factorisation whose pivots are kept positive.
template <int Dim, int Size>
void newtonStep(const Pack (&hessian)[Size], const Pack (&gradient)[Dim], Pack (&step)[Dim]) {
  static_assert(Size == Dim * (Dim + 1) / 2);
  constexpr double kLeastPivot = 1e-30; // Of the trace.
  Pack lower[Dim][Dim], pivot[Dim], trace{};
  for (int row = 0; row < Dim; ++row)
    trace += hessian[row * (row + 1) / 2 + row];
  for (int row = 0; row < Dim; ++row) {
    step[row] = -gradient[row];
    pivot[row] = hessian[row * (row + 1) / 2 + row];
    for (int column = 0; column < row; ++column) {
      Pack entry = hessian[row * (row + 1) / 2 + column];
      for (int k = 0; k < column; ++k)
        entry -= lower[row][k] * lower[column][k] * pivot[k];
      lower[row][column] = entry / pivot[column];
      step[row] -= lower[row][column] * step[column];
      pivot[row] -= lower[row][column] * entry;
    }
    pivot[row] = larger(pivot[row], trace * kLeastPivot);
  }
  for (int row = Dim - 1; row >= 0; --row) {
    step[row] = step[row] / pivot[row];
    for (int below = row + 1; below < Dim; ++below)
      step[row] -= lower[below][row] * step[below];
  }
}

/// One rotation of Jacobi's method: makes `full[p][q]` zero and turns `directions` along.
template <int Dim>
void rotate(Pack (&full)[Dim][Dim], Pack (&directions)[Dim][Dim], int p, int q) {
  const Pack off = full[p][q];
  const Mask zero = off == 0.0;
  // The tangent of the turn is the smaller root of t^2 + 2 theta t - 1 = 0, theta = (a_qq - a_pp) / (2 a_pq),
  // in the form that does not cancel; then a_pp falls by t a_pq and a_qq rises by it.
  const Pack theta = (full[q][q] - full[p][p]) / (2.0 * select(zero, splat(1), off));
  const Pack size = larger(theta, -theta);
  Pack tangent = 1.0 / (size + squareRoot(theta * theta + 1.0));
  tangent = select(zero, Pack{}, select(theta < 0.0, -tangent, tangent));
  const Pack cosine = 1.0 / squareRoot(tangent * tangent + 1.0), sine = tangent * cosine;
  full[p][p] -= tangent * off;
  full[q][q] += tangent * off;
  full[p][q] = full[q][p] = Pack{};
  for (int k = 0; k < Dim; ++k) {
    if (k != p && k != q) {
      const Pack kp = full[k][p], kq = full[k][q];
      full[k][p] = full[p][k] = cosine * kp - sine * kq;
      full[k][q] = full[q][k] = sine * kp + cosine * kq;
    }
    const Pack atP = directions[p][k], atQ = directions[q][k];
    directions[p][k] = cosine * atP - sine * atQ;
    directions[q][k] = sine * atP + cosine * atQ;
  }
}

/// The unit eigenvectors as rows, that of the largest eigenvalue first, by Jacobi's method: it finds small
/// eigenvalues beside large ones as well as the entries allow.
template <int Dim, int Size>
void principalDirections(const Pack (&matrix)[Size], Pack (&directions)[Dim][Dim]) {
  static_assert(Size == Dim * (Dim + 1) / 2);
  constexpr int kSweeps = 6;
  Pack full[Dim][Dim];
  for (int row = 0; row < Dim; ++row)
    for (int column = 0; column < Dim; ++column) {
      const int low = row < column ? column : row, left = row < column ? row : column;
      full[row][column] = matrix[low * (low + 1) / 2 + left];
      directions[row][column] = splat(row == column);
    }
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (int p = 0; p < Dim; ++p)
      for (int q = p + 1; q < Dim; ++q)
        rotate(full, directions, p, q);
  for (int p = 0; p < Dim; ++p)
    for (int q = p + 1; q < Dim; ++q) {
      const Mask swap = full[p][p] < full[q][q];
      const Pack diagonal = full[p][p];
      full[p][p] = select(swap, full[q][q], diagonal);
      full[q][q] = select(swap, diagonal, full[q][q]);
      for (int axis = 0; axis < Dim; ++axis) {
        const Pack direction = directions[p][axis];
        directions[p][axis] = select(swap, directions[q][axis], direction);
        directions[q][axis] = select(swap, direction, directions[q][axis]);
      }
    }
}

} // namespace viscera::coordinates::simd::VISCERA_ISA
