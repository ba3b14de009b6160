#include "viscera/live/taught_quantities.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "sequence_binding.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/circulation/readings.h"
#include "viscera/circulation/scenario.h"
#include "viscera/core/text.h"
#include "viscera/geometry/volume.h"
#include "viscera/heart/beating_heart.h"
#include "viscera/heart/clinical_numbers.h"
#include "viscera/heart/wall_motion.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/sequences/gastric_waves.h"

namespace viscera::live {
namespace {

constexpr double kPercent = 100;
constexpr int kTaughtInstants = 192;
constexpr int kWallInstants = 96;
constexpr auto kResolution = sample_organs::Resolution::medium;

/// A sequence on its sample organ at its own rate.
class Played {
public:
  Played(const sample_organs::SampleLibrary& library, const std::string& id, Progress& progress,
         Threads threads)
      : setup_(setUpSequence(library, id, kResolution, progress, threads)), threads_(threads) {}

  const SequenceSetup& setup() const { return setup_; }
  const sequences::Sequence& sequence() const { return *setup_.sequence; }
  double rate() const { return sequence().standardRatePerMinute(); }
  std::string where() const { return sequence().id() + ", " + significant(rate(), 3) + " a minute"; }

  Points poseAt(double fraction) const {
    Points pose;
    sequence().poseAt(fraction * 60 / rate(), rate(), pose);
    return pose;
  }

  /// The duration of all phases whose name contains this, because ejection may have two parts.
  double millisecondsOf(const std::string& part) const {
    double fraction = 0;
    for (const sequences::Phase& phase : sequence().phases(rate()))
      fraction += phase.name.english().find(part) != std::string::npos ? phase.end - phase.begin : 0;
    return 1000 * 60 / rate() * fraction;
  }

  MovedVolume surface(const std::string& name) const {
    return MovedVolume(surfaceOf(setup_.organ, name), sequence().restHandles(), setup_.system, threads_);
  }

  std::vector<double> cycleMl(const std::string& name, Progress& progress) const {
    const MovedVolume volume = surface(name);
    std::vector<double> milliliters;
    for (int i = 0; i < kTaughtInstants; ++i) {
      progress.throwIfCancelled();
      milliliters.push_back(volume.at(poseAt(static_cast<double>(i) / kTaughtInstants)));
    }
    return milliliters;
  }

private:
  SequenceSetup setup_;
  Threads threads_;
};

class Collector {
public:
  Collector(const sample_organs::SampleLibrary& library, Progress& progress, Threads threads)
      : library_(library), progress_(progress), threads_(threads) {}

  std::vector<TaughtQuantity> collect() {
    addHeartbeat();
    addCirculation();
    addOrgans();
    addStomach();
    addBreathing();
    return std::move(rows_);
  }

private:
  void add(const std::string& id, const std::string& where, double here, std::string remark = {}) {
    rows_.push_back({&anatomy::norm(id), where, here, std::move(remark)});
  }

  void addHeartbeat() {
    const Played beat(library_, "heartbeat", progress_, threads_);
    for (const std::string side : {"lv", "rv"}) {
      const heart::CardiacIndices indices = heart::cardiacIndices(beat.cycleMl(side, progress_), beat.rate());
      add(side + ".edv", beat.where(), indices.endDiastolicMl);
      add(side + ".esv", beat.where(), indices.endSystolicMl);
      add(side + ".sv", beat.where(), indices.strokeVolumeMl);
      add(side + ".ef", beat.where(), kPercent * indices.ejectionFraction);
      if (side == "lv")
        add("heart.output", beat.where(), indices.cardiacOutputLPerMinute);
    }
    add("lv.ivct", beat.where(), beat.millisecondsOf("isovolumic contraction"));
    add("lv.ejection", beat.where(), beat.millisecondsOf("ejection"));
    add("lv.ivrt", beat.where(), beat.millisecondsOf("isovolumic relaxation"));
    addWalls(beat);
    addMuscle();
  }

