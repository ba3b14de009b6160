#include "viscera/live/circulating_heart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "measured_cavities.h"
#include "sample_heart.h"
#include "sequence_binding.h"
#include "viscera/circulation/curves.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/circulation/scenario.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/rig_commands.h"
#include "viscera/heart/beating_heart.h"

namespace viscera::live {
namespace {

using circulation::Compartment;
using heart::CardiacCycle;

/// The ejection fractions at which the sample heart's base descends by the value in `HeartExcursions`.
constexpr double kStandardEjection = 0.58;
constexpr double kStandardRightEjection = 0.547;
/// What the sample heart's atria hold in the rest shape, ml.
constexpr heart::CavityVolumes kRestAtria{59.9, 56.6};
/// The limits of an atrium's volume that can be drawn, ml: with less its wall would cross itself, with more
/// it would reach its neighbours. No scenario reaches these limits (24.6 to 124); a circulation of a user
/// may.
constexpr double kLeastAtriumMl = 24;
constexpr double kMostAtriumMl = 140;

double drawnAtrium(double modelMl) {
  return std::clamp(modelMl, kLeastAtriumMl, kMostAtriumMl);
}

/// The parts of the beat, from the valves' times. Empty parts are left out.
std::vector<sequences::Phase> partsOf(const circulation::Parameters& parameters,
                                      const circulation::Beat& beat, const circulation::Indices& indices,
                                      double begins) {
  const auto& mitral = indices.valves[static_cast<std::size_t>(circulation::Valve::mitral)];
  const auto& aortic = indices.valves[static_cast<std::size_t>(circulation::Valve::aortic)];
  if (!mitral || !aortic)
    return {{"heartbeat", 0, 1}};
  heart::LeftHeartEvents events;
  events.cycle = beat.period;
  events.atriaContract = beat.period - circulation::conductionSeconds(parameters) - begins;
  double before = events.atriaContract;
  const auto next = [&](double after) {
    const double since = after - begins - before;
    return before += std::max(0.0, since - beat.period * std::floor(since / beat.period));
  };
  events.valves.inletShuts = next(mitral->shuts);
  events.valves.outletOpens = before += circulation::bothShutSeconds(*mitral, *aortic, beat.period);
  events.valves.outletShuts = next(aortic->shuts);
  events.valves.inletOpens = before += circulation::bothShutSeconds(*aortic, *mitral, beat.period);
  events.earlyFilling = circulation::earlyFillingSeconds(parameters, beat, indices);
  return heart::phasesOf(events);
}

/// Converts the openings of valves in the circulation to the area between their leaflets.
std::vector<heart::ValveInstants> valvesOf(const circulation::Parameters& parameters,
                                           const circulation::Beat& beat) {
  constexpr double kMm2PerCm2 = 100;
  using circulation::Valve;
  using heart::HeartValve;
  struct Pair {
    HeartValve drawn;
    Valve solved;
    const circulation::ValveAreas& areas;
  };
  const std::array<Pair, heart::kHeartValves> pairs = {
      Pair{HeartValve::mitral, Valve::mitral, parameters.mitral},
      Pair{HeartValve::aortic, Valve::aortic, parameters.aortic},
      Pair{HeartValve::tricuspid, Valve::tricuspid, parameters.tricuspid},
      Pair{HeartValve::pulmonary, Valve::pulmonic, parameters.pulmonic}};
  std::vector<heart::ValveInstants> instants(beat.time.size() - 1);
  for (const Pair& pair : pairs)
    for (std::size_t i = 0; i < instants.size(); ++i) {
      const double z = circulation::apart(beat.openOf(pair.solved)[i]);
      instants[i][static_cast<std::size_t>(pair.drawn)] = {
          kMm2PerCm2 * (pair.areas.leak + (pair.areas.open - pair.areas.leak) * z),
          beat.flowOf(pair.solved)[i]};
    }
  return instants;
}

} // namespace

heart::HeartCourse heartCourse(Text name, const circulation::Parameters& parameters,
                               const circulation::Beat& beat, const circulation::Indices& indices,
                               double leftMuscle) {
  const std::size_t first = circulation::firstDrawn(parameters, beat, heart::kBeforeAtria);
  heart::HeartCourse course{name, beat.period, {}, partsOf(parameters, beat, indices, beat.time[first])};
  const auto& left = beat.volumeOf(Compartment::lv);
  const auto& right = beat.volumeOf(Compartment::rv);
  const auto& leftAtrium = beat.volumeOf(Compartment::la);
  const auto& rightAtrium = beat.volumeOf(Compartment::ra);
  const double full = indices.of(Compartment::lv).edvMl;
  const double rightFull = indices.of(Compartment::rv).edvMl;
  const double strength = std::min(1.0, indices.of(Compartment::lv).ef / kStandardEjection);
  for (std::size_t i = 0; i + 1 < left.size(); ++i) { // The last sample is the first of the next beat.
    heart::HeartInstant instant;
    instant.volumes = {left[i], right[i]};
    instant.state.emptying = (1 - left[i] / full) / kStandardEjection;
    instant.state.rightEmptying = (1 - right[i] / rightFull) / kStandardRightEjection;
    instant.state.leftPart = left[i] / CardiacCycle::kEndDiastole.leftMl;
    instant.state.rightPart = right[i] / CardiacCycle::kEndDiastole.rightMl;
    instant.state.twist = strength * beat.activation[static_cast<std::size_t>(Compartment::lv)][i];
    instant.state.muscle = leftMuscle;
    instant.state.atrialContraction = beat.activation[static_cast<std::size_t>(Compartment::la)][i];
    const heart::CavityVolumes atria{drawnAtrium(leftAtrium[i]), drawnAtrium(rightAtrium[i])};
    instant.atria = atria;
    instant.state.atria =
        heart::AtrialState{atria.leftMl / kRestAtria.leftMl, atria.rightMl / kRestAtria.rightMl};
    course.instants.push_back(instant);
  }
  course.valves = valvesOf(parameters, beat);
  course.begins =
      heart::BeatClock{beat.time[first], circulation::conductionSeconds(parameters), 60 / beat.period};
  const auto begin = static_cast<std::ptrdiff_t>(first);
  std::rotate(course.instants.begin(), course.instants.begin() + begin, course.instants.end());
  std::rotate(course.valves.begin(), course.valves.begin() + begin, course.valves.end());
  return course;
}

namespace {

/// The course of a circulation; empty without a periodic beat.
std::optional<heart::HeartCourse> courseOf(const circulation::Parameters& parameters, Progress& progress) {
  const circulation::PeriodicState found = circulation::findPeriodicState(parameters, progress);
  if (!found.converged)
    return std::nullopt;
  return heartCourse({}, parameters, found.beat, circulation::indicesOf(parameters, found.beat));
}

} // namespace

std::optional<heart::ValveInstants> heartValves(const MotionRecipe& recipe,
                                                const document::CirculationChoice& choice, double fraction,
                                                double ratePerMinute, Progress& progress) {
  if (!sampleHeartOf(recipe))
    return std::nullopt;
  if (!choice.drives)
    return ratePerMinute > 0 ? std::optional(heart::textbookValves(CardiacCycle().beat(ratePerMinute),
                                                                   fraction * 60 / ratePerMinute))
                             : std::nullopt;
  const std::optional<heart::HeartCourse> course = courseOf(choice.parameters, progress);
  return course ? course->valvesAt(fraction) : std::nullopt;
}

std::optional<heart::BeatClock> heartClock(const MotionRecipe& recipe,
                                           const document::CirculationChoice& choice, double fraction,
                                           double ratePerMinute, Progress& progress) {
  if (!sampleHeartOf(recipe))
    return std::nullopt;
  if (!choice.drives)
    return ratePerMinute > 0 ? std::optional(heart::clockOf(CardiacCycle().beat(ratePerMinute),
                                                            fraction * 60 / ratePerMinute))
                             : std::nullopt;
  const std::optional<heart::HeartCourse> course = courseOf(choice.parameters, progress);
  return course ? course->clockAt(fraction) : std::nullopt;
}

struct CirculatingHeart::Parts {
  sample_organs::SampleOrgan organ;
  SampleHeart heart;
  std::shared_ptr<const MeasuredCavities> cavities;
};

namespace {

/// Part of the heart's time that the organ takes when nothing is cached.
constexpr double kOrganPart = 0.8;

} // namespace

CirculatingHeart::CirculatingHeart(const sample_organs::SampleLibrary& library,
                                   sample_organs::Resolution resolution, Progress& progress,
                                   Threads threads) {
  sample_organs::SampleOrgan organ;
  runPart(progress, 0, kOrganPart, [&](Progress& part) {
    organ = sample_organs::sampleOrgan(library, "heart", resolution, part, threads);
  });
  SampleHeart heart = sampleHeart(library, threads);
  progress.throwIfCancelled();
  auto cavities = std::make_shared<const MeasuredCavities>(organ, heart, threads);
  parts_ = std::make_unique<const Parts>(Parts{std::move(organ), std::move(heart), std::move(cavities)});
  progress.report(1);
}

CirculatingHeart::~CirculatingHeart() = default;

const sample_organs::SampleOrgan& CirculatingHeart::organ() const {
  return parts_->organ;
}

std::shared_ptr<const heart::CourseHeartbeat> CirculatingHeart::follow(heart::HeartCourse course,
                                                                       Progress& progress) const {
  const SampleHeart& heart = parts_->heart;
  const auto measured = [cavities = parts_->cavities](const Points& pose) { return cavities->at(pose); };
  const auto measuredAtria = [cavities = parts_->cavities](const Points& pose) {
    return cavities->atriaAt(pose);
  };
  return std::make_shared<heart::CourseHeartbeat>(
      heart::CavityFit(heart.motion, heart.compensation, measured, measuredAtria), std::move(course),
      progress);
}

SequenceSetup CirculatingHeart::setup(heart::HeartCourse course, Progress& progress) const {
  SequenceSetup setup;
  setup.organ = parts_->organ;
  setup.system = parts_->heart.system;
  setup.sequence = follow(std::move(course), progress);
  setup.rig = document::rigOf(*setup.sequence);
  return setup;
}

SequenceSetup circulatingHeart(const sample_organs::SampleLibrary& library, const Text& name,
                               const circulation::Parameters& parameters,
                               sample_organs::Resolution resolution, Progress& progress, Threads threads) {
  Progress quiet;
  progress.throwIfCancelled();
  const circulation::PeriodicState found = circulation::findPeriodicState(parameters, quiet);
  if (!found.converged)
    throw DataError(found.failureReason, name);
  const circulation::Indices indices = circulation::indicesOf(parameters, found.beat);
  const CirculatingHeart heart(library, resolution, progress, threads);
  return heart.setup(heartCourse(phrase("Heartbeat: %1", name), parameters, found.beat, indices,
                                 circulation::leftMuscleOf(name.english())),
                     progress);
}

} // namespace viscera::live
