#include "cli/commands/all_commands.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/played_sequence.h"
#include "cli/positions.h"
#include "cli/stage_options.h"
#include "cli/strain_findings.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"
#include "viscera/document/session_file.h"
#include "viscera/live/motion_runner.h"
#include "viscera/live/patient_motion.h"
#include "viscera/live/sequence_file.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/live/strain_reading.h"
#include "viscera/live/witness_sampling.h"
#include "viscera/presentation/strain_figure.h"

namespace viscera::app::cli {
namespace {

constexpr double kMsOfASecond = 1000;
constexpr int kFewestTracking = 12, kMostTracking = 1000;
constexpr int kFewestInstants = 4, kMostInstants = 500;
constexpr double kTrackingShare = 0.6; ///< Of the progress.

/// `viscera strain MOTION...`: strain of a heart in motion.
class StrainCommand final : public Command {
public:
  std::string name() const override { return "strain"; }
  std::string summary() const override { return "Measure the strain of a heart's wall over its beat"; }
  void addOptions(CLI::App& options) override;
  Outcome run(CommandContext& context) override;

private:
  live::StrainOptions strainOptions() const;
  /// The organs in motion: of a series that is tracked first, or of a sequence that is played.
  live::MovedOrgans moved(CommandContext& context, std::vector<Text>& warnings) const;
  live::MovedOrgans tracked(Progress& progress, const CommandContext& context,
                            std::vector<Text>& warnings) const;
  live::MovedOrgans played(CommandContext& context, std::vector<Text>& warnings) const;
  bool isSequence() const;

