#include "cli/commands/all_commands.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/cardiac_keys.h"
#include "cli/cine_track.h"
#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/open_files.h"
#include "viscera/live/patient_motion.h"
#include "viscera/live/textbook_motion.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::app::cli {
namespace {

/// `viscera track PHASES... -o M.sequence.json`: tracks a patient's own motion in a series, or with
/// `--images` from cine images and labels of a few phases.
class TrackCommand final : public Command {
public:
  std::string name() const override { return "track"; }
  std::string summary() const override { return "Find a patient's own motion in a series of phases"; }
  std::vector<OutputOption> outputs() const override {
    return {{.name = "--output", .endings = {".sequence.json"}, .stream = true},
            handleOutput("--write-handles"),
            {"--write-organs"}};
  }
  void addOptions(CLI::App& options) override;
  Outcome run(CommandContext& context) override;

private:
  /// The request from the options, checked. Throws `UsageError`.
  live::SeriesRequest request() const;
  /// The series, or the one that a single image has while it beats as the textbook's.
  live::MotionSeries read(const live::SeriesRequest& asked, Progress& progress, Threads threads) const;
  live::TrackOptions trackOptions(std::vector<Text>& warnings) const;
  /// Throws `UsageError` for options that images have no use for.
  void requireSuited() const;
  Outcome runSeries(CommandContext& context) const;
  Outcome runImages(CommandContext& context) const;
  /// Writes the sequence and what else is asked for: all of it, or nothing.
  void write(const live::PatientMotion& found) const;
  /// `images`: null for a series.
  Outcome report(const live::PatientMotion& found, const live::CineMotion* images) const;

  std::vector<std::string> phases_;
  CineTrackOptions images_;
  std::string output_;
  std::string handlesOut_;
  std::string organsOut_;
  std::string rig_;
  std::vector<std::string> surfaces_;
  int handles_ = 0;
  double periodMs_ = 0;
  double rate_ = 0;
  std::vector<double> timesMs_;
  std::vector<std::size_t> leftOut_;
  bool once_ = false;
  bool freeVolumes_ = false;
  double smoothing_ = -1;
  double robustMm_ = 0;
  bool textbook_ = false;
  double ejection_ = live::TextbookBeat().ejectionFraction;
};

using nlohmann::ordered_json;

constexpr double kMsPerSecond = 1000;
constexpr double kSecondsPerMinute = 60;
constexpr int kFewestHandles = 12, kMostHandles = 1000;
constexpr std::size_t kMostWarningsOfAKind = 12;

/// "LV=1,2" taken apart. "RV" alone names the only surface of files of surfaces, where `alone` allows it.
live::LabelledSurface surfaceOf(const std::string& text, bool alone) {
  const std::size_t equal = text.find('=');
  live::LabelledSurface surface{text.substr(0, equal), {}};
  if (equal != std::string::npos)
    for (std::size_t at = equal + 1; at <= text.size();) {
      const std::size_t end = std::min(text.find(',', at), text.size());
      if (end > at)
        surface.labels.push_back(text.substr(at, end - at));
      at = end + 1;
    }
  if (surface.name.empty() || (surface.labels.empty() && !(alone && equal == std::string::npos)))
    throw UsageError("It is not a name and labels", "--surface " + text, "as in --surface EPI=1,2,3");
  return surface;
}

/// "left_ventricle.obj" for "left ventricle": what every file system takes.
std::string fileNameOf(std::string name) {
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return c < 0x80 && std::isalnum(c) == 0 && c != '-' && c != '.'; }, '_');
  return name + ".obj";
}

const char* nameOf(tracking::FitLight light) {
  return light == tracking::FitLight::good ? "good" : light == tracking::FitLight::amber ? "amber" : "red";
}

ordered_json optionalNumber(const std::optional<double>& number) {
  return number ? ordered_json(*number) : ordered_json(nullptr);
}

