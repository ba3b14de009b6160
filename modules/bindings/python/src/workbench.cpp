#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "array_memory.h"
#include "long_jobs.h"
#include "parts.h"
#include "viscera/core/error.h"
#include "viscera/workbench/workbench.h"

namespace viscera::python {
namespace {

namespace py = pybind11;
using workbench::Workbench;

/// Runs a call of a workbench, which then reports to `listener` and is ended by it.
template <typename Job>
auto onBench(Workbench& bench, const py::object& listener, Job job) {
  const auto told = [&](Progress& progress) {
    struct Ear {
      Workbench& heard;
      Ear(Workbench& of, Progress& hearer) : heard(of) { heard.tell(&hearer); }
      ~Ear() { heard.tell(nullptr); }
    } const ear(bench, progress);
    return job();
  };
  return resultOfLong(listener, told);
}

/// A sample organ that a text such as "sample:heart@low" names, or files.
workbench::Opened openOn(Workbench& bench, const std::vector<std::filesystem::path>& files) {
  const std::string first = files.size() == 1 ? files.front().string() : std::string(), prefix = "sample:";
  if (!first.starts_with(prefix))
    return bench.open(files);
  const std::size_t at = first.find('@');
  const std::string resolution = at == std::string::npos ? "medium" : first.substr(at + 1);
  bench.openSample(first.substr(prefix.size(), at == std::string::npos ? at : at - prefix.size()),
                   sample_organs::resolutionFromName(resolution));
  return {};
}

/// A workbench with the warnings of its files.
struct OpenBench {
  std::unique_ptr<Workbench> bench;
  std::vector<std::string> warnings;
};

std::unique_ptr<OpenBench>
openBench(const std::vector<std::filesystem::path>& files,
          const std::vector<std::shared_ptr<coordinates::CoordinateSystem>>& systems, int threads,
          const py::object& listener) {
  workbench::Setup setup;
  for (const auto& system : systems)
    if (!setup.systems.contains(system->id()))
      setup.systems.add(system, "Python");
  setup.threads = {threads};
  auto open = std::make_unique<OpenBench>();
  open->bench = std::make_unique<Workbench>(std::move(setup));
  const workbench::Opened opened =
      onBench(*open->bench, listener, [&] { return openOn(*open->bench, files); });
  for (const Text& warning : opened.warnings)
    open->warnings.push_back(warning.english());
  for (const Error& failure : opened.failures)
    open->warnings.push_back(failure.what());
  return open;
}

std::vector<std::string> organNames(const OpenBench& open) {
  std::vector<std::string> names;
  for (const auto& organ : *open.bench->state().organs)
    names.push_back(organ->name);
  return names;
}

std::vector<std::string> handleLabels(const OpenBench& open) {
  std::vector<std::string> labels;
  for (const document::Handle& handle : open.bench->state().rig->handles)
    labels.push_back(handle.label);
  return labels;
}

py::array points(OpenBench& open, const std::string& organ) {
  return handOver(Points(open.bench->organs().points(open.bench->organ(organ))));
}

Vec3 drag(OpenBench& open, const std::string& handle, const py::object& by, bool exactly,
          bool freeHandlesFollow) {
  const Vec3 vector = vectorFrom(by, "by");
  const live::Others others = freeHandlesFollow ? live::Others::follow
                              : exactly         ? live::Others::compensate
                                                : live::Others::asMarked;
  return unlocked([&] { return open.bench->drag(handle, vector, others); });
}

/// Seconds, and the volumes of each organ, ml.
py::tuple play(OpenBench& open, double framesPerSecond, double cycles, const py::object& listener) {
  const std::vector<workbench::PlayedVolumes> played =
      onBench(*open.bench, listener, [&] { return open.bench->play(framesPerSecond, cycles); });
  Values seconds(static_cast<Eigen::Index>(played.size()));
  for (Eigen::Index i = 0; i < seconds.size(); ++i)
    seconds[i] = played[static_cast<std::size_t>(i)].seconds;
  py::dict volumes;
  const std::vector<std::string> names = organNames(open);
  for (std::size_t organ = 0; organ < names.size(); ++organ) {
    Values column(seconds.size());
    for (Eigen::Index i = 0; i < column.size(); ++i)
      column[i] = played[static_cast<std::size_t>(i)].milliliters[organ];
    volumes[py::str(names[organ])] = handOver(std::move(column));
  }
  return py::make_tuple(handOver(std::move(seconds)), volumes);
}

std::map<std::string, double> stress(OpenBench& open, const std::string& organ, int witnesses,
                                     const py::object& listener) {
  const deformation::StressStatistics found =
      onBench(*open.bench, listener, [&] { return open.bench->stress(organ, witnesses).statistics(); });
  return {{"min", found.min},
          {"mean", found.mean},
          {"p95", found.percentile95},
          {"max", found.max},
          {"folded", found.folded}};
}

std::map<std::string, double> measured(OpenBench& open, const std::string& name) {
  const document::MeasuredValues values = open.bench->measure(name);
  return {{"rest", values.rest}, {"now", values.now}};
}

std::vector<std::string> measurementNames(const OpenBench& open) {
  std::vector<std::string> names;
  for (const document::Measurement& one : *open.bench->state().measurements)
    names.push_back(one.name);
  return names;
}

} // namespace

void addWorkbench(py::module_& module) {
  py::class_<OpenBench>(module, "Workbench", "The open document at work.")
      .def_readonly("warnings", &OpenBench::warnings, "What to know about the files.")
      .def_property_readonly("organs", &organNames, "The organs' names.")
      .def_property_readonly("handles", &handleLabels, "The handles' labels.")
      .def_property_readonly("measurements", &measurementNames, "The measurements' names.")
      .def_property_readonly(
          "pose", [](const OpenBench& open) { return handOver(Points(*open.bench->state().pose)); },
          "The handles in the pose, h x 3 mm.")
      .def("points", &points, py::arg("organ"), "An organ's vertices as they are shown, n x 3 mm.")
      .def(
          "volume_ml",
          [](OpenBench& open, const std::string& organ) { return open.bench->volume(organ).nowMl; },
          py::arg("organ"), "An organ's volume as it is shown, ml.")
      .def(
          "lock",
          [](OpenBench& open, const std::string& organ, bool locked) { open.bench->lock(organ, locked); },
          py::arg("organ"), py::arg("locked") = true, "Locks an organ's volume.")
      .def("drag", &drag, py::arg("handle"), py::arg("by"), py::arg("exactly") = false,
           py::arg("free_handles_follow") = false,
           "Moves a handle by a vector, mm, and returns how far it went. With `free_handles_follow` those "
           "that "
           "are not locked go where the tissue's elastic energy is least.")
      .def(
          "set_pose",
          [](OpenBench& open, const py::object& places, bool freeHandlesFollow) {
            const auto given = pointsFrom(places, "places");
            unlocked([&] {
              open.bench->pose(*given, freeHandlesFollow ? live::Others::follow : live::Others::asMarked);
            });
          },
          py::arg("places"), py::arg("free_handles_follow") = false,
          "Gives all handles their places, h x 3 mm; with `free_handles_follow` only those that are sent "
          "elsewhere, and the others that are not locked go where the tissue's elastic energy is least.")
      .def(
          "rest", [](OpenBench& open) { open.bench->rest(); }, "All handles at rest.")
      .def("play", &play, py::arg("frames_per_second") = 25.0, py::arg("cycles") = 1.0,
           py::arg("progress") = py::none(), "Plays the motion: seconds, and the volumes of each organ, ml.")
      .def("stress", &stress, py::arg("organ"), py::arg("witnesses") = 2000, py::arg("progress") = py::none(),
           "The rotational stress in the pose, rad.")
      .def("measure", &measured, py::arg("name"), "A measurement at rest and now, mm or degrees.")
      .def(
          "undo", [](OpenBench& open) { return open.bench->undo(); }, "One step back; False without one.")
      .def(
          "redo", [](OpenBench& open) { return open.bench->redo(); }, "One step forth; False without one.")
      .def(
          "save",
          [](OpenBench& open, const std::filesystem::path& file, std::optional<bool> embed) {
            open.bench->save(file, embed);
          },
          py::arg("path"), py::arg("embed") = py::none(), "Writes a session.");
  module.def("open_bench", &openBench, py::arg("files"), py::arg("systems"), py::arg("threads"),
             py::arg("progress"), "Opens files on a workbench.");
}

} // namespace viscera::python