  std::vector<std::string> motion_;
  std::string organ_, handles_, scenario_;
  std::string left_, right_, outer_, atrium_;
  std::vector<std::string> surfaces_;
  std::string base_, apex_, insertion_, contours_;
  std::vector<std::size_t> leftOut_;
  double periodMs_ = 0, rate_ = 0;
  int trackedHandles_ = 0, instants_ = live::kStrainInstants, witnesses_ = live::StrainOptions().witnesses;
  std::optional<std::size_t> reference_;
  bool once_ = false;
  std::string csv_, png_, size_ = "1600x1200", theme_ = "light";
};

/// "LV=1,2" taken apart; "LV" alone names a surface.
live::LabelledSurface seriesSurface(const std::string& text) {
  const std::size_t equal = text.find('=');
  live::LabelledSurface surface{text.substr(0, equal), {}};
  for (std::size_t at = equal; at != std::string::npos && at < text.size();) {
    const std::size_t end = std::min(text.find(',', at + 1), text.size());
    if (end > at + 1)
      surface.labels.push_back(text.substr(at + 1, end - at - 1));
    at = end;
  }
  return surface;
}

} // namespace

void StrainCommand::addOptions(CLI::App& options) {
  options
      .add_option("MOTION", motion_,
                  "A series of surfaces or label maps as for 'viscera track', which is tracked first; a "
                  ".sequence.json with its organs; a session (.viscera); or heartbeat")
      ->required();
  options.add_option("--organ", organ_, "What a sequence is to move instead of its own organ")
      ->type_name("ORGAN");
  options.add_option("--handles", handles_, "Handle file; has to hold the sequence's own handles")
      ->type_name("FILE");
  options.add_option("--scenario", scenario_, "State of the circulation that the sample heart follows")
      ->type_name("NAME");
  options.add_option("--lv", left_, "Name of the surface of the left ventricle's cavity; found by its name")
      ->type_name("NAME");
  options
      .add_option("--rv", right_, "Name of the surface of the right ventricle's cavity; found by its name")
      ->type_name("NAME");
  options
      .add_option("--epi", outer_,
                  "Name of the epicardium, or of the whole heart; else the smallest surface around the left "
                  "ventricle")
      ->type_name("NAME");
  options.add_option("--la", atrium_, "Name of the surface of the left atrium's cavity; found by its name")
      ->type_name("NAME");
  options
      .add_option("--surface", surfaces_,
                  "A surface of label maps and the labels within it, as in LV=1; may be repeated")
      ->type_name("NAME=LABELS")
      ->expected(1)
      ->take_all();
  options.add_option("--period-ms", periodMs_, "How long one cycle of a series lasts")
      ->type_name("T")
      ->check(CLI::PositiveNumber);
  options.add_option("--rate", rate_, "Cycles a minute of a sequence")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  options.add_option("--leave-out", leftOut_, "Phases of a series not to use, counted from 1")
      ->type_name("N1,N2,...")
      ->delimiter(',');
  options.add_flag("--once", once_, "The series is not a whole cycle: its last phase does not lead back");
  options.add_option("--tracked-handles", trackedHandles_, "How many handles track a series")
      ->type_name("N")
      ->check(CLI::Range(kFewestTracking, kMostTracking));
  options.add_option("--instants", instants_, "Of a sequence without keys: how many instants of its cycle")
      ->type_name("N")
      ->check(CLI::Range(kFewestInstants, kMostInstants))
      ->capture_default_str();
  options
      .add_option("--reference", reference_,
                  "The phase without strain, counted from 1: the end of diastole; found when not said")
      ->type_name("PHASE")
      ->check(CLI::PositiveNumber);
  options.add_option("--witnesses", witnesses_, "Witness points inside the outer surface")
      ->type_name("N")
      ->check(CLI::Range(live::WitnessOptions::kFewest, live::WitnessOptions::kMost))
      ->capture_default_str();
  options.add_option("--base", base_, "Middle of the mitral annulus, mm LPS; found when not said")
      ->type_name("X,Y,Z");
  options.add_option("--apex", apex_, "Tip of the left ventricle's cavity, mm LPS; found when not said")
      ->type_name("X,Y,Z");
  options
      .add_option("--insertion", insertion_,
                  "Where the right ventricle meets the left one in front, mm LPS; found when not said")
      ->type_name("X,Y,Z");
  options
      .add_option(
          "--contours", contours_,
          "Lists of vertices (.json) in the place of contours that are found: fourChamber, twoChamber, "
          "threeChamber, base, middle, apex, rightFreeWall, leftReservoir")
      ->type_name("FILE");
  options.add_option("--csv", csv_, "Table of all curves")->type_name("FILE");
  options.add_option("--png", png_, "Picture: bull's eyes of the 17 segments, and curves")->type_name("FILE");
  options.add_option("--size", size_, "Size of the picture in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  options.add_option("--theme", theme_, "Colours of the picture")
      ->check(CLI::IsMember({"light", "dark"}))
      ->capture_default_str();
}

live::StrainOptions StrainCommand::strainOptions() const {
  live::StrainOptions options;
  options.left = left_;
  options.right = right_;
  options.outer = outer_;
  options.atrium = atrium_;
  if (reference_)
    options.reference = *reference_ - 1;
  options.witnesses = witnesses_;
  for (const auto& [text, option, target] :
       {std::tuple(&base_, "--base", &options.landmarks.base),
        std::tuple(&apex_, "--apex", &options.landmarks.apex),
        std::tuple(&insertion_, "--insertion", &options.landmarks.insertion)})
    if (!text->empty())
      *target = positionOf(*text, option);
  if (!contours_.empty())
    options.contours = live::readContours(contours_);
  return options;
}

bool StrainCommand::isSequence() const {
  if (motion_.size() != 1)
    return false;
  const auto& samples = live::sampleSequences();
  return live::isSequenceFile(motion_.front()) || document::isSessionFile(motion_.front()) ||
         std::any_of(samples.begin(), samples.end(),
                     [this](const live::SampleSequence& sample) { return sample.id == motion_.front(); });
}

live::MovedOrgans StrainCommand::tracked(Progress& progress, const CommandContext& context,
                                         std::vector<Text>& warnings) const {
  live::SeriesRequest request;
  request.inputs.assign(motion_.begin(), motion_.end());
  for (const std::string& surface : surfaces_)
    request.surfaces.push_back(seriesSurface(surface));
  if (periodMs_ > 0)
    request.periodSeconds = periodMs_ / kMsOfASecond;
  for (const std::size_t phase : leftOut_) {
    if (phase == 0)
      throw UsageError("There is no phase 0", "--leave-out", "phases are counted from 1");
    request.leftOut.push_back(phase - 1);
  }
  request.loop = !once_;
  live::TrackOptions options;
  options.rig.handles = trackedHandles_;
  live::MotionSeries series;
  runPart(progress, 0, 0.1, [&](Progress& part) { series = live::readMotionSeries(request, part); });
  live::PatientMotion found;
  runPart(progress, 0.1, 1,
          [&](Progress& part) { found = live::trackMotion(series, options, part, context.threads); });
  warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
  return live::movedOrgans(series, found, context.systems);
}

live::MovedOrgans StrainCommand::played(CommandContext& context, std::vector<Text>& warnings) const {
  PlayRequest request;
  request.sequence = motion_.front();
  request.organ = organ_;
  request.handles = handles_;
  request.scenario = scenario_;
  request.ratePerMinute = rate_;
  PlayedSequence played = playedSequence(request, context);
  warnings.insert(warnings.end(), played.warnings.begin(), played.warnings.end());
  const document::DocumentState& state = played.bench->state();
  played.bench->setSequence(played.sequence, rate_ > 0 ? rate_ : played.ratePerMinute);
  live::MotionRunner& runner = played.bench->motion();
  runner.prescribe(played.prescribed);
  live::MovedOrgans moved = live::movedOrgans(runner, context.systems, instants_, context.progress);
  for (live::SequenceOrgan& surface : moved.organs) // Files name them otherwise than documents may.
    for (std::size_t i = 0; i < std::min(state.organs->size(), played.surfaces.size()); ++i)
      if ((*state.organs)[i]->mesh == surface.mesh)
        surface.name = played.surfaces[i].name;
  live::addOwnWall(state, context.progress, moved);
  return moved;
}

live::MovedOrgans StrainCommand::moved(CommandContext& context, std::vector<Text>& warnings) const {
  if (isSequence())
    return played(context, warnings);
  live::MovedOrgans found;
  runPart(context.progress, 0, kTrackingShare,
          [&](Progress& part) { found = tracked(part, context, warnings); });
  return found;
}

Outcome StrainCommand::run(CommandContext& context) {
  const auto begin = std::chrono::steady_clock::now();
  const PictureSize size = pictureSize(size_);
  for (const std::string& target : {csv_, png_})
    if (!target.empty())
      const AtomicFile writable(target); // Fails before the work, not after it.
  const live::StrainOptions options = strainOptions();
  std::vector<Text> warnings;
  const live::MovedOrgans organs = moved(context, warnings);
  std::optional<live::StrainReading> reading;
  runPart(context.progress, kTrackingShare, 1,
          [&](Progress& part) { reading = live::readStrain(organs, options, part, context.threads); });
  if (!csv_.empty())
    live::writeStrainTable(csv_, *reading);
  if (!png_.empty())
    presentation::writeStrainPicture(
        png_, *reading,
        {size.width, size.height, theme_ == "dark" ? scene::darkTheme() : scene::lightTheme()});
  Outcome outcome;
  outcome.json = parseJson<nlohmann::ordered_json>(live::strainJson(*reading), "strain", {});
  outcome.text = strainText(*reading);
  for (const auto& [key, target] : {std::pair("csv", csv_), std::pair("png", png_)})
    if (!target.empty()) {
      outcome.json[key] = target;
      outcome.text += std::string(key) + "  " + target + "\n";
    }
  outcome.warnings = std::move(warnings);
  outcome.warnings.insert(outcome.warnings.end(), reading->warnings.begin(), reading->warnings.end());
  outcome.json["warnings"] = inEnglish(outcome.warnings);
  outcome.json["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

std::unique_ptr<Command> strainCommand() {
  return std::make_unique<StrainCommand>();
}

} // namespace viscera::app::cli
