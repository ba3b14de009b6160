#include "errors.h"

#include <exception>
#include <string>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "array_memory.h"
#include "viscera/core/error.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/tetrahedralise.h"

namespace viscera::python {
namespace {

namespace py = pybind11;

const char* nameOf(const Error& error) {
  if (dynamic_cast<const deformation::UnboundVertices*>(&error))
    return "UnboundVertices";
  if (dynamic_cast<const deformation::TetrahedraError*>(&error))
    return "TetrahedraError";
  if (dynamic_cast<const UsageError*>(&error))
    return "UsageError";
  if (dynamic_cast<const DataError*>(&error))
    return "DataError";
  if (dynamic_cast<const NoInputError*>(&error))
    return "NoInputError";
  if (dynamic_cast<const CannotCreateError*>(&error))
    return "CannotCreateError";
  if (dynamic_cast<const Cancelled*>(&error))
    return "Cancelled";
  return "Error";
}

void raise(const Error& error) {
  const py::object kind = py::module_::import("viscera.errors").attr(nameOf(error));
  py::object raised = kind(error.what());
  raised.attr("problem") = error.problem().english();
  raised.attr("where") = error.where().english();
  raised.attr("try_this") = error.tryThis().english();
  raised.attr("exit_code") = error.exitCode();
  if (const auto* unbound = dynamic_cast<const deformation::UnboundVertices*>(&error)) {
    raised.attr("vertices") =
        py::array_t<int>(static_cast<py::ssize_t>(unbound->vertices().size()), unbound->vertices().data());
    raised.attr("outside_hull") = unbound->outsideHull();
  }
  PyErr_SetObject(kind.ptr(), raised.ptr());
}

} // namespace

void translateErrors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown)
        std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise(error);
    } catch (const std::exception& error) {
      if (!reportsShortMemory(error))
        throw; // To the translator of the standard library's exceptions.
      PyErr_SetString(PyExc_MemoryError, notEnoughMemory().what());
    }
  });
}

} // namespace viscera::python