  void addMuscle() {
    constexpr double kGramsPerMl = 1.05;
    const auto volumeOfSurface = [&](const char* surface) {
      const auto found =
          sample_organs::sampleSurface(library_, "heart", surface, kResolution, progress_, threads_);
      return geometry::volume(found.mesh->points, found.mesh->triangles) / kMm3PerMl;
    };
    add("lv.mass", "sample organ", kGramsPerMl * (volumeOfSurface("lv_wall") - volumeOfSurface("lv")),
        "from the valves' plane on, papillary muscles counted as cavity");
  }

  /// Measures on the surfaces, by vertices that are followed through the beat.
  void addWalls(const Played& beat) {
    const MovedVolume left = beat.surface("lv"), right = beat.surface("rv"), outer = beat.surface("outer");
    const auto pointsOf = [](const MovedVolume& surface, const Points& pose) {
      return surface.surfaceAt(pose).points;
    };
    const Points& rest = beat.sequence().restHandles();
    const Points leftRest = pointsOf(left, rest), rightRest = pointsOf(right, rest),
                 outerRest = pointsOf(outer, rest);
    const heart::WallGauge gauge(beat.sequence().heart()->frame().value(), {leftRest, rightRest, outerRest});
    std::vector<heart::WallPlaces> places;
    for (int i = 0; i < kWallInstants; ++i) {
      progress_.throwIfCancelled();
      const Points pose = beat.poseAt(static_cast<double>(i) / kWallInstants);
      const Points leftNow = pointsOf(left, pose), rightNow = pointsOf(right, pose),
                   outerNow = pointsOf(outer, pose);
      places.push_back(gauge.at({leftNow, rightNow, outerNow}));
    }
    const heart::WallMotion motion = heart::wallMotion(places);
    add("lv.mapse", beat.where(), motion.mapseMm);
    add("rv.tapse", beat.where(), motion.tapseMm);
    add("lv.twist", beat.where(), motion.twistDegrees);
    add("lv.thickening", beat.where(), motion.thickeningPercent);
  }

  void addCirculation() {
    const circulation::Parameters rest = circulation::scenarioParameters("rest");
    const circulation::PeriodicState state = circulation::findPeriodicState(rest, progress_);
    const circulation::Indices indices = circulation::indicesOf(rest, state.beat);
    for (const circulation::Reading& reading : circulation::readings())
      if (!reading.norm.empty())
        add(reading.norm, "circulation, rest", reading.of(indices));
    addExercise();
  }

  void addExercise() {
    const circulation::Parameters exercise = circulation::scenarioParameters("exercise");
    const circulation::Indices indices =
        circulation::indicesOf(exercise, circulation::findPeriodicState(exercise, progress_).beat);
    const std::string where = "circulation, exercise, " + significant(exercise.rate, 3) + " a minute";
    const circulation::ChamberIndices& atrium = indices.of(circulation::Compartment::la);
    add("exercise.systolic", where, indices.aorta.systolic);
    add("exercise.la", where, atrium.meanMmHg);
    add("exercise.a", where, atrium.highestMmHg);
    add("exercise.gradient", where, indices.aorticMeanGradient);
  }

  double volumeOf(const std::string& name) {
    const auto organ = sample_organs::sampleOrgan(library_, name, kResolution, progress_);
    const geometry::TriangleMesh& mesh = *organ.surfaces.front().mesh;
    return geometry::volume(mesh.points, mesh.triangles) / kMm3PerMl;
  }

  void addOrgans() {
    add("heart.volume", "sample organ", volumeOf("heart"),
        "the surface takes in stumps of the great vessels, and the range is one of means");
    add("liver.volume", "sample organ", volumeOf("liver"));
    add("kidney.left", "sample organ", volumeOf("kidney_left"), "with stumps of vessels and ureter");
    add("kidney.right", "sample organ", volumeOf("kidney_right"), "with stumps of vessels and ureter");
    add("stomach.volume", "sample organ", volumeOf("stomach"), "with the ends of oesophagus and duodenum");
  }