ordered_json rowOf(const live::TrackedPhase& phase, const std::vector<live::SequenceOrgan>& organs) {
  ordered_json surfaces;
  for (std::size_t i = 0; i < organs.size(); ++i) {
    const tracking::SurfaceQuality& surface = phase.quality.surfaces[i];
    surfaces[organs[i].name] = {{"volumeMl", surface.measuredMl},
                                {"fittedMl", surface.fittedMl},
                                {"freeMl", surface.freeMl},
                                {"meanMm", surface.meanMm},
                                {"p95Mm", surface.p95Mm},
                                {"maxMm", surface.maxMm},
                                {"dice", optionalNumber(surface.dice)},
                                {"flipped", surface.flipped}};
  }
  return {{"timeMs", kMsPerSecond * phase.seconds},
          {"meanMm", phase.quality.meanMm},
          {"p95Mm", phase.quality.p95Mm},
          {"maxMm", phase.quality.maxMm},
          {"dice", optionalNumber(phase.quality.dice)},
          {"surfaces", std::move(surfaces)},
          {"folded", phase.quality.folded},
          {"steps", phase.quality.steps},
          {"light", nameOf(phase.verdict.light)},
          {"reasons", inEnglish(phase.verdict.reasons)}};
}

/// One surface over all phases.
struct Overall {
  double mean = 0, worst = 0, max = 0, lowestDice = 1;
  int flipped = 0;
};

Overall overallOf(const live::PatientMotion& found, std::size_t surface) {
  Overall overall;
  for (const live::TrackedPhase& phase : found.phases) {
    const tracking::SurfaceQuality& quality = phase.quality.surfaces[surface];
    overall.mean += quality.meanMm / static_cast<double>(found.phases.size());
    overall.worst = std::max(overall.worst, quality.meanMm);
    overall.max = std::max(overall.max, quality.maxMm);
    overall.lowestDice = std::min(overall.lowestDice, quality.dice.value_or(1));
    overall.flipped += quality.flipped;
  }
  return overall;
}

} // namespace

void TrackCommand::addOptions(CLI::App& options) {
  options.add_option(
      "PHASES", phases_,
      "Surfaces or label maps, one a phase; a folder of them; a 4D NIfTI; a .seq.nrrd. Several "
      "surfaces a phase are told by their files' names without the last number");
  images_.add(options);
  options.add_option("-o,--output", output_, "The motion: a .sequence.json")->type_name("FILE")->required();
  options.add_option("--write-handles", handlesOut_, "Where to write the handles in their groups, at rest")
      ->type_name("FILE");
  options
      .add_option("--write-organs", organsOut_,
                  "Folder to write the closed surfaces of the first phase into (.obj)")
      ->type_name("DIR");
  auto* count = options.add_option("--handles", handles_,
                                   "How many handles; 60 for one surface, 120 for more when not said");
  count->type_name("N")->check(wholeBetween(kFewestHandles, kMostHandles));
  options.add_option("--rig", rig_, "Handles to use in the place of new ones (.mrk.json)")
      ->type_name("FILE")
      ->excludes(count);
  auto* period = options.add_option("--period-ms", periodMs_, "How long one cycle lasts");
  period->type_name("T")->check(above(0));
  options.add_option("--rate", rate_, "Cycles a minute, in the place of the period")
      ->type_name("PER_MIN")
      ->check(above(0))
      ->excludes(period);
  options.add_option("--times-ms", timesMs_, "When each phase is; evenly over the period when not said")
      ->type_name("T1,T2,...")
      ->delimiter(',');
  options
      .add_option("--surface", surfaces_,
                  "A surface and the labels within it, as in LV=1; the outer one has those of its cavities "
                  "too: EPI=1,2,3; may be repeated")
      ->type_name("NAME=LABELS")
      ->expected(1)
      ->take_all();
  options.add_option("--leave-out", leftOut_, "Phases not to use, counted from 1")
      ->type_name("N1,N2,...")
      ->delimiter(',');
  options.add_flag("--once", once_, "The series is not a whole cycle: its last phase does not lead back");
  options.add_flag("--free-volumes", freeVolumes_, "Do not keep the measured volumes");
  options
      .add_option("--smoothing", smoothing_,
                  "Temporal smoothness; 1e-5 for surfaces with the same triangles, else 1e-4")
      ->check(atLeast(0));
  options
      .add_option("--robust-mm", robustMm_,
                  "Distances beyond it count less: for label maps with outliers; 0: all alike")
      ->check(atLeast(0));
  auto* textbook = options.add_flag(
      "--textbook", textbook_, "PHASES is one image of a heart with cavities: fit the textbook's beat to it");
  options
      .add_option("--ejection-fraction", ejection_,
                  "Ejection fraction of the left ventricle in the textbook's beat (default 0.58)")
      ->needs(textbook);
}

