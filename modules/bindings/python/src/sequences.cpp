#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "array_memory.h"
#include "long_jobs.h"
#include "motion_source.h"
#include "parts.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/sequences/breathing.h"
#include "viscera/sequences/keyframes.h"

namespace viscera::python {
namespace {

namespace py = pybind11;

double rateOf(const MotionSource& motion, const py::object& rate) {
  return rate.is_none() ? motion.sequence->standardRatePerMinute() : rate.cast<double>();
}

py::array poseSequence(const MotionSource& motion, double seconds, const py::object& rate) {
  const double perMinute = rateOf(motion, rate);
  if (!(perMinute >= motion.sequence->lowestRatePerMinute() &&
        perMinute <= motion.sequence->highestRatePerMinute()))
    throw UsageError("it cannot be played at " + std::to_string(perMinute) + " a minute",
                     motion.sequence->name().english(),
                     "between " + std::to_string(motion.sequence->lowestRatePerMinute()) + " and " +
                         std::to_string(motion.sequence->highestRatePerMinute()));
  Points handles;
  unlocked([&] { motion.sequence->poseAt(seconds, perMinute, handles); });
  return handOver(std::move(handles));
}

py::list phases(const MotionSource& motion, const py::object& rate) {
  py::list all;
  for (const auto& phase : motion.sequence->phases(rateOf(motion, rate)))
    all.append(py::make_tuple(phase.name.english(), phase.begin, phase.end));
  return all;
}

py::dict groups(const MotionSource& motion) {
  py::dict all;
  for (const auto& group : motion.sequence->groups())
    all[py::str(group.name)] = group.handles;
  return all;
}

py::dict surfaces(const MotionSource& motion) {
  py::dict all;
  for (const auto& [name, mesh] : motion.surfaces)
    all[py::str(name)] =
        py::make_tuple(share<Points>(std::shared_ptr<const Points>(mesh, &mesh->points)),
                       share<Triangles>(std::shared_ptr<const Triangles>(mesh, &mesh->triangles)));
  return all;
}

template <typename Choice, typename Find>
Choice chosen(const std::string& name, const char* what, Find find) {
  const auto found = find(name);
  if (!found)
    throw UsageError("there is no " + std::string(what) + " '" + name + "'", {}, "see the documentation");
  return *found;
}

std::shared_ptr<MotionSource> keyframes(const py::object& rest, const std::vector<double>& seconds,
                                        const std::vector<py::object>& poses, double period, bool loop,
                                        const std::string& interpolation, const std::string& easing,
                                        const std::string& name) {
  if (seconds.size() != poses.size())
    throw DataError("there are " + std::to_string(poses.size()) + " poses for " +
                        std::to_string(seconds.size()) + " times",
                    "keyframes");
  sequences::KeyframedSequence::Track track;
  track.name = name;
  track.restHandles = *pointsFrom(rest, "rest_handles");
  track.periodSeconds = period;
  track.loop = loop;
  track.interpolation =
      chosen<sequences::Interpolation>(interpolation, "interpolation", sequences::interpolationFromName);
  const auto way = chosen<sequences::Easing>(easing, "easing", sequences::easingFromName);
  for (std::size_t i = 0; i < poses.size(); ++i)
    track.keys.push_back({seconds[i], *pointsFrom(poses[i], "pose " + std::to_string(i + 1)), way});
  MotionSource motion;
  motion.sequence = std::make_shared<sequences::KeyframedSequence>(std::move(track));
  return std::make_shared<MotionSource>(std::move(motion));
}

std::shared_ptr<MotionSource> breathing(const py::object& rest, const py::object& points, double down,
                                        double forward) {
  sequences::LiverExcursion excursion;
  excursion.downMm = down;
  excursion.forwardMm = forward;
  MotionSource motion;
  motion.sequence = std::make_shared<sequences::LiverBreathing>(
      *pointsFrom(rest, "rest_handles"), boundsOf(*pointsFrom(points, "points")),
      std::vector<sequences::HandleGroup>(), excursion);
  return std::make_shared<MotionSource>(std::move(motion));
}

} // namespace

void addSequences(py::module_& module) {
  py::class_<MotionSource, std::shared_ptr<MotionSource>>(
      module, "Sequence", "Motion over time: a pose of h handles at every instant. Immutable.")
      .def_property_readonly("id", [](const MotionSource& m) { return m.sequence->id(); })
      .def_property_readonly(
          "name", [](const MotionSource& m) { return m.sequence->name().english(); }, "For people.")
      .def_property_readonly(
          "rest_handles", [](const MotionSource& m) { return handOver(Points(m.sequence->restHandles())); },
          "What organs are bound to: h x 3 mm.")
      .def_readonly("labels", &MotionSource::labels, "Of the handles; may be empty.")
      .def_property_readonly("groups", &groups, "Name and rows of the handles that move together.")
      .def_property_readonly(
          "rates",
          [](const MotionSource& m) {
            return py::make_tuple(m.sequence->lowestRatePerMinute(), m.sequence->standardRatePerMinute(),
                                  m.sequence->highestRatePerMinute());
          },
          "The lowest, the standard and the highest rate, cycles a minute.")
      .def_readonly("system", &MotionSource::system,
                    "The coordinates for which it was made: an id for `bind`.")
      .def_property_readonly(
          "parameters", [](const MotionSource& m) { return m.parameters.all(); }, "Their parameters.")
      .def_property_readonly(
          "surfaces", &surfaces,
          "The surfaces for which it was made: name, and (points n x 3 mm, triangles m x 3).")
      .def_property_readonly(
          "warnings", [](const MotionSource& m) { return inEnglish(m.warnings); },
          "What a user should look at.")
      .def("pose", &poseSequence, py::arg("seconds"), py::arg("rate") = py::none(),
           "The handles (h x 3, mm) at `seconds` when played at `rate` cycles a minute (none: the standard "
           "one).")
      .def("phases", &phases, py::arg("rate") = py::none(),
           "The parts of one cycle: name, begin and end as fractions of it.")
      .def("__repr__",
           [](const MotionSource& m) { return "<Sequence " + m.sequence->name().english() + ">"; });
  module.def("keyframes", &keyframes, py::arg("rest_handles"), py::arg("seconds"), py::arg("poses"),
             py::arg("period"), py::arg("loop") = true, py::arg("interpolation") = "eased",
             py::arg("easing") = "smooth", py::arg("name") = "Recorded",
             "A sequence out of a few poses (each h x 3, mm) at ascending `seconds` within a `period` (s). "
             "`interpolation`: \"eased\" (`easing`: linear, smooth, in, out, hold) or \"curve\".");
  module.def(
      "breathing", &breathing, py::arg("rest_handles"), py::arg("points"), py::arg("down") = 15.0,
      py::arg("forward") = 4.0,
      "A liver (points n x 3, mm, LPS) in quiet breathing: `down` and `forward` mm at its middle. Its volume "
      "stays.");
}

} // namespace viscera::python