  void addStomach() {
    const Played stomach(library_, "peristalsis", progress_, threads_);
    double deepest = 0;
    for (double seconds = 0; seconds < 60 / stomach.rate(); seconds += 1)
      for (const sequences::TravellingMark& wave : stomach.sequence().travelling(seconds, stomach.rate()))
        deepest = std::max(deepest, wave.strength);
    add("stomach.rate", stomach.where(), stomach.rate());
    add("stomach.speed", stomach.where(), sequences::GastricWaves::kSpeed,
        "that of the surface is measured by a test");
    add("stomach.occlusion", stomach.where(), kPercent * deepest, "of the radius of the outside");
  }

  void addBreathing() {
    const Played breath(library_, "breathing", progress_, threads_);
    const MovedVolume liver = breath.surface("outer");
    const auto height = [&](double fraction) {
      return liver.surfaceAt(breath.poseAt(fraction)).points.col(2).mean();
    };
    double drawn = 0;
    for (const sequences::Phase& phase : breath.sequence().phases(breath.rate()))
      drawn += phase.name == "inspiration" ? phase.end - phase.begin : 0;
    add("breathing.rate", breath.where(), breath.rate());
    add("breathing.down", breath.where(), height(0) - height(0.5), "mean of the surface");
    add("breathing.duty", breath.where(), kPercent * drawn);
  }

  const sample_organs::SampleLibrary& library_;
  Progress& progress_;
  Threads threads_;
  std::vector<TaughtQuantity> rows_;
};

/// Three digits, and all of a large number's before the point.
std::string numberText(double value) {
  return significant(value, std::abs(value) < 1000 ? 3 : 4);
}

std::string withUnit(const std::string& number, const anatomy::Norm& norm) {
  return norm.unit.empty() ? number : number + " " + norm.unit;
}

/// "severe stenosis from 40 mmHg".
std::string diseaseText(const anatomy::Norm& norm) {
  std::string text;
  for (const anatomy::DiseaseLimit& limit : norm.disease)
    text += (text.empty() ? "" : "; ") + limit.name + (limit.above ? " from " : " up to ") +
            withUnit(numberText(limit.bound), norm) + " (" + limit.source + ")";
  return text;
}

std::string verdict(const TaughtQuantity& row, const anatomy::Range& range) {
  const std::string said = range.holds(row.here) ? "yes" : "no";
  return row.remark.empty() ? said : said + ": " + row.remark;
}

} // namespace

std::vector<TaughtQuantity> taughtQuantities(const sample_organs::SampleLibrary& library, Progress& progress,
                                             Threads threads) {
  return Collector(library, progress, threads).collect();
}

std::string rangeText(const anatomy::Range& range) {
  if (!std::isfinite(range.low))
    return "up to " + numberText(range.high);
  return numberText(range.low) + (std::isfinite(range.high) ? " to " + numberText(range.high) : " and more");
}

std::string markdownTable(const std::vector<TaughtQuantity>& quantities, const anatomy::Person& person) {
  std::string table = "| quantity | where | here | in healthy adults | within | whose range | source | "
                      "disease |\n"
                      "|---|---|---|---|---|---|---|---|\n";
  for (const TaughtQuantity& row : quantities) {
    const anatomy::Norm& norm = *row.norm;
    const anatomy::Range range = anatomy::rangeOf(norm, person);
    table += "| " + norm.subject + ", " + norm.quantity + " | " + row.where + " | " +
             withUnit(numberText(row.here), norm) + " | " + withUnit(rangeText(range), norm) + " | " +
             verdict(row, range) + " | " + anatomy::meaningOf(norm, person).english() + "; " + norm.people +
             " | " + norm.source + " | " + diseaseText(norm) + " |\n";
  }
  return table;
}

} // namespace viscera::live
