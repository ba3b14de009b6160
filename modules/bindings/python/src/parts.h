#pragma once

#include <pybind11/pybind11.h>

/// The functions that define the parts of the Python extensions; each adds its names to the module.
namespace viscera::python {

/// Part of `_core`.
void addBinding(pybind11::module_& module);
void addSurfaces(pybind11::module_& module);
void addVolumeLock(pybind11::module_& module);
void addStress(pybind11::module_& module);
void addElasticity(pybind11::module_& module);
void addSequences(pybind11::module_& module);
void addCirculation(pybind11::module_& module);

/// Part of `_motion`.
void addPatientMotion(pybind11::module_& module);
void addPhantom(pybind11::module_& module);
void addStrain(pybind11::module_& module);
void addWorkbench(pybind11::module_& module);

} // namespace viscera::python
