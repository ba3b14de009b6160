#include "viscera/motion/circulating_heart.h"

#include <algorithm>

#include "viscera/circulation/periodic_state.h"
#include "viscera/core/error.h"
#include "viscera/motion/sequence_setup.h"

namespace viscera::motion {
namespace {

using circulation::Compartment;
using sequences::CardiacCycle;

/// The ejection fraction with which the sample heart's base descends as far as `HeartExcursions` has it.
constexpr double kStandardEjection = 0.58;

/// The parts of the beat, from the valves' times. Empty parts are left out.
std::vector<sequences::Phase> phasesOf(const circulation::Parameters& parameters,
                                       const circulation::Beat& beat, const circulation::Indices& indices) {
  const auto& mitral = indices.valves[static_cast<std::size_t>(circulation::Valve::mitral)];
  const auto& aortic = indices.valves[static_cast<std::size_t>(circulation::Valve::aortic)];
  if (!mitral || !aortic)
    return {{"heartbeat", 0, 1}};
  const double atrial = std::max(mitral->opens, beat.period - parameters.conduction);
  std::vector<sequences::Phase> phases;
  double begin = 0;
  const auto until = [&](const char* name, double seconds) {
    const double end = std::clamp(seconds / beat.period, begin, 1.0);
    if (end > begin)
      phases.push_back({name, begin, end});
    begin = end;
  };
  until("isovolumic contraction", aortic->opens);
  until("ejection", aortic->shuts);
  until("isovolumic relaxation", mitral->opens);
  until("filling", atrial);
  until("atrial systole", beat.period);
  return phases;
}

} // namespace

sequences::HeartCourse heartCourse(const std::string& name, const circulation::Parameters& parameters,
                                   const circulation::Beat& beat, const circulation::Indices& indices) {
  sequences::HeartCourse course{name, beat.period, {}, phasesOf(parameters, beat, indices)};
  const auto& left = beat.volumeOf(Compartment::lv);
  const auto& right = beat.volumeOf(Compartment::rv);
  const double full = indices.of(Compartment::lv).edvMl;
  const double strength = std::min(1.0, indices.of(Compartment::lv).ef / kStandardEjection);
  for (std::size_t i = 0; i + 1 < left.size(); ++i) { // The last sample is the first of the next beat.
    sequences::CourseInstant instant;
    instant.volumes = {left[i], right[i]};
    instant.state.emptying = (1 - left[i] / full) / kStandardEjection;
    instant.state.leftPart = left[i] / CardiacCycle::kEndDiastole.leftMl;
    instant.state.rightPart = right[i] / CardiacCycle::kEndDiastole.rightMl;
    instant.state.twist = strength * beat.activation[static_cast<std::size_t>(Compartment::lv)][i];
    instant.state.atrialContraction = beat.activation[static_cast<std::size_t>(Compartment::la)][i];
    course.instants.push_back(instant);
  }
  return course;
}

SequenceSetup circulatingHeart(const sample_organs::SampleLibrary& library, const std::string& name,
                               const circulation::Parameters& parameters,
                               sample_organs::Resolution resolution, Progress& progress, Threads threads) {
  Progress quiet;
  progress.throwIfCancelled();
  const circulation::PeriodicState found = circulation::findPeriodicState(parameters, quiet);
  if (!found.converged)
    throw DataError(found.complaint, name);
  const circulation::Indices indices = circulation::indicesOf(parameters, found.beat);
  return courseSetup(library, heartCourse("Heartbeat: " + name, parameters, found.beat, indices), resolution,
                     progress, threads);
}

} // namespace viscera::motion
