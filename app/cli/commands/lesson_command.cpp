#include "cli/commands/all_commands.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/inputs.h"
#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "cli/played_sequence.h"
#include "cli/session_input.h"
#include "viscera/core/error.h"
#include "viscera/core/file_facts.h"
#include "viscera/core/text.h"
#include "viscera/document/organ_commands.h"
#include "viscera/lesson/animated_gltf.h"
#include "viscera/lesson/lesson.h"
#include "viscera/lesson/lesson_plan.h"
#include "viscera/live/heart_tissue.h"
#include "viscera/live/sequence_file.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/presentation/opened_heart.h"
#include "viscera/presentation/view_state.h"

namespace viscera::app::cli {
namespace {

constexpr int kMostLessonHandles = 60;
constexpr double kErrorToTell = 0.05; ///< mm; a larger error is reported.

bool isSequence(const std::string& name) {
  const auto& known = live::sampleSequences();
  return live::isSequenceFile(name) ||
         std::any_of(known.begin(), known.end(), [&](const auto& sequence) { return sequence.id == name; });
}

/// Whether it is a sequence of the program on the sample organ that it is made for.
bool isOnItsOwnOrgan(const std::string& sequence, const std::string& organ) {
  const auto& known = live::sampleSequences();
  return std::any_of(known.begin(), known.end(), [&](const live::SampleSequence& sample) {
    return sample.id == sequence &&
           (organ.empty() || (isSample(organ) && sampleReference(organ).organ == sample.organ));
  });
}

/// "en, de, es".
std::string languages() {
  std::string codes;
  for (const lesson::PageLanguage& language : lesson::pageLanguages())
    codes += (codes.empty() ? "" : ", ") + language.code;
  return codes;
}

std::string contentsOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw NoInputError("It cannot be read", file, "check the path");
  return restOf(stream, file);
}

nlohmann::ordered_json surfacesJson(const lesson::LessonPlan& plan, const document::DocumentState& state) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const lesson::PlannedSurface& surface : plan.surfaces) {
    const auto organ = state.organ(surface.organ);
    list.push_back({{"title", surface.title},
                    {"vertices", organ->mesh->points.rows()},
                    {"triangles", organ->mesh->triangles.rows()},
                    {"restMl", organ->closed() ? nlohmann::ordered_json(organ->restVolumeMm3 / kMm3PerMl)
                                               : nlohmann::ordered_json(nullptr)}});
  }
  return list;
}

/// `viscera lesson SEQUENCE|SESSION|ORGAN -o FILE`: organs in motion as a web page, or as animated glTF.
class LessonCommand final : public Command {
public:
  std::string name() const override { return "lesson"; }
  std::string summary() const override {
    return "Make a lesson of organs in motion that opens in any browser, or animated glTF";
  }
  std::vector<OutputOption> outputs() const override { return {{"--output"}}; }
  void addOptions(CLI::App& options) override;
  Outcome run(CommandContext& context) override;

private:
  /// What a lesson is made of, bound.
  struct Material {
    std::unique_ptr<workbench::Workbench> bench;
    lesson::LessonSource source;
    std::vector<Text> warnings;
    bool cut = false; ///< A session shows its heart cut open.
  };

  Material material(CommandContext& context) const;
  Material ofSession(CommandContext& context) const;
  Material ofSequence(CommandContext& context) const;
  Material ofStillOrgans(CommandContext& context) const;
  void addHeart(CommandContext& context, Material& material) const;
  lesson::LessonSpec spec(const lesson::LessonSource& source) const;
  Outcome write(const std::filesystem::path& file, CommandContext& context) const;
  Outcome writeReady(CommandContext& context);

  PlayRequest request_; ///< `sequence` is the file, sequence or organ that was named.
  std::string output_;
  std::string spec_;
  std::string title_;
  std::string language_;
  std::vector<std::string> names_;
  double rate_ = 0;
  int handles_ = -1; ///< -1: the number in the spec, or the default.
  bool cut_ = false;
  bool conduction_ = false;
  bool ready_ = false;
};

