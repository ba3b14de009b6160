#pragma once

#include <pybind11/pybind11.h>

/// The parts of the extensions, each of which adds its names to the module.
namespace viscera::python {

/// Of `_core`.
void addBinding(pybind11::module_& module);
void addSurfaces(pybind11::module_& module);
void addVolumeLock(pybind11::module_& module);
void addStress(pybind11::module_& module);
void addSequences(pybind11::module_& module);
void addCirculation(pybind11::module_& module);

/// Of `_motion`.
void addPatientMotion(pybind11::module_& module);

} // namespace viscera::python
