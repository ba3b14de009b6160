#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "array_memory.h"
#include "long_jobs.h"
#include "parts.h"
#include "viscera/circulation/curves.h"
#include "viscera/circulation/indices.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/circulation/response.h"
#include "viscera/circulation/scenario.h"
#include "viscera/circulation/signs.h"

namespace viscera::python {
namespace {

namespace py = pybind11;
using circulation::Indices;
using circulation::Parameters;
using GivenNumbers = std::map<std::string, double>;

/// A periodic state with all that it was found from. Immutable.
struct Circulation {
  std::string scenario;
  Parameters parameters;
  circulation::PeriodicState state;
  Indices indices;
};

Parameters parametersOf(const std::string& scenario, const GivenNumbers& given) {
  Parameters parameters = circulation::scenarioParameters(scenario);
  for (const auto& [name, value] : given)
    circulation::setParameter(parameters, name, value);
  return parameters;
}

py::array_t<double> arrayOf(const std::vector<double>& values) {
  return py::array_t<double>(py::ssize_t(values.size()), values.data());
}

std::shared_ptr<Circulation> circulate(const std::string& scenario, const GivenNumbers& given,
                                       const std::shared_ptr<Circulation>& near, const py::object& listener) {
  const Parameters parameters = parametersOf(scenario, given);
  auto state = resultOfLong(listener, [&](Progress& progress) {
    return circulation::findPeriodicState(parameters, progress, {}, near ? &near->state.start : nullptr);
  });
  const Indices indices = circulation::indicesOf(parameters, state.beat);
  return std::make_shared<Circulation>(Circulation{scenario, parameters, std::move(state), indices});
}

py::dict chamberDict(const circulation::ChamberIndices& chamber) {
  py::dict all;
  all["end_diastolic_volume_ml"] = chamber.edvMl;
  all["end_systolic_volume_ml"] = chamber.esvMl;
  all["stroke_volume_ml"] = chamber.svMl;
  all["ejection_fraction"] = chamber.ef;
  all["edv_ml"] = chamber.edvMl; // The names before those of the command line.
  all["esv_ml"] = chamber.esvMl;
  all["sv_ml"] = chamber.svMl;
  all["ef"] = chamber.ef;
  all["edp_mmHg"] = chamber.edpMmHg;
  all["mean_mmHg"] = chamber.meanMmHg;
  all["highest_mmHg"] = chamber.highestMmHg;
  all["dpdt_max"] = chamber.dpdtMax;
  all["stroke_work_J"] = chamber.strokeWorkJ;
  return all;
}

py::dict arteryDict(const circulation::ArteryIndices& artery) {
  py::dict all;
  all["systolic"] = artery.systolic;
  all["diastolic"] = artery.diastolic;
  all["mean"] = artery.mean;
  return all;
}

/// When each valve opens and shuts, s; None for one that never does.
py::dict valveTimes(const Indices& indices) {
  py::dict all;
  for (std::size_t i = 0; i < circulation::kValves; ++i) {
    const auto& times = indices.valves[i];
    const py::str name(circulation::nameOf(static_cast<circulation::Valve>(i)));
    all[name] = times ? py::object(py::make_tuple(times->opens, times->shuts)) : py::object(py::none());
  }
  return all;
}

py::dict indexDict(const Indices& indices) {
  py::dict all;
  for (std::size_t i = 0; i < circulation::kChambers; ++i)
    all[py::str(circulation::nameOf(static_cast<circulation::Compartment>(i)))] =
        chamberDict(indices.chambers[i]);
  all["aorta"] = arteryDict(indices.aorta);
  all["pulmonary_artery"] = arteryDict(indices.pulmonaryArtery);
  all["cardiac_output_l_per_minute"] = indices.cardiacOutputLMin;
  all["cardiac_output_l_min"] = indices.cardiacOutputLMin;
  all["forward_stroke_ml"] = indices.forwardStrokeMl;
  all["mitral_regurgitation_ml"] = indices.mitralRegurgitationMl;
  all["mitral_regurgitant_fraction"] = indices.mitralRegurgitantFraction;
  all["aortic_regurgitation_ml"] = indices.aorticRegurgitationMl;
  all["aortic_mean_gradient_mmHg"] = indices.aorticMeanGradient;
  all["aortic_peak_gradient_mmHg"] = indices.aorticPeakGradient;
  all["mitral_mean_gradient_mmHg"] = indices.mitralMeanGradient;
  constexpr double kMsPerS = 1000;
  all["isovolumic_contraction_ms"] = kMsPerS * indices.isovolumicContractionSeconds;
  all["ejection_ms"] = kMsPerS * indices.ejectionSeconds;
  all["isovolumic_relaxation_ms"] = kMsPerS * indices.isovolumicRelaxationSeconds;
  all["relaxation_ms"] = kMsPerS * indices.relaxationSeconds;
  all["ejection_s"] = indices.ejectionSeconds;
  all["relaxation_s"] = indices.relaxationSeconds;
  all["arterial_elastance"] = indices.arterialElastance;
  all["coupling_ratio"] = indices.couplingRatio;
  all["valves"] = valveTimes(indices);
  return all;
}

py::dict curves(const Circulation& found) {
  py::dict all;
  for (const auto& curve : circulation::curvesOf(found.parameters, found.state.beat, found.indices))
    all[py::str(curve.name)] = arrayOf(curve.values);
  return all;
}

py::list sounds(const Circulation& found) {
  py::list all;
  for (const auto& sound : circulation::heartSounds(found.parameters, found.state.beat, found.indices))
    all.append(py::make_tuple(sound.name, sound.seconds, sound.loudness));
  return all;
}

GivenNumbers valuesOf(const Parameters& parameters) {
  GivenNumbers all;
  for (const auto& info : circulation::parameterInfos())
    all[info.name] = circulation::parameter(parameters, info.name);
  return all;
}

/// One dict of indices a value.
py::list response(const std::string& name, const std::vector<double>& values, const std::string& scenario,
                  const GivenNumbers& given, const py::object& listener) {
  const Parameters parameters = parametersOf(scenario, given);
  const auto points = resultOfLong(listener, [&](Progress& progress) {
    return circulation::responseTo(parameters, name, values, progress);
  });
  py::list all;
  for (const auto& point : points)
    all.append(indexDict(point.indices));
  return all;
}

void addCatalogue(py::module_& module) {
  using circulation::ParameterInfo;
  using circulation::Scenario;
  py::class_<Scenario>(module, "Scenario", "A state of health or illness of the circulation.")
      .def_readonly("id", &Scenario::id, "As `circulate` takes it: \"aortic-stenosis\".")
      .def_readonly("name", &Scenario::name, "For people.")
      .def_readonly("summary", &Scenario::summary, "What is changed, and what to look at.")
      .def_readonly("left_muscle", &Scenario::leftMuscle,
                    "Muscle of the left ventricle as a part of a healthy one's: drawn, in no equation.")
      .def_property_readonly(
          "changes", [](const Scenario& s) { return GivenNumbers(s.changes.begin(), s.changes.end()); },
          "Parameters that differ from those at rest, and their values.")
      .def("__repr__", [](const Scenario& s) { return "<Scenario " + s.id + ">"; });
  py::class_<ParameterInfo>(module, "CirculationParameter", "A number on which the circulation depends.")
      .def_readonly("name", &ParameterInfo::name, "As `circulate` takes it: \"lvEes\".")
      .def_readonly("title", &ParameterInfo::title, "For people.")
      .def_readonly("unit", &ParameterInfo::unit, "\"mmHg/ml\"; empty for none.")
      .def_readonly("rest", &ParameterInfo::rest, "Of an adult at rest.")
      .def_readonly("minimum", &ParameterInfo::lowest)
      .def_readonly("maximum", &ParameterInfo::highest)
      .def_readonly("source", &ParameterInfo::source, "Where the value at rest comes from.")
      .def("__repr__", [](const ParameterInfo& p) { return "<CirculationParameter " + p.name + ">"; });
  module.def("scenarios", &circulation::scenarios, "Every scenario that `circulate` knows, rest first.");
  module.def("circulation_parameters", &circulation::parameterInfos,
             "Every parameter of `circulate`, in the order of the documentation.");
}

} // namespace

void addCirculation(py::module_& module) {
  addCatalogue(module);
  py::class_<Circulation, std::shared_ptr<Circulation>>(
      module, "Circulation",
      "A beat of the heart that repeats itself, with all pressures, volumes and flows. Immutable. Made by "
      "`circulate`.")
      .def_readonly("scenario", &Circulation::scenario, "Its id.")
      .def_property_readonly(
          "parameters", [](const Circulation& c) { return valuesOf(c.parameters); },
          "Every parameter and its value.")
      .def_property_readonly(
          "converged", [](const Circulation& c) { return c.state.converged; },
          "Whether the beat repeats itself; if not, `failure_reason` says what happens.")
      .def_property_readonly(
          "failure_reason", [](const Circulation& c) { return c.state.failureReason.english(); },
          "Empty when converged.")
      .def_property_readonly(
          "beats", [](const Circulation& c) { return c.state.beats; }, "That were computed to find it.")
      .def_property_readonly(
          "volume_error_ml",
          [](const Circulation& c) {
            return std::abs(circulation::totalVolume(c.state.start) - c.parameters.stressedVolume);
          },
          "How much blood was lost or made, ml.")
      .def_property_readonly(
          "curves", &curves,
          "Name and samples (t) over one beat from the beginning of the ventricles' contraction: \"time_s\", "
          "pressures \"lv_mmHg\", volumes \"lv_ml\", flows \"aortic_ml_s\", openings \"aortic_open\" (0 to "
          "1), \"ecg_mV\", \"sound\".")
      .def_property_readonly(
          "indices", [](const Circulation& c) { return indexDict(c.indices); },
          "What a chart shows beside its curves: for \"lv\", \"rv\", \"la\", \"ra\" a dict "
          "(end_diastolic_volume_ml, end_systolic_volume_ml, stroke_volume_ml, ejection_fraction, edp_mmHg, "
          "mean_mmHg, highest_mmHg, dpdt_max in mmHg/s, stroke_work_J); \"aorta\" and "
          "\"pulmonary_artery\" (systolic, diastolic, mean, mmHg); \"valves\" (opens, shuts, s); "
          "cardiac_output_l_per_minute, ejection_ms, relaxation_ms and others whose names have their units.")
      .def_property_readonly("sounds", &sounds,
                             "The heart sounds of the beat: name, second, loudness (1: the first at rest).")
      .def("__repr__", [](const Circulation& c) {
        return "<Circulation " + c.scenario + (c.state.converged ? "" : ", not periodic") + ">";
      });
  module.def("circulate", &circulate, py::arg("scenario"), py::arg("parameters"), py::arg("near"),
             py::arg("progress"), "What `viscera.circulate` calls.");
  module.def("circulation_response", &response, py::arg("name"), py::arg("values"), py::arg("scenario"),
             py::arg("parameters"), py::arg("progress"), "What `viscera.circulation_response` calls.");
}

} // namespace viscera::python
