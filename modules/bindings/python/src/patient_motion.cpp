#include "viscera/live/cine_motion.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "array_memory.h"
#include "file_motion.h"
#include "long_jobs.h"
#include "parts.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/phrase.h"
#include "viscera/live/patient_motion.h"
#include "viscera/sequences/keyframes.h"

namespace viscera::python {
namespace {

namespace py = pybind11;
using live::CineMotion;
using live::PatientMotion;
using live::TrackedPhase;

const char* nameOf(tracking::FitLight light) {
  return light == tracking::FitLight::good ? "good" : light == tracking::FitLight::amber ? "amber" : "red";
}

/// Positions of the user's in the place of handles that are made.
std::optional<medical_io::HandleFile> rigFrom(const py::object& rig) {
  if (rig.is_none())
    return std::nullopt;
  const auto positions = pointsFrom(rig, "rig");
  medical_io::HandleGroupRecord group;
  group.name = "Handles";
  for (Eigen::Index i = 0; i < positions->rows(); ++i)
    group.handles.push_back({"H-" + std::to_string(i + 1), positions->row(i).transpose(), {}, false, true});
  return medical_io::HandleFile{{std::move(group)}, {}};
}

/// Everything that `viscera.track` takes besides the files.
struct TrackArguments {
  std::vector<std::pair<std::string, std::vector<std::string>>> surfaces;
  int handles = 0;
  std::optional<double> period;
  std::vector<double> times;
  std::vector<std::size_t> leaveOut;
  bool loop = true;
  bool keepVolumes = true;
  std::optional<double> smoothing;
  double robust = 0;
};

std::shared_ptr<PatientMotion> track(const std::vector<std::filesystem::path>& phases,
                                     const TrackArguments& arguments, const py::object& rig, int threads,
                                     const py::object& listener) {
  live::SeriesRequest request;
  request.inputs = phases;
  for (const auto& [name, labels] : arguments.surfaces)
    request.surfaces.push_back({name, labels});
  request.periodSeconds = arguments.period;
  request.seconds = arguments.times;
  request.leftOut = arguments.leaveOut;
  request.loop = arguments.loop;
  live::TrackOptions options;
  options.rig.handles = arguments.handles;
  options.handles = rigFrom(rig);
  options.keepVolumes = arguments.keepVolumes;
  options.smoothing = arguments.smoothing;
  options.robustMm = arguments.robust;
  return resultOfLong(listener, [&](Progress& progress) {
    live::MotionSeries series;
    runPart(progress, 0, 0.1, [&](Progress& part) { series = live::readMotionSeries(request, part); });
    auto found = std::make_shared<PatientMotion>();
    runPart(progress, 0.1, 1,
            [&](Progress& part) { *found = live::trackMotion(series, options, part, Threads{threads}); });
    return found;
  });
}

/// A corrected contour: its phase, slice, series, surface and points (`k x 3` mm).
using CorrectedContour =
    std::tuple<std::size_t, std::optional<std::size_t>, std::optional<int>, std::string, py::object>;

/// What `viscera.track` takes for images.
struct CineArguments {
  std::filesystem::path images;
  std::vector<std::pair<std::size_t, std::vector<std::filesystem::path>>> labels;
  std::vector<std::pair<std::string, std::vector<std::string>>> surfaces;
  int handles = 0;
  std::optional<double> period;
  std::vector<int> leaveOutSeries;
  std::vector<CorrectedContour> corrections;
  bool keepVolumes = true;
};

std::shared_ptr<CineMotion> trackImages(const CineArguments& arguments, const py::object& rig, int threads,
                                        const py::object& listener) {
  live::CineRequest request;
  request.images = arguments.images;
  for (const auto& [phase, files] : arguments.labels)
    request.labels.push_back({phase, files});
  for (const auto& [name, labels] : arguments.surfaces)
    request.surfaces.push_back({name, labels});
  request.periodSeconds = arguments.period;
  request.leftOutSeries = arguments.leaveOutSeries;
  for (const auto& [phase, slice, series, surface, points] : arguments.corrections)
    request.corrections.push_back({phase, slice, series, surface, *pointsFrom(points, "points_mm")});
  live::TrackOptions options;
  options.rig.handles = arguments.handles;
  options.handles = rigFrom(rig);
  options.keepVolumes = arguments.keepVolumes;
  return resultOfLong(listener, [&](Progress& progress) {
    live::LabelledStudy study;
    runPart(progress, 0, 0.2, [&](Progress& part) { study = live::readLabelledStudy(request, part); });
    auto found = std::make_shared<CineMotion>();
    runPart(progress, 0.2, 1,
            [&](Progress& part) { *found = live::trackCine(study, options, part, Threads{threads}); });
    return found;
  });
}

const char* nameOf(live::PlaneState state) {
  static constexpr const char* kNames[] = {"used",    "leaves plane", "unlike",
                                           "no wall", "no image",     "labelled"};
  return kNames[static_cast<std::size_t>(state)];
}

py::list planesOf(const CineMotion& found) {
  py::list all;
  for (const live::CinePlaneUse& use : found.planes) {
    py::dict row;
    row["name"] = use.source.name.english();
    row["series"] = use.source.series;
    row["plane"] = nameOf(use.source.view);
    row["long_axis"] = use.longAxis;
    row["weight"] = use.weight;
    row["likeness"] = use.likeness;
    row["closure_mm"] = use.closureMm;
    row["apart_mm"] = use.apartMm;
    row["fit"] = nameOf(use.light);
    row["reason"] = use.reason.english();
    py::list states;
    for (const live::PlaneState state : use.states)
      states.append(nameOf(state));
    row["states"] = states;
    all.append(row);
  }
  return all;
}

py::list correctionsOf(const CineMotion& found) {
  py::list all;
  for (const live::CorrectionOutcome& outcome : found.corrections) {
    py::dict row;
    row["phase"] = outcome.correction.phase;
    row["slice"] = outcome.correction.slice;
    row["series"] = outcome.correction.series;
    row["surface"] = outcome.correction.surface;
    row["before_mm"] = outcome.met.beforeMm;
    row["most_mm"] = outcome.met.mostMm;
    row["met"] = outcome.met.met();
    all.append(row);
  }
  return all;
}

py::list findingsOf(const CineMotion& found) {
  py::list all;
  for (const live::CineFinding& finding : found.findings) {
    py::dict row;
    row["fit"] = nameOf(finding.light);
    row["text"] = finding.text.english();
    row["phase"] = finding.phase;
    row["plane"] = finding.plane;
    all.append(row);
  }
  return all;
}

py::dict surfaceDict(const tracking::SurfaceQuality& surface) {
  py::dict all;
  all["volume_ml"] = surface.measuredMl;
  all["fitted_ml"] = surface.fittedMl;
  all["free_ml"] = surface.freeMl;
  all["mean_mm"] = surface.meanMm;
  all["p95_mm"] = surface.p95Mm;
  all["max_mm"] = surface.maxMm;
  all["dice"] = surface.dice;
  all["flipped"] = surface.flipped;
  return all;
}

py::list phases(const PatientMotion& found) {
  py::list all;
  for (const TrackedPhase& phase : found.phases) {
    py::dict surfaces, row;
    for (std::size_t i = 0; i < found.sequence.organs.size(); ++i)
      surfaces[py::str(found.sequence.organs[i].name)] = surfaceDict(phase.quality.surfaces[i]);
    row["seconds"] = phase.seconds;
    row["mean_mm"] = phase.quality.meanMm;
    row["p95_mm"] = phase.quality.p95Mm;
    row["max_mm"] = phase.quality.maxMm;
    row["dice"] = phase.quality.dice;
    row["folded"] = phase.quality.folded;
    row["fit"] = nameOf(phase.verdict.light);
    row["reasons"] = inEnglish(phase.verdict.reasons);
    row["surfaces"] = surfaces;
    all.append(row);
  }
  return all;
}

py::dict indices(const PatientMotion& found) {
  py::dict all;
  for (const auto& [name, each] : found.indices) {
    py::dict row;
    row["end_diastolic_volume_ml"] = each.endDiastolicMl;
    row["end_systolic_volume_ml"] = each.endSystolicMl;
    row["stroke_volume_ml"] = each.strokeVolumeMl;
    row["ejection_fraction"] = each.ejectionFraction;
    row["cardiac_output_l_per_minute"] = each.cardiacOutputLPerMinute;
    row["edv_ml"] = each.endDiastolicMl; // The names before those of the command line.
    row["esv_ml"] = each.endSystolicMl;
    row["sv_ml"] = each.strokeVolumeMl;
    row["ef"] = each.ejectionFraction;
    row["cardiac_output_l_min"] = each.cardiacOutputLPerMinute;
    all[py::str(name)] = row;
    const std::string chamber = anatomy::chamberKey(name);
    if (!chamber.empty() && !all.contains(chamber))
      all[py::str(chamber)] = row;
  }
  return all;
}

} // namespace

MotionSource sourceOf(const live::SequenceFile& file) {
  MotionSource source;
  source.sequence = std::make_shared<sequences::KeyframedSequence>(file.track);
  source.labels = file.labels;
  if (file.system) {
    source.system = file.system->id;
    source.parameters = file.system->parameters;
  }
  for (const auto& organ : file.organs)
    source.surfaces.emplace_back(organ.name, organ.mesh);
  return source;
}

namespace {

/// What a motion from a series and one from images have alike; `of` gets it from either.
template <class Motion, class Of>
void addShared(py::class_<Motion, std::shared_ptr<Motion>>& motion, const Of& of) {
  motion
      .def_property_readonly(
          "sequence",
          [of](const Motion& m) { return std::make_shared<MotionSource>(sourceOf(of(m).sequence)); },
          "It as a `Sequence`: poses at any time, handles, coordinates, and the surfaces at rest.")
      .def_property_readonly(
          "phases", [of](const Motion& m) { return phases(of(m)); },
          "A dict for each phase: seconds; mean_mm, p95_mm, max_mm (distances of the surfaces); dice (None "
          "for "
          "surfaces); folded (places in the tissue); fit (\"good\", \"amber\", \"red\") and reasons; "
          "surfaces "
          "(name, and volume_ml, fitted_ml, free_ml, distances, dice, flipped triangles).")
      .def_property_readonly(
          "indices", [of](const Motion& m) { return indices(of(m)); },
          "Of each cavity, or of the only surface: end_diastolic_volume_ml, end_systolic_volume_ml, "
          "stroke_volume_ml, ejection_fraction, cardiac_output_l_per_minute; a chamber of the heart under "
          "its "
          "name and as \"lv\", \"rv\", \"la\", \"ra\".")
      .def_property_readonly(
          "tissue_ml", [of](const Motion& m) { return of(m).tissueMl; },
          "The outer surface less its cavities, a number a phase; empty for one surface.")
      .def_property_readonly(
          "fit", [of](const Motion& m) { return nameOf(of(m).worst()); }, "Of the worst phase.")
      .def_property_readonly(
          "corresponding", [of](const Motion& m) { return of(m).corresponding; },
          "Whether points were known from phase to phase.")
      .def_property_readonly(
          "warnings", [of](const Motion& m) { return inEnglish(of(m).warnings); },
          "What was mended or assumed.")
      .def(
          "write",
          [of](const Motion& m, const std::filesystem::path& file) {
            unlocked([&] { live::writeSequence(file, of(m).sequence); });
          },
          py::arg("path"), "Writes a .sequence.json, which the program and `sequence` play.")
      .def("__repr__", [of](const Motion& m) {
        return "<PatientMotion of " + std::to_string(of(m).phases.size()) + " phases, " +
               nameOf(of(m).worst()) + ">";
      });
}

void addMotionOfImages(py::module_& module) {
  py::class_<CineMotion, std::shared_ptr<CineMotion>> motion(
      module, "CineMotion",
      "A patient's own motion from images and the labels of a few phases: as a `PatientMotion`, and what is "
      "known "
      "of its images. Made by `track`.");
  addShared(motion, [](const CineMotion& m) -> const PatientMotion& { return m.motion; });
  motion.def_readonly("labelled", &CineMotion::labelled, "The labelled phases.")
      .def_readonly("estimate", &CineMotion::estimate,
                    "Whether only one phase has labels: all other numbers are estimates.")
      .def_property_readonly("planes", &planesOf,
                             "A dict for each plane: name, series, plane, long_axis; weight, likeness (0 to "
                             "1), closure_mm, apart_mm "
                             "(means); fit and reason; states, one for each phase.")
      .def_property_readonly("corrections", &correctionsOf,
                             "A dict for each corrected contour: phase, slice, series, surface; before_mm, "
                             "most_mm (its farthest point from the surface, without and with corrections); "
                             "met.")
      .def_property_readonly("findings", &findingsOf,
                             "A dict for each thing to know: fit, text, phase, plane (or None).");
  module.def(
      "track_images",
      [](const std::filesystem::path& images,
         const std::vector<std::pair<std::size_t, std::vector<std::filesystem::path>>>& labels,
         const std::vector<std::pair<std::string, std::vector<std::string>>>& surfaces, int handles,
         const py::object& rig, std::optional<double> period, const std::vector<int>& leaveOutSeries,
         const std::vector<CorrectedContour>& corrections, bool keepVolumes, int threads,
         const py::object& listener) {
        return trackImages(
            {images, labels, surfaces, handles, period, leaveOutSeries, corrections, keepVolumes}, rig,
            threads, listener);
      },
      py::arg("images"), py::arg("labels"), py::arg("surfaces"), py::arg("handles"), py::arg("rig"),
      py::arg("period"), py::arg("leave_out_series"), py::arg("corrections"), py::arg("keep_volumes"),
      py::arg("threads"), py::arg("progress"), "What `viscera.track` calls for images.");
}

} // namespace

void addPatientMotion(py::module_& module) {
  py::class_<PatientMotion, std::shared_ptr<PatientMotion>> motion(
      module, "PatientMotion",
      "A patient's own motion: one rig of handles, a pose of it for every phase of a series, and how well it "
      "fits. Made by `track`.");
  addShared(motion, [](const PatientMotion& m) -> const PatientMotion& { return m; });
  addMotionOfImages(module);
  module.def(
      "track",
      [](const std::vector<std::filesystem::path>& inputs,
         const std::vector<std::pair<std::string, std::vector<std::string>>>& surfaces, int handles,
         const py::object& rig, std::optional<double> period, const std::vector<double>& times,
         const std::vector<std::size_t>& leaveOut, bool loop, bool keepVolumes,
         std::optional<double> smoothing, double robust, int threads, const py::object& listener) {
        return track(inputs,
                     {surfaces, handles, period, times, leaveOut, loop, keepVolumes, smoothing, robust}, rig,
                     threads, listener);
      },
      py::arg("phases"), py::arg("surfaces"), py::arg("handles"), py::arg("rig"), py::arg("period"),
      py::arg("times"), py::arg("leave_out"), py::arg("loop"), py::arg("keep_volumes"), py::arg("smoothing"),
      py::arg("robust"), py::arg("threads"), py::arg("progress"), "What `viscera.track` calls.");
}

} // namespace viscera::python