void LessonCommand::addOptions(CLI::App& options) {
  options.add_option(
      "WHAT", request_.sequence,
      "heartbeat, peristalsis or breathing, a .sequence.json file, a session (.viscera), or organs "
      "that are still");
  options
      .add_option("-o,--output", output_,
                  "File to write: .html, or .glb for animated glTF; with --ready a folder")
      ->type_name("FILE")
      ->required();
  options.add_flag("--ready", ready_, "Write the three lessons that come with the program");
  options.add_option("--organ", request_.organ, "What a sequence is to move instead of its own organ")
      ->type_name("ORGAN");
  options
      .add_option(
          "--landmarks", request_.landmarks,
          "Points on that organ (.mrk.json), as for viscera play; those that are missing are computed")
      ->type_name("FILE");
  options.add_option("--handles", handles_, "How many handles there are to drag; 0: none")
      ->type_name("N")
      ->check(wholeBetween(0, kMostLessonHandles));
  options
      .add_option("--rate", rate_,
                  "Rate at which the page starts, in cycles a minute; the only rate of a .glb")
      ->type_name("PER_MINUTE")
      ->check(above(0));
  options.add_flag("--cut", cut_, "Let the reader cut the sample heart open (.html)");
  options.add_flag("--conduction", conduction_, "Put in the sample heart's conduction system (.html)");
  options.add_option("--title", title_, "What the lesson is called");
  options.add_option("--language", language_, "Of the page's own texts: " + languages())->type_name("CODE");
  options.add_option("--name", names_, "Another name for an organ or a phase; may be repeated")
      ->type_name("OLD=NEW")
      ->expected(1)
      ->take_all();
  options
      .add_option("--spec", spec_, "Names of parts, slides and texts for the lesson (.json, docs/lessons.md)")
      ->type_name("FILE");
}

Outcome LessonCommand::run(CommandContext& context) {
  if (ready_)
    return writeReady(context);
  if (request_.sequence.empty())
    throw UsageError("A sequence, a session or an organ is missing", "viscera lesson",
                     "name a sequence, a session or an organ, or give --ready");
  const std::string ending = std::filesystem::path(output_).extension().string();
  if (ending != ".html" && ending != ".glb")
    throw UsageError("A lesson cannot be written to this kind of file", output_,
                     "let it end in .html or .glb");
  return write(output_, context);
}

Outcome LessonCommand::writeReady(CommandContext& context) {
  std::error_code error;
  std::filesystem::create_directories(output_, error);
  if (error || !std::filesystem::is_directory(output_, error))
    throw CannotCreateError("the folder cannot be made", output_, "choose another one");
  Outcome all;
  all.json = {{"folder", output_}, {"lessons", nlohmann::ordered_json::array()}};
  for (const live::SampleSequence& sequence : live::sampleSequences()) {
    request_.sequence = sequence.id;
    Outcome one = write(std::filesystem::path(output_) / (sequence.id + ".html"), context);
    all.json["lessons"].push_back(std::move(one.json));
    all.text += one.text;
    all.warnings.insert(all.warnings.end(), one.warnings.begin(), one.warnings.end());
  }
  return all;
}

LessonCommand::Material LessonCommand::ofSession(CommandContext& context) const {
  const document::OpenedSession opened =
      document::readSession(request_.sequence, context.samples, context.progress);
  const presentation::ViewState view =
      presentation::viewFromJson(opened.contents.view, *opened.contents.state.circulation);
  Material material;
  material.warnings = opened.warnings;
  material.bench = benchFor(context);
  material.bench->restore(opened.contents);
  material.source.sequence = sequenceOf(opened.contents.state, view, context);
  if (material.source.sequence)
    if (Text unsuited = live::unsuitedMotion(opened.contents.state, presentation::motionOf(view),
                                             *material.source.sequence);
        !unsuited.empty())
      material.warnings.insert(material.warnings.begin(), std::move(unsuited));
  if (view.playing)
    material.source.ratePerMinute = view.playing->ratePerMinute;
  material.source.prescribed = live::prescribedVolume(opened.contents.state, presentation::motionOf(view));
  material.source.camera = view.camera;
  material.source.slides = view.slides;
  material.source.person = view.person;
  material.source.conduction = material.source.conductionShown = view.conduction;
  material.cut = presentation::openedHeart(opened.contents.state, view).has_value();
  if (material.cut)
    material.source.cut = view.cut;
  return material;
}

/// The walls and the conduction system that a session shows, or that the options ask for.
void LessonCommand::addHeart(CommandContext& context, Material& material) const {
  lesson::LessonSource& source = material.source;
  if (!cut_ && !material.cut && !conduction_)
    return;
  const auto heart = live::sampleHeartIn(source.state);
  if (!heart)
    throw UsageError("There is no sample heart in it", request_.sequence, "use heartbeat or sample:heart");
  source.conduction = source.conduction || conduction_;
  if (!cut_ && !material.cut)
    return;
  source.tissue = live::makeHeartTissue(*heart, context.samples, context.progress, context.threads);
  if (!source.tissue)
    material.warnings.emplace_back(
        std::string("this heart cannot be cut open: this version makes another one"));
}

