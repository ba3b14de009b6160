#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "array_memory.h"
#include "file_motion.h"
#include "long_jobs.h"
#include "parts.h"
#include "viscera/live/retarget.h"
#include "viscera/live/sequence_file.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/plugin/plugin_loader.h"

namespace viscera::python {
namespace {

namespace py = pybind11;
using std::filesystem::path;

std::vector<std::string> labelsOf(const document::Rig& rig) {
  std::vector<std::string> labels;
  for (const auto& handle : rig.handles)
    labels.push_back(handle.label);
  return labels;
}

std::shared_ptr<MotionSource> readySequence(const std::string& id, const std::string& resolution,
                                            const py::object& listener) {
  auto setup = resultOfLong(listener, [&](Progress& progress) {
    return live::setUpSequence(sample_organs::standardLibrary(), id,
                               sample_organs::resolutionFromName(resolution), progress);
  });
  MotionSource source{setup.sequence, setup.system.id, setup.system.parameters, labelsOf(setup.rig), {}, {}};
  for (const auto& surface : setup.organ.surfaces)
    source.surfaces.emplace_back(surface.name, surface.mesh);
  return std::make_shared<MotionSource>(std::move(source));
}

std::shared_ptr<MotionSource> fittedSequence(const std::string& id, const py::object& points,
                                             const py::object& triangles,
                                             const std::map<std::string, std::vector<Vec3>>& landmarks,
                                             const py::object& listener) {
  const auto organ = document::makeOrgan(
      "organ",
      geometry::TriangleMesh{*pointsFrom(points, "points"), *trianglesFrom(triangles, "triangles"), {}});
  live::Landmarks given;
  for (const auto& [role, places] : landmarks)
    for (const Vec3& place : places)
      given.points.push_back({role, place, false});
  const auto found = resultOfLong(
      listener, [&](Progress& progress) { return live::retargetSequence(id, organ, given, progress); });
  return std::make_shared<MotionSource>(MotionSource{found.sequence,
                                                     found.system.id,
                                                     found.system.parameters,
                                                     labelsOf(found.rig),
                                                     {{"organ", organ.mesh}},
                                                     found.warnings});
}

std::shared_ptr<MotionSource> sequenceOfFile(const path& file) {
  return std::make_shared<MotionSource>(sourceOf(unlocked([&] { return live::readSequence(file); })));
}

std::vector<std::string> sequenceNames() {
  std::vector<std::string> names;
  for (const auto& each : live::sampleSequences())
    names.push_back(each.id);
  return names;
}

/// The systems of each file, or why it was left out.
py::list loadPlugins(const std::vector<path>& searchPath) {
  coordinates::Registry registry = coordinates::builtInRegistry();
  py::list all;
  for (const auto& report : plugin::loadPlugins(searchPath, registry)) {
    py::list systems;
    for (const std::string& id : report.systems)
      systems.append(std::const_pointer_cast<coordinates::CoordinateSystem>(registry.find(id)));
    all.append(py::make_tuple(report.file, systems, report.problem.english()));
  }
  return all;
}

} // namespace
} // namespace viscera::python

/// Ready sequences, the motion of patients, plugins, open documents: what takes Qt's core.
PYBIND11_MODULE(_motion, module) {
  namespace py = pybind11;
  py::module_::import("viscera._core"); // defines the errors and the classes
  module.doc() = "Ready sequences, sequence files, the motion of patients, plugins.";
  module.def("sequence_names", &viscera::python::sequenceNames, "The sequences there are.");
  module.def("ready_sequence", &viscera::python::readySequence, py::arg("name"), py::arg("resolution"),
             py::arg("progress"), "A sequence on its sample organ.");
  module.def("fitted_sequence", &viscera::python::fittedSequence, py::arg("name"), py::arg("points"),
             py::arg("triangles"), py::arg("landmarks"), py::arg("progress"),
             "A sequence fitted to an organ.");
  module.def("sequence_of_file", &viscera::python::sequenceOfFile, py::arg("path"), "A .sequence.json file.");
  module.def("load_plugins", &viscera::python::loadPlugins, py::arg("search_path"),
             "File, systems and problem of every plugin.");
  viscera::python::addPatientMotion(module);
  viscera::python::addPhantom(module);
  viscera::python::addStrain(module);
  viscera::python::addWorkbench(module);
}
