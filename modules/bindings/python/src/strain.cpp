#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "long_jobs.h"
#include "parts.h"
#include "viscera/coordinates/registry.h"
#include "viscera/live/patient_motion.h"
#include "viscera/live/sequence_file.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/live/strain_reading.h"

namespace viscera::python {
namespace {

namespace py = pybind11;
using Labels = std::vector<std::pair<std::string, std::vector<std::string>>>;
/// Name, surface, vertices, and whether it is closed.
using Contours = std::vector<std::tuple<std::string, std::string, std::vector<std::int32_t>, bool>>;

constexpr double kSecondsPerMinute = 60;

/// What `viscera.strain` takes of a series.
struct SeriesArguments {
  Labels surfaces;
  std::optional<double> period;
  std::vector<std::size_t> leaveOut;
  bool loop = true;
  int handles = 0;
};

live::MovedOrgans ofSeries(const std::vector<std::filesystem::path>& files, const SeriesArguments& arguments,
                           Progress& progress, Threads threads) {
  live::SeriesRequest request;
  request.inputs = files;
  for (const auto& [name, labels] : arguments.surfaces)
    request.surfaces.push_back({name, labels});
  request.periodSeconds = arguments.period;
  request.leftOut = arguments.leaveOut;
  request.loop = arguments.loop;
  live::TrackOptions options;
  options.rig.handles = arguments.handles;
  live::MotionSeries series;
  runPart(progress, 0, 0.1, [&](Progress& part) { series = live::readMotionSeries(request, part); });
  live::PatientMotion found;
  runPart(progress, 0.1, 1,
          [&](Progress& part) { found = live::trackMotion(series, options, part, threads); });
  return live::movedOrgans(series, found, coordinates::builtInRegistry());
}

live::MovedOrgans ofReadySequence(const std::string& id, int instants, Progress& progress, Threads threads) {
  const live::SequenceSetup setup = live::setUpSequence(sample_organs::standardLibrary(), id,
                                                        sample_organs::Resolution::medium, progress, threads);
  live::MovedOrgans moved;
  for (const auto& surface : setup.organ.surfaces)
    moved.organs.push_back({surface.name, surface.mesh});
  moved.handles.positions = setup.sequence->restHandles();
  moved.system = coordinates::builtInRegistry().find(setup.system.id);
  moved.parameters = setup.system.parameters;
  moved.corresponding = true;
  const double rate = setup.sequence->standardRatePerMinute();
  for (int i = 0; i < instants; ++i) {
    moved.seconds.push_back(i * kSecondsPerMinute / rate / instants);
    Points pose;
    setup.sequence->poseAt(moved.seconds.back(), rate, pose);
    moved.poses.push_back(std::move(pose));
  }
  return moved;
}

live::StrainOptions optionsFrom(const std::map<std::string, std::string>& names,
                                const std::map<std::string, Vec3>& landmarks,
                                std::optional<std::size_t> reference, int witnesses,
                                const Contours& contours) {
  live::StrainOptions options;
  const auto nameOf = [&names](const char* key) {
    const auto found = names.find(key);
    return found == names.end() ? std::string() : found->second;
  };
  const auto placeOf = [&landmarks](const char* key) {
    const auto found = landmarks.find(key);
    return found == landmarks.end() ? std::optional<Vec3>() : found->second;
  };
  options.left = nameOf("lv");
  options.right = nameOf("rv");
  options.outer = nameOf("epi");
  options.atrium = nameOf("la");
  options.landmarks = {placeOf("base"), placeOf("apex"), placeOf("insertion")};
  options.reference = reference;
  options.witnesses = witnesses;
  for (const auto& [name, surface, vertices, closed] : contours) {
    const std::string known = live::contourNamed(name);
    options.contours.push_back({known.empty() ? name : known, surface, vertices, closed});
  }
  return options;
}

} // namespace

void addStrain(py::module_& module) {
  module.def(
      "strain_json",
      [](const std::vector<std::filesystem::path>& motion, const std::string& kind, const Labels& surfaces,
         std::optional<double> period, const std::vector<std::size_t>& leaveOut, bool loop, int handles,
         int instants, const std::map<std::string, std::string>& names,
         const std::map<std::string, Vec3>& landmarks, std::optional<std::size_t> reference, int witnesses,
         const Contours& contours, int threads, const py::object& listener) {
        const live::StrainOptions options = optionsFrom(names, landmarks, reference, witnesses, contours);
        const SeriesArguments series{surfaces, period, leaveOut, loop, handles};
        return resultOfLong(listener, [&](Progress& progress) {
          live::MovedOrgans moved;
          runPart(progress, 0, 0.6, [&](Progress& part) {
            if (kind == "series")
              moved = ofSeries(motion, series, part, Threads{threads});
            else if (kind == "file")
              moved = live::movedOrgans(live::readSequence(motion.front()), coordinates::builtInRegistry());
            else
              moved = ofReadySequence(motion.front().string(), instants, part, Threads{threads});
          });
          std::string json;
          runPart(progress, 0.6, 1, [&](Progress& part) {
            json = live::strainJson(live::readStrain(moved, options, part, Threads{threads}));
          });
          return json;
        });
      },
      py::arg("motion"), py::arg("kind"), py::arg("surfaces"), py::arg("period"), py::arg("leave_out"),
      py::arg("loop"), py::arg("handles"), py::arg("instants"), py::arg("names"), py::arg("landmarks"),
      py::arg("reference"), py::arg("witnesses"), py::arg("contours"), py::arg("threads"),
      py::arg("progress"), "What `viscera.strain` calls.");
}

} // namespace viscera::python