LessonCommand::Material LessonCommand::ofSequence(CommandContext& context) const {
  PlayedSequence played = playedSequence(request_, context);
  return {
      std::move(played.bench), {.state = {}, .sequence = played.sequence}, std::move(played.warnings), false};
}

LessonCommand::Material LessonCommand::ofStillOrgans(CommandContext& context) const {
  Material material;
  std::vector<document::NewOrgan> organs;
  for (document::Organ& organ : organInputs(request_.sequence, context.samples, context.progress)) {
    material.warnings.insert(material.warnings.end(), organ.warnings.begin(), organ.warnings.end());
    organs.push_back({std::move(organ), -1});
  }
  material.bench = benchFor(context);
  material.bench->perform(document::addOrgans(std::move(organs)));
  return material;
}

LessonCommand::Material LessonCommand::material(CommandContext& context) const {
  Material material = document::isSessionFile(request_.sequence) ? ofSession(context)
                      : isSequence(request_.sequence)            ? ofSequence(context)
                                                                 : ofStillOrgans(context);
  material.source.state = material.bench->state();
  if (rate_ > 0)
    material.source.ratePerMinute = rate_;
  if (std::filesystem::path(output_).extension() == ".html")
    addHeart(context, material);
  return material;
}

lesson::LessonSpec LessonCommand::spec(const lesson::LessonSource& source) const {
  const bool own = isOnItsOwnOrgan(request_.sequence, request_.organ);
  lesson::LessonSpec spec = !spec_.empty() ? lesson::readSpec(contentsOf(spec_), spec_)
                            : own          ? lesson::readySpec(request_.sequence)
                                           : lesson::readySpecFor(source);
  if (!language_.empty())
    spec.language = language_;
  if (!title_.empty())
    spec.title = title_;
  if (handles_ >= 0)
    spec.handles = handles_;
  for (const std::string& name : names_) {
    const std::size_t equal = name.find('=');
    if (equal == std::string::npos)
      throw UsageError("It is not an old and a new name", "--name " + name, "as in lv='Left ventricle'");
    spec.names[name.substr(0, equal)] = name.substr(equal + 1);
  }
  return spec;
}

Outcome LessonCommand::write(const std::filesystem::path& file, CommandContext& context) const {
  Material material = this->material(context);
  const lesson::LessonPlan plan = lesson::planLesson(material.source, spec(material.source));
  const auto begin = std::chrono::steady_clock::now();
  Outcome outcome;
  outcome.warnings = std::move(material.warnings);
  outcome.json = {{"file", file.string()}};
  live::PosedOrgans& organs = material.bench->organs();
  double error = 0;
  if (file.extension() == ".glb") {
    const lesson::WrittenGltf written =
        lesson::writeAnimatedGltf(file, plan, material.source, organs, context.progress, context.threads);
    outcome.json.update({{"bytes", written.bytes}, {"frames", written.frames}, {"modes", written.modes}});
    error = written.largestErrorMm;
  } else {
    const lesson::Lesson made =
        lesson::makeLesson(plan, material.source, organs, context.progress, context.threads);
    lesson::writePage(file, made);
    outcome.json.update(
        {{"bytes", fileBytes(file)}, {"frames", made.instants()}, {"modes", made.modes.size()}});
    outcome.json.update({{"cut", made.tissue.has_value()}, {"conduction", made.conduction.has_value()}});
    error = made.largestErrorMm;
  }
  outcome.json["largestErrorMm"] = error;
  outcome.json["surfaces"] = surfacesJson(plan, material.source.state);
  outcome.json["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (error > kErrorToTell)
    outcome.warnings.push_back("the motion in the lesson is off by up to " + fixed(error, 2) + " mm");
  outcome.text = Listing()
                     .add("lesson", file.string())
                     .add("bytes", std::to_string(outcome.json["bytes"].get<std::size_t>()))
                     .add("modes", std::to_string(outcome.json["modes"].get<std::size_t>()))
                     .add("largest error", fixed(error, 3) + " mm")
                     .text();
  return outcome;
}

} // namespace

std::unique_ptr<Command> lessonCommand() {
  return std::make_unique<LessonCommand>();
}

} // namespace viscera::app::cli
