#include "errors.h"
#include "parts.h"

/// The numerical part of the package: neither VTK nor Qt.
PYBIND11_MODULE(_core, module) {
  module.doc() = "Coordinates, deformation, volume, stress and motion on arrays of numpy: mm, LPS, float64.";
  viscera::python::translateErrors();
  viscera::python::addSystems(module);
  viscera::python::addBinding(module);
  viscera::python::addSurfaces(module);
  viscera::python::addVolumeLock(module);
  viscera::python::addStress(module);
  viscera::python::addSequences(module);
}