live::SeriesRequest TrackCommand::request() const {
  live::SeriesRequest request;
  request.inputs.assign(phases_.begin(), phases_.end());
  for (const std::string& surface : surfaces_)
    request.surfaces.push_back(surfaceOf(surface, images_.given()));
  if (periodMs_ > 0)
    request.periodSeconds = periodMs_ / kMsPerSecond;
  if (rate_ > 0)
    request.periodSeconds = kSecondsPerMinute / rate_;
  for (const double time : timesMs_)
    request.seconds.push_back(time / kMsPerSecond);
  for (const std::size_t phase : leftOut_) {
    if (phase == 0)
      throw UsageError("There is no phase 0", "--leave-out", "phases are counted from 1");
    request.leftOut.push_back(phase - 1);
  }
  request.loop = !once_;
  return request;
}

live::MotionSeries TrackCommand::read(const live::SeriesRequest& asked, Progress& progress,
                                      Threads threads) const {
  if (!textbook_)
    return live::readMotionSeries(asked, progress);
  live::TextbookBeat beat;
  beat.ejectionFraction = ejection_;
  if (asked.periodSeconds)
    beat.ratePerMinute = kSecondsPerMinute / *asked.periodSeconds;
  return live::textbookSeries(live::readOnePhase(asked, progress), beat, progress, threads);
}

live::TrackOptions TrackCommand::trackOptions(std::vector<Text>& warnings) const {
  live::TrackOptions options;
  options.rig.handles = handles_;
  options.keepVolumes = !freeVolumes_;
  options.robustMm = robustMm_;
  if (smoothing_ >= 0)
    options.smoothing = smoothing_;
  if (!rig_.empty()) {
    options.handles = medical_io::readHandles(rig_);
    for (const Text& warning : options.handles->warnings)
      warnings.push_back(phrase("%1: %2", rig_, warning));
  }
  return options;
}

void TrackCommand::requireSuited() const {
  images_.requireImages();
  if (!images_.given()) {
    if (phases_.empty())
      throw UsageError("There is no series", "PHASES",
                       "name its files, a folder, or a file with several phases; or images (--images)");
    return;
  }
  const std::pair<bool, const char*> unsuited[] = {
      {!phases_.empty(), "PHASES"},       {!timesMs_.empty(), "--times-ms"},
      {!leftOut_.empty(), "--leave-out"}, {once_, "--once"},
      {textbook_, "--textbook"},          {smoothing_ >= 0, "--smoothing"},
      {robustMm_ > 0, "--robust-mm"}};
  for (const auto& [given, name] : unsuited)
    if (given)
      throw UsageError("Images have no use for it", name, "leave it out, or leave out --images");
}

