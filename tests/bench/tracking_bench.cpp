#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "build_paths.h"
#include "cine_heart.h"
#include "cine_phantom.h"
#include "measured_beat.h"
#include "viscera/core/progress.h"
#include "viscera/live/cine_motion.h"
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

/// A motion between two labelled phases, from the images of a phantom; the argument is the noise of their
/// grey values.
void cinePhantom(benchmark::State& state) {
  const tracking::MotionRig rig = tests::CinePhantom::rig();
  const auto planes = tests::CinePhantom::planes({.noise = static_cast<double>(state.range(0))});
  tracking::CineFit fit;
  for (auto _ : state) {
    Progress progress;
    fit = tracking::fitCine(
        rig, {tests::CinePhantom::labelled(0), tests::CinePhantom::labelled(tests::CinePhantom::kSystole)},
        planes, tracking::PhaseTimes::even(tests::CinePhantom::kPhases, 0.8), {}, progress);
  }
  double mean = 0, worst = 0;
  for (std::size_t phase = 0; phase < tests::CinePhantom::kPhases; ++phase) {
    const double volume = rig.volumesMl(rig.vertices(fit.motion.poses[phase]))[1];
    const double off = std::abs(volume - tests::CinePhantom::volumeMl(1, phase));
    mean += off / static_cast<double>(tests::CinePhantom::kPhases - 2);
    worst = std::max(worst, off);
  }
  const double full = tests::CinePhantom::volumeMl(1, 0);
  state.counters["volume_mean_percent"] = 100 * mean / full;
  state.counters["volume_worst_percent"] = 100 * worst / full;
}

/// What can be wrong with a study, by the argument of a benchmark.
enum CineCase {
  asItIs,
  labelsOff,
  sliceMissing,
  sliceShifted,
  noLongAxis,
  systoleOneEarly,
  systoleOneLate,
  oneLabel
};

tests::CineHeartFaults faultsOf(std::int64_t which) {
  switch (which) {
  case labelsOff:
    return {.labelMm = 1.5};
  case sliceMissing:
    return {.missingSlice = 3};
  case sliceShifted:
    return {.shiftedSlice = 3};
  case noLongAxis:
    return {.longAxis = false};
  case systoleOneEarly:
    return {.systoleOff = -1};
  case systoleOneLate:
    return {.systoleOff = 1};
  case oneLabel:
    return {.systole = false};
  default:
    return {};
  }
}

/// Errors of volumes as parts of the one at the end of diastole, over the phases without labels.
struct VolumeErrors {
  double mean = 0, worst = 0;

  void report(benchmark::State& state, const std::string& name) const {
    state.counters[name + "_mean_percent"] = 100 * mean;
    state.counters[name + "_worst_percent"] = 100 * worst;
  }
};

template <class TrueMl>
VolumeErrors volumeErrors(const live::CineMotion& found, std::size_t surface, const TrueMl& trueMl) {
  VolumeErrors errors;
  double count = 0;
  for (std::size_t phase = 0; phase < found.motion.phases.size(); ++phase) {
    if (found.isLabelled(phase))
      continue;
    const double fitted = found.motion.phases[phase].quality.surfaces[surface].fittedMl;
    const double off = std::abs(fitted - trueMl(phase)) / trueMl(0);
    errors.mean += off;
    errors.worst = std::max(errors.worst, off);
    ++count;
  }
  errors.mean /= count;
  return errors;
}

void reportFindings(benchmark::State& state, const live::CineMotion& found) {
  double folded = 0, amber = 0;
  for (const live::TrackedPhase& phase : found.motion.phases) {
    folded += phase.quality.folded;
    amber += phase.verdict.light != tracking::FitLight::good;
  }
  state.counters["folded"] = folded;
  state.counters["phases_not_good"] = amber;
  state.counters["findings"] = static_cast<double>(found.findings.size());
  std::string said;
  for (const live::CineFinding& finding : found.findings)
    if (!finding.phase || *finding.phase == found.emptiest)
      said += (said.empty() ? "" : "; ") + finding.text.english();
  state.SetLabel(said);
}

/// The sample heart rendered as a cine study, two of its phases labelled.
void cineHeart(benchmark::State& state) {
  const tests::MeasuredBeat& truth = beat(25);
  const tests::CineHeart heart(truth);
  const live::LabelledStudy study = heart.study(faultsOf(state.range(0)));
  live::CineMotion found;
  for (auto _ : state) {
    Progress progress;
    found = live::trackCine(study, {}, progress);
  }
  const char* names[] = {"outer", "lv", "rv"};
  for (std::size_t i = 0; i < 3; ++i) {
    state.counters[std::string("mm_") + names[i]] = truth.distanceTo(found.motion, i);
    volumeErrors(found, i, [&](std::size_t phase) { return truth.trueMl(phase, i); }).report(state, names[i]);
  }
  for (std::size_t i = 1; i < 3; ++i)
    if (const auto known = found.motion.indices.find(names[i]); known != found.motion.indices.end())
      state.counters[std::string("ef_off_") + names[i]] =
          100 * (known->second.ejectionFraction - truth.trueEjection(i));
  reportFindings(state, found);
}

