#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <benchmark/benchmark.h>

#include "build_paths.h"
#include "cine_figures.h"
#include "cine_heart.h"
#include "cine_phantom.h"
#include "measured_beat.h"
#include "temporary_folder.h"
#include "viscera/core/progress.h"
#include "viscera/live/cine_motion.h"
#include "viscera/live/motion_series.h"
#include "viscera/phantom/write_phantom.h"

/// How well a motion is found between two labelled phases from cine images (docs/patient_motion.md has the
/// figures).
namespace viscera {
namespace {

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
  oneLabel,
  unlikeTextbook ///< Of the sample heart: its beat has another course in time.
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

tests::CineTruth truthOf(const tests::MeasuredBeat& beat) {
  return {beat.times.count(),
          [&beat](std::size_t surface, std::size_t phase) { return beat.truth[surface].at(phase); }, true};
}

/// The sample heart rendered as a cine study, two of its phases labelled.
void cineHeart(benchmark::State& state) {
  const tests::MeasuredBeat truth(25, sample_organs::Resolution::medium,
                                  state.range(0) == unlikeTextbook ? 0.5 : 0);
  const tests::CineHeart heart(truth);
  const live::LabelledStudy study = heart.study(faultsOf(state.range(0)));
  live::CineMotion found;
  for (auto _ : state) {
    Progress progress;
    found = live::trackCine(study, {}, progress);
  }
  const tests::CineTruth known = truthOf(truth);
  tests::CineFigures(found, known, {"outer", "lv", "rv"}).report(state);
  tests::CineFigures(found, known, {"outer", "lv", "rv"}).reportTwist(state, 1);
  for (const auto& [name, surface] : {std::pair("lv", 1), std::pair("rv", 2)})
    if (const auto numbers = found.motion.indices.find(name); numbers != found.motion.indices.end())
      state.counters[std::string("ef_off_") + name] =
          100 * (numbers->second.ejectionFraction - truth.trueEjection(static_cast<std::size_t>(surface)));
}

/// A phantom in files as `viscera phantom` writes them, read as a clinic's study: the heart within a chest,
/// six slices 16 mm apart and three long-axis planes, each 3 mm aside, Rician noise, labels of 3 mm cubes in
/// two phases.
class PhantomStudy {
public:
  PhantomStudy()
      : body_(phantom::phantomBody(library_, kResolution, progress_)),
        motion_(library_, body_, {.heartbeat = true}, progress_) {
    phantom::PhantomOptions options;
    options.modality = phantom::Modality::cine;
    options.motion.heartbeat = true;
    options.spacing = Vec3(1.6, 1.6, 8);
    options.slices = {.shortAxis = 6, .gapMm = 8, .longAxis = true};
    options.noise = phantom::Contrast::Noise::rician;
    options.deviation = 12;
    options.shiftSlicesMm = 3;
    options.phases = kPhases;
    options.fieldSpacingMm = 0;
    options.resolution = kResolution;
    phantom::writePhantom(folder_.path(), options, library_, progress_);
  }

  live::LabelledStudy labelled() {
    const std::size_t systole =
        std::size_t(std::lround(motion_.endSystoleSeconds() / motion_.periodSeconds() * double{kPhases}));
    live::CineRequest request;
    request.images = folder_.path() / "cine";
    request.labels = {{0, {labelsOf(0)}}, {systole, {labelsOf(systole)}}};
    return live::readLabelledStudy(request, progress_);
  }
  /// The true surfaces, ordered as a study's.
  tests::CineTruth truth(const std::vector<std::string>& names) {
    return {kPhases,
            [this, names](std::size_t surface, std::size_t phase) {
              motion_.setSeconds(motion_.periodSeconds() * static_cast<double>(phase) / kPhases);
              geometry::TriangleMesh mesh = body_.surfaceOf(tissueOf(names[surface])).mesh;
              mesh.points = motion_.moved(mesh.points);
              return mesh;
            },
            true};
  }

private:
  static constexpr int kPhases = 25;
  static constexpr auto kResolution = sample_organs::Resolution::medium;

  static std::string tissueOf(const std::string& name) {
    return name == "LV"   ? "left ventricle"
           : name == "RV" ? "right ventricle"
           : name == "LA" ? "left atrium"
           : name == "RA" ? "right atrium"
                          : "myocardium";
  }
  std::filesystem::path labelsOf(std::size_t phase) const {
    std::string number = std::to_string(phase);
    number.insert(0, 3 - number.size(), '0');
    return folder_.path() / ("labels_" + number + ".seg.nrrd");
  }

  Progress progress_;
  tests::TemporaryFolder folder_;
  sample_organs::SampleLibrary library_ = tests::cachedLibrary();
  phantom::PhantomBody body_;
  phantom::PhantomMotion motion_;
};

void cinePhantomHeart(benchmark::State& state) {
  PhantomStudy files;
  live::LabelledStudy study;
  live::CineMotion found;
  for (auto _ : state) {
    Progress progress;
    study = files.labelled();
    found = live::trackCine(study, {}, progress);
  }
  const auto& names = study.labels.names;
  const tests::CineTruth known = files.truth(names);
  tests::CineFigures(found, known, names).report(state);
  for (std::size_t surface = 0; surface < names.size(); ++surface)
    if (names[surface] == "LV")
      tests::CineFigures(found, known, names).reportTwist(state, surface);
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
  const live::MotionSeries published = data.truth();
  const tests::CineTruth known{published.volumesMl.size(), [&](std::size_t surface, std::size_t phase) {
                                 return published.corresponding[surface].at(phase);
                               }};
  tests::CineFigures(found, known, {"rv"}).report(state);
}

#define VISCERA_CINE ->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime()->Iterations(1)
BENCHMARK(cinePhantom)->Arg(0)->Arg(10)->Arg(30) VISCERA_CINE;
BENCHMARK(cineHeart)->DenseRange(asItIs, unlikeTextbook) VISCERA_CINE;
BENCHMARK(cinePhantomHeart) VISCERA_CINE;
BENCHMARK(realCine)->DenseRange(asItIs, oneLabel) VISCERA_CINE;

} // namespace
} // namespace viscera