Outcome TrackCommand::run(CommandContext& context) {
  const auto begin = std::chrono::steady_clock::now();
  requireSuited();
  if (!live::isSequenceFile(output_))
    throw UsageError("The name of a sequence file ends in .sequence.json", "-o " + output_,
                     "as in -o beat.sequence.json");
  for (const std::string* target : {&output_, &handlesOut_})
    if (!target->empty())
      const AtomicFile writable(*target); // Fails before the work, not after it.
  Outcome outcome = images_.given() ? runImages(context) : runSeries(context);
  outcome.json["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

Outcome TrackCommand::runSeries(CommandContext& context) const {
  const live::SeriesRequest asked = request();
  std::vector<Text> warnings;
  const live::TrackOptions options = trackOptions(warnings);
  live::MotionSeries series;
  runPart(context.progress, 0, 0.1, [&](Progress& part) { series = read(asked, part, context.threads); });
  live::PatientMotion found;
  runPart(context.progress, 0.1, 1,
          [&](Progress& part) { found = live::trackMotion(series, options, part, context.threads); });
  found.warnings.insert(found.warnings.begin(), warnings.begin(), warnings.end());
  write(found);
  return report(found, nullptr);
}

Outcome TrackCommand::runImages(CommandContext& context) const {
  live::CineRequest asked = images_.request();
  const live::SeriesRequest shared = request();
  asked.surfaces = shared.surfaces;
  asked.periodSeconds = shared.periodSeconds;
  std::vector<Text> warnings;
  const live::TrackOptions options = trackOptions(warnings);
  live::LabelledStudy study;
  runPart(context.progress, 0, 0.2, [&](Progress& part) { study = live::readLabelledStudy(asked, part); });
  live::CineMotion found;
  runPart(context.progress, 0.2, 1,
          [&](Progress& part) { found = live::trackCine(study, options, part, context.threads); });
  found.motion.warnings.insert(found.motion.warnings.begin(), warnings.begin(), warnings.end());
  write(found.motion);
  Outcome outcome = report(found.motion, &found);
  addCineReport(found, outcome);
  return outcome;
}

void TrackCommand::write(const live::PatientMotion& found) const {
  namespace fs = std::filesystem;
  if (!organsOut_.empty()) {
    std::error_code error;
    fs::create_directories(organsOut_, error);
    if (error || !fs::is_directory(organsOut_, error))
      throw CannotCreateError("the folder cannot be made", organsOut_, "choose another one");
    for (const live::SequenceOrgan& organ : found.sequence.organs)
      medical_io::writeSurface(fs::path(organsOut_) / fileNameOf(organ.name), *organ.mesh,
                               {.name = organ.name});
  }
  if (!handlesOut_.empty())
    medical_io::writeHandles(handlesOut_,
                             document::handleFile(document::completed(live::rigOf(found.sequence))));
  live::writeSequence(output_, found.sequence);
}

Outcome TrackCommand::report(const live::PatientMotion& found, const live::CineMotion* images) const {
  Outcome outcome;
  Listing listing;
  const auto& track = found.sequence.track;
  outcome.json["phases"] = ordered_json::array();
  int folded = 0;
  for (const live::TrackedPhase& phase : found.phases) {
    outcome.json["phases"].push_back(rowOf(phase, found.sequence.organs));
    folded += phase.quality.folded;
  }
  outcome.json["periodMs"] = kMsPerSecond * track.periodSeconds;
  outcome.json["loop"] = track.loop;
  outcome.json["handles"] = track.restHandles.rows();
  outcome.json["folded"] = folded;
  outcome.json["correspondence"] = found.corresponding;
  listing
      .add("phases", std::to_string(found.phases.size()) + " over " +
                         fixed(kMsPerSecond * track.periodSeconds, 0) + " ms")
      .add("handles", std::to_string(track.restHandles.rows()));
  if (images != nullptr)
    addCineLines(*images, listing);
  for (std::size_t i = 0; i < found.sequence.organs.size(); ++i) {
    const Overall overall = overallOf(found, i);
    std::string text = fixed(overall.mean, 2) + " mm away on average, " + fixed(overall.worst, 2) +
                       " in the worst phase, " + fixed(overall.max, 1) + " at most";
    if (!found.corresponding && found.sliceMm > 0)
      text += ", Dice " + fixed(overall.lowestDice, 3) + " at least";
    listing.add(found.sequence.organs[i].name, text);
  }
  outcome.json["ejectionFraction"] = ordered_json::object();
  for (const auto& [name, indices] : found.indices) {
    setUnderNames(outcome.json["ejectionFraction"], name, indices.ejectionFraction);
    setUnderNames(outcome.json["indices"], name, cardiacJson(indices));
    listing.add(name + " EF", fixed(indices.ejectionFraction, 3) + " (" + fixed(indices.endDiastolicMl, 1) +
                                  " to " + fixed(indices.endSystolicMl, 1) + " ml)" +
                                  (images != nullptr && images->estimate ? ", an estimate" : ""));
  }
  outcome.json["tissueMl"] = found.tissueMl;
  listing.add("folded", std::to_string(folded) + " places in all phases")
      .add("fit", nameOf(found.worst()))
      .add("sequence", output_);
  outcome.json["light"] = nameOf(found.worst());
  outcome.json["sequence"] = output_;
  for (const auto& [key, target] : {std::pair("handlesFile", handlesOut_), std::pair("organs", organsOut_)})
    if (!target.empty()) {
      outcome.json[key] = target;
      listing.add(key, target);
    }
  outcome.json["warnings"] = found.warnings;
  outcome.warnings = found.warnings;
  if (outcome.warnings.size() > kMostWarningsOfAKind) {
    const std::size_t more = outcome.warnings.size() - kMostWarningsOfAKind;
    outcome.warnings.resize(kMostWarningsOfAKind);
    outcome.warnings.push_back(std::to_string(more) + " more, which --json lists");
  }
  outcome.text = listing.text();
  return outcome;
}

std::unique_ptr<Command> trackCommand() {
  return std::make_unique<TrackCommand>();
}

} // namespace viscera::app::cli
