#include "array_memory.h"

#include <cstdint>
#include <limits>

#include "viscera/core/error.h"

namespace viscera::python {
namespace {

namespace py = pybind11;

std::string shapeOf(const py::array& array) {
  std::string text;
  for (py::ssize_t i = 0; i < array.ndim(); ++i)
    text += (i > 0 ? " x " : "") + std::to_string(array.shape(i));
  return array.ndim() == 0 ? "a single value" : array.ndim() == 1 ? text + " values" : text;
}

py::array anyArray(const py::handle& value, const std::string& what) {
  py::array array = py::array::ensure(value);
  if (!array) {
    PyErr_Clear();
    throw DataError("is not an array", what, "give an array of numpy, or lists of equal length");
  }
  return array;
}

/// Requires numbers, not texts or objects; whole ones if so asked.
void requireNumbers(const py::array& array, bool whole, const std::string& what) {
  const char kind = array.dtype().kind();
  const bool integer = kind == 'i' || kind == 'u';
  if (!(integer || (kind == 'f' && !whole)))
    throw DataError(whole ? "are no whole numbers" : "are no numbers", what,
                    "they are of numpy's type " + std::string(py::str(array.dtype())));
}

void requireThreeColumns(const py::array& array, const std::string& what) {
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw DataError("has the shape " + shapeOf(array), what, "n x 3 is wanted");
}

} // namespace

std::shared_ptr<const Points> pointsFrom(const py::handle& value, const std::string& what) {
  if (auto own = behind<Points>(value))
    return own;
  const py::array given = anyArray(value, what);
  requireNumbers(given, false, what);
  requireThreeColumns(given, what);
  const auto numbers = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
  return std::make_shared<const Points>(Eigen::Map<const Points>(numbers.data(), numbers.shape(0), 3));
}

std::shared_ptr<const Triangles> trianglesFrom(const py::handle& value, const std::string& what) {
  if (auto own = behind<Triangles>(value))
    return own;
  const py::array given = anyArray(value, what);
  requireNumbers(given, true, what);
  requireThreeColumns(given, what);
  if (given.dtype().is(py::dtype::of<std::int32_t>())) {
    const auto same = py::array_t<std::int32_t, py::array::c_style>::ensure(given);
    return std::make_shared<const Triangles>(Eigen::Map<const Triangles>(same.data(), same.shape(0), 3));
  }
  const auto wide = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(given);
  auto triangles = std::make_shared<Triangles>(wide.shape(0), 3);
  for (py::ssize_t i = 0; i < wide.size(); ++i) {
    const std::int64_t index = wide.data()[i];
    if (index < 0 || index > std::numeric_limits<std::int32_t>::max())
      throw DataError("triangle " + std::to_string(i / 3) + " names vertex " + std::to_string(index), what);
    triangles->data()[i] = static_cast<std::int32_t>(index);
  }
  return triangles;
}

Vec3 vectorFrom(const py::handle& value, const std::string& what) {
  const py::array given = anyArray(value, what);
  requireNumbers(given, false, what);
  if (given.size() != 3)
    throw DataError("has the shape " + shapeOf(given), what, "three numbers are wanted");
  const auto numbers = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
  return {numbers.data()[0], numbers.data()[1], numbers.data()[2]};
}

Points& writable(const py::handle& out, Eigen::Index rows) {
  const auto memory = behind<Points>(out);
  if (!memory || !py::reinterpret_borrow<py::array>(out).writeable())
    throw UsageError("this array cannot be written to", "out", "give one that pose or as_points returned");
  if (memory->rows() != rows)
    throw UsageError("it has " + std::to_string(memory->rows()) + " rows", "out",
                     std::to_string(rows) + " are wanted");
  // The array belongs to the caller, who has requested the change.
  return const_cast<Points&>(*memory);
}

} // namespace viscera::python
