#pragma once

#include <memory>
#include <string>
#include <utility>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "viscera/core/arrays.h"

/// Converts between numpy arrays and Viscera's matrices. An array that Viscera has created is used again
/// without a copy; any other array is copied once. All functions need the interpreter's lock.
namespace viscera::python {

/// The name of the capsule that is the base of such an array, by which Viscera recognises it.
template <typename Matrix>
constexpr const char* kMemoryName = "viscera.memory";
template <>
inline constexpr const char* kMemoryName<Points> = "viscera.points";
template <>
inline constexpr const char* kMemoryName<Triangles> = "viscera.triangles";

/// An array on `matrix` without a copy; it lives as long as one of the two does.
template <typename Matrix>
pybind11::array share(std::shared_ptr<const Matrix> matrix, bool writeable = false) {
  using Scalar = typename Matrix::Scalar;
  const auto* data = matrix->data();
  const pybind11::ssize_t rows = matrix->rows(), columns = matrix->cols();
  auto owner = std::make_unique<std::shared_ptr<const Matrix>>(std::move(matrix));
  const pybind11::capsule base(owner.get(), kMemoryName<Matrix>, [](PyObject* capsule) {
    delete static_cast<std::shared_ptr<const Matrix>*>(
        PyCapsule_GetPointer(capsule, PyCapsule_GetName(capsule)));
  });
  owner.release();
  pybind11::array array;
  if constexpr (Matrix::ColsAtCompileTime == 1)
    array = pybind11::array_t<Scalar>({rows}, {pybind11::ssize_t(sizeof(Scalar))}, data, base);
  else
    array = pybind11::array_t<Scalar>(
        {rows, columns}, {columns * pybind11::ssize_t(sizeof(Scalar)), pybind11::ssize_t(sizeof(Scalar))},
        data, base);
  if (!writeable)
    array.attr("flags").attr("writeable") = false;
  return array;
}

/// A new array that takes ownership of `matrix`, without a copy.
template <typename Matrix>
pybind11::array handOver(Matrix matrix) {
  return share<Matrix>(std::make_shared<const Matrix>(std::move(matrix)), true);
}

/// The matrix behind an array that `share` made, or null for any other array and for a part of one.
template <typename Matrix>
std::shared_ptr<const Matrix> behind(const pybind11::handle& array) {
  if (!pybind11::isinstance<pybind11::array>(array))
    return nullptr;
  const auto given = pybind11::reinterpret_borrow<pybind11::array>(array);
  PyObject* base = given.base().ptr();
  if (!base || !PyCapsule_IsValid(base, kMemoryName<Matrix>))
    return nullptr;
  const auto& matrix =
      *static_cast<std::shared_ptr<const Matrix>*>(PyCapsule_GetPointer(base, kMemoryName<Matrix>));
  const bool whole = given.data() == static_cast<const void*>(matrix->data()) && given.ndim() == 2 &&
                     given.shape(0) == matrix->rows() && given.shape(1) == matrix->cols();
  return whole ? matrix : nullptr;
}

/// `n x 3` numbers, mm. Throws `DataError`, naming `what`, for anything else.
std::shared_ptr<const Points> pointsFrom(const pybind11::handle& array, const std::string& what);

/// `m x 3` whole numbers. Throws `DataError`, naming `what`, for anything else, and for numbers beyond
/// 32 bits.
std::shared_ptr<const Triangles> trianglesFrom(const pybind11::handle& array, const std::string& what);

/// Three numbers. Throws `DataError`, naming `what`, for anything else.
Vec3 vectorFrom(const pybind11::handle& array, const std::string& what);

/// The writable memory of `out`, which has to be an array created by Viscera with `rows x 3`. Throws
/// `UsageError` for any other.
Points& writable(const pybind11::handle& out, Eigen::Index rows);

} // namespace viscera::python