/// The right ventricle of one person and its images; phases 0 and 9 are labelled.
class RealCine {
public:
  RealCine() : organs_(VISCERA_SHARED_ORGANS) {}
  bool absent() const {
    return !std::filesystem::exists(organs_ / "cine") || !std::filesystem::exists(organs_ / "cine_mr");
  }
  live::LabelledStudy study(std::int64_t which) const {
    live::CineRequest request;
    request.images = organs_ / "cine_mr";
    request.surfaces = {{"RV", {}}};
    request.labels = {{0, {fileOf(0)}}};
    const std::size_t systole = which == systoleOneEarly ? 8 : which == systoleOneLate ? 10 : 9;
    if (which != oneLabel)
      request.labels.push_back({systole, {fileOf(systole)}});
    if (which == sliceMissing)
      request.leftOutSeries = {9001};
    if (which == noLongAxis)
      request.leftOutSeries = {14001};
    Progress progress;
    live::LabelledStudy study = live::readLabelledStudy(request, progress);
    for (std::size_t plane = 0; plane < study.planes.size() && which == sliceShifted; ++plane)
      if (study.sources[plane].series == 9001)
        study.planes[plane].origin += 5 * study.planes[plane].alongRow;
    if (which == labelsOff)
      for (std::size_t label = 0; label < study.phases.size(); ++label) {
        geometry::TriangleMesh mesh = *study.labels.meshes[label][0];
        mesh.points += tests::smoothError(mesh.points, 1.5, 3 + static_cast<unsigned>(label));
        study.labels.volumesMl[label][0] = geometry::volume(mesh.points, mesh.triangles) / kMm3PerMl;
        study.labels.meshes[label][0] = std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
      }
    return study;
  }
  /// The published surfaces of all phases.
  live::MotionSeries truth() const {
    live::SeriesRequest request;
    request.inputs = {organs_ / "cine"};
    request.periodSeconds = 0.829;
    Progress progress;
    return live::readMotionSeries(request, progress);
  }

private:
  std::filesystem::path fileOf(std::size_t phase) const {
    std::string number = std::to_string(phase);
    number.insert(0, 3 - number.size(), '0');
    return organs_ / "cine" / ("patient1_RV_ENDOCARDIAL_" + number + ".obj");
  }

  std::filesystem::path organs_;
};

void realCine(benchmark::State& state) {
  const RealCine data;
  if (data.absent()) {
    state.SkipWithError("shared/organs/cine or shared/organs/cine_mr is absent");
    return;
  }
  const live::LabelledStudy study = data.study(state.range(0));
  live::CineMotion found;
  for (auto _ : state) {
    Progress progress;
    found = live::trackCine(study, {}, progress);
  }
  const live::MotionSeries truth = data.truth();
  double mean = 0, worst = 0;
  for (std::size_t phase = 0; phase < found.motion.phases.size(); ++phase) {
    if (found.isLabelled(phase))
      continue;
    const tracking::MeshDistance distance(
        std::make_shared<const geometry::TriangleMesh>(truth.corresponding[0].at(phase)));
    const Points vertices = tests::MeasuredBeat::foundAt(found.motion, 0, phase);
    Values apart(vertices.rows());
    Vec3 ignored;
    for (Eigen::Index v = 0; v < vertices.rows(); ++v)
      apart[v] = std::abs(distance.at(vertices.row(v).transpose(), ignored));
    const double mm =
        tracking::spreadOf(apart,
                           tracking::vertexAreas(vertices, found.motion.sequence.organs[0].mesh->triangles))
            .mean;
    mean += mm / static_cast<double>(found.motion.phases.size() - found.labelled.size());
    worst = std::max(worst, mm);
  }
  state.counters["mm"] = mean;
  state.counters["mm_worst_phase"] = worst;
  volumeErrors(found, 0, [&](std::size_t phase) { return truth.volumesMl[phase][0]; }).report(state, "rv");
  reportFindings(state, found);
}

} // namespace

#define VISCERA_ONCE ->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime()->Iterations(1)
BENCHMARK(realRightVentricle)->Arg(30)->Arg(60)->Arg(120) VISCERA_ONCE;
BENCHMARK(cinePhantom)->Arg(0)->Arg(10)->Arg(30) VISCERA_ONCE;
BENCHMARK(cineHeart)->DenseRange(asItIs, oneLabel) VISCERA_ONCE;
BENCHMARK(realCine)->DenseRange(asItIs, oneLabel) VISCERA_ONCE;
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
