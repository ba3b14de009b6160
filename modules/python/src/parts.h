#pragma once

#include <pybind11/pybind11.h>

/// The parts of the extension `viscera._core`, each of which adds its names to the module.
namespace viscera::python {

void addSystems(pybind11::module_& module);
void addBinding(pybind11::module_& module);
void addSurfaces(pybind11::module_& module);
void addVolumeLock(pybind11::module_& module);
void addStress(pybind11::module_& module);
void addSequences(pybind11::module_& module);

} // namespace viscera::python
