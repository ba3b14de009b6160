#include <pybind11/stl.h>

#include "errors.h"
#include "parts.h"
#include "viscera/coordinates/systems.h"
#include "viscera/localised_scc/localised_s_celestial.h"

namespace viscera::python {
namespace {

namespace py = pybind11;
using coordinates::CoordinateSystem;
using coordinates::Parameter;

std::vector<std::shared_ptr<CoordinateSystem>> builtInSystems() {
  auto systems = coordinates::builtInSystems();
  systems.push_back(localised_scc::localisedWithBuiltIns());
  std::vector<std::shared_ptr<CoordinateSystem>> all;
  for (const auto& system : systems)
    all.push_back(std::const_pointer_cast<CoordinateSystem>(system)); // pybind11 knows no const
  return all;
}

py::dict traitsOf(const CoordinateSystem& system) {
  const coordinates::Traits traits = system.traits();
  py::dict all;
  all["needs_cage"] = traits.needsCage;
  all["needs_tetrahedra"] = traits.needsTetrahedra;
  all["positive"] = traits.positive;
  all["interpolates"] = traits.interpolates;
  all["closed_form_gradient"] = traits.closedFormGradient;
  all["uses_groups"] = traits.usesGroups;
  all["rotation_invariant"] = traits.rotationInvariant;
  all["everywhere"] = traits.everywhere;
  all["continuous"] = traits.continuous;
  all["smooth"] = traits.smooth;
  all["affine"] = traits.affine;
  return all;
}

void addSystems(py::module_& module) {
  py::class_<Parameter>(module, "Parameter", "A number that a user may set on a coordinate system.")
      .def_readonly("name", &Parameter::name, "As on the command line: \"locality\".")
      .def_readonly("minimum", &Parameter::minimum)
      .def_readonly("maximum", &Parameter::maximum)
      .def_readonly("standard", &Parameter::standard, "The value when none is given.")
      .def_readonly("unit", &Parameter::unit, "\"mm\" or empty.")
      .def_readonly("help", &Parameter::help, "One line.")
      .def_readonly("integer", &Parameter::integer)
      .def_readonly("choices", &Parameter::choices, "Not empty: the value is one of these names.")
      .def("__repr__", [](const Parameter& parameter) {
        return "<Parameter " + parameter.name + ": " + parameter.help + ">";
      });
  py::class_<CoordinateSystem, std::shared_ptr<CoordinateSystem>>(
      module, "System", "A recipe for coordinates. Stateless; may be used from several threads.")
      .def_property_readonly("id", &CoordinateSystem::id, "As `bind` takes it: \"s-celestial\".")
      .def_property_readonly("name", &CoordinateSystem::name, "For people: \"S-Celestial\".")
      .def_property_readonly("summary", &CoordinateSystem::summary, "One line.")
      .def_property_readonly("traits", &traitsOf, "What can be expected of it: a dict of bool.")
      .def_property_readonly("parameters", &CoordinateSystem::parameters, "What `bind` takes by name.")
      .def("__repr__", [](const CoordinateSystem& system) { return "<System " + system.id() + ">"; });
  module.def("built_in_systems", &builtInSystems,
             "Every system that needs no plugin, in the order of lists.");
}

} // namespace
} // namespace viscera::python

/// The numerical part of the package: neither VTK nor Qt.
PYBIND11_MODULE(_core, module) {
  module.doc() = "Coordinates, deformation, volume, stress, motion and circulation on arrays of numpy: mm, "
                 "LPS, float64.";
  module.attr("__version__") = VISCERA_VERSION;
  viscera::python::translateErrors();
  viscera::python::addSystems(module);
  viscera::python::addBinding(module);
  viscera::python::addSurfaces(module);
  viscera::python::addVolumeLock(module);
  viscera::python::addStress(module);
  viscera::python::addElasticity(module);
  viscera::python::addSequences(module);
  viscera::python::addCirculation(module);
}
