#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "build_paths.h"
#include "measured_beat.h"
#include "viscera/core/progress.h"
#include "viscera/live/motion_series.h"
#include "viscera/live/patient_motion.h"

/// How well and how fast a motion is found again (docs/patient_motion.md has the figures).
namespace viscera {
namespace {

/// The sample heart's beat in that many phases; made once.
const tests::MeasuredBeat& beat(std::size_t phases) {
  static std::map<std::size_t, std::unique_ptr<tests::MeasuredBeat>> made;
  auto& one = made[phases];
  if (!one)
    one = std::make_unique<tests::MeasuredBeat>(phases, sample_organs::Resolution::medium);
  return *one;
}

void report(benchmark::State& state, const tests::MeasuredBeat& truth, const live::PatientMotion& found) {
  const char* names[] = {"outer", "lv", "rv"};
  double dice = 0, worst = 1, volume = 0, folded = 0, fit = 0;
  for (const auto& phase : found.phases) {
    for (const auto& surface : phase.quality.surfaces) {
      dice += surface.dice.value_or(0) / static_cast<double>(3 * found.phases.size());
      worst = std::min(worst, surface.dice.value_or(1));
      volume = std::max(volume, std::abs(surface.fittedMl / surface.measuredMl - 1));
    }
    folded += phase.quality.folded;
    fit += phase.quality.meanMm / static_cast<double>(found.phases.size());
  }
  for (std::size_t i = 0; i < 3; ++i)
    state.counters[std::string("mm_") + names[i]] = truth.distanceTo(found, i);
  for (std::size_t i = 1; i < 3; ++i)
    state.counters[std::string("ef_off_") + names[i]] =
        100 * (found.indices.at(names[i]).ejectionFraction - truth.trueEjection(i));
  state.counters["dice"] = dice;
  state.counters["dice_worst"] = worst;
  state.counters["volume_off"] = volume;
  state.counters["folded"] = folded;
  state.counters["fit_mm"] = fit;
}

void run(benchmark::State& state, const tests::MeasuredBeat& truth, const live::MotionSeries& series,
         double robustMm = 0) {
  live::TrackOptions options;
  options.robustMm = robustMm;
  live::PatientMotion found;
  for (auto _ : state) {
    Progress progress;
    found = live::trackMotion(series, options, progress);
  }
  report(state, truth, found);
}

void surfacesOfTheSampleHeart(benchmark::State& state) {
  const auto& truth = beat(25);
  run(state, truth, truth.surfaces());
}

const Vec3 kThick(1.5, 1.5, 8);

void thickSlices(benchmark::State& state) {
  const auto& truth = beat(25);
  run(state, truth, truth.voxels(kThick));
}

void oneMillimetre(benchmark::State& state) {
  const auto& truth = beat(8);
  run(state, truth, truth.voxels(Vec3(1, 1, 1)));
}

/// The argument is the distance, mm, beyond which the fit is robust; 0 for an ordinary one.
void noisyBorder(benchmark::State& state) {
  const auto& truth = beat(12);
  run(state, truth, truth.voxels(kThick, {0.5, 0, false}), static_cast<double>(state.range(0)));
}

void shiftedSlice(benchmark::State& state) {
  const auto& truth = beat(12);
  run(state, truth, truth.voxels(kThick, {0, 3, false}), static_cast<double>(state.range(0)));
}

void papillaryMuscles(benchmark::State& state) {
  const auto& truth = beat(12);
  run(state, truth, truth.voxels(kThick, {0, 0, true}), static_cast<double>(state.range(0)));
}

void cleanTwelve(benchmark::State& state) {
  const auto& truth = beat(12);
  run(state, truth, truth.voxels(kThick));
}

live::MotionSeries without(live::MotionSeries series, const std::vector<std::size_t>& phases) {
  for (auto phase = phases.rbegin(); phase != phases.rend(); ++phase) {
    const auto at = static_cast<std::ptrdiff_t>(*phase);
    series.masks.erase(series.masks.begin() + at);
    series.volumesMl.erase(series.volumesMl.begin() + at);
    series.times.seconds.erase(series.times.seconds.begin() + at);
  }
  return series;
}

void missingPhase(benchmark::State& state) {
  const auto& truth = beat(12);
  run(state, truth, without(truth.voxels(kThick), {2}));
}

/// As a scanner gives them that looks closer at systole.
void unevenTimes(benchmark::State& state) {
  const auto& truth = beat(12);
  run(state, truth, without(truth.voxels(kThick), {6, 8, 10, 11}));
}

void realRightVentricle(benchmark::State& state) {
  const std::filesystem::path folder = std::filesystem::path(VISCERA_SHARED_ORGANS) / "cine";
  if (!std::filesystem::exists(folder)) {
    state.SkipWithError("shared/organs/cine is absent");
    return;
  }
  live::SeriesRequest request;
  request.inputs = {folder};
  request.periodSeconds = 0.829;
  live::TrackOptions options;
  options.rig.handles = static_cast<int>(state.range(0));
  live::PatientMotion found;
  for (auto _ : state) {
    Progress progress;
    found = live::trackMotion(live::readMotionSeries(request, progress), options, progress);
  }
  double mean = 0, worst = 0, most = 0, flipped = 0;
  for (const auto& phase : found.phases) {
    mean += phase.quality.meanMm / static_cast<double>(found.phases.size());
    worst = std::max(worst, phase.quality.meanMm);
    most = std::max(most, phase.quality.maxMm);
    flipped += phase.quality.surfaces[0].flipped;
  }
  state.counters["mean_mm"] = mean;
  state.counters["worst_phase_mm"] = worst;
  state.counters["max_mm"] = most;
  state.counters["flipped"] = flipped;
  state.counters["ef"] = found.indices.begin()->second.ejectionFraction;
}

} // namespace

#define VISCERA_ONCE ->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime()->Iterations(1)
BENCHMARK(realRightVentricle)->Arg(30)->Arg(60)->Arg(120) VISCERA_ONCE;
BENCHMARK(surfacesOfTheSampleHeart) VISCERA_ONCE;
BENCHMARK(thickSlices) VISCERA_ONCE;
BENCHMARK(oneMillimetre) VISCERA_ONCE;
BENCHMARK(cleanTwelve) VISCERA_ONCE;
BENCHMARK(noisyBorder)->Arg(0)->Arg(3) VISCERA_ONCE;
BENCHMARK(shiftedSlice)->Arg(0)->Arg(3) VISCERA_ONCE;
BENCHMARK(papillaryMuscles)->Arg(0)->Arg(3) VISCERA_ONCE;
BENCHMARK(missingPhase) VISCERA_ONCE;
BENCHMARK(unevenTimes) VISCERA_ONCE;

} // namespace viscera
