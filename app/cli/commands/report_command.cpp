#include "cli/commands/all_commands.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/inputs.h"
#include "cli/listing.h"
#include "cli/session_input.h"
#include "viscera/core/error.h"
#include "viscera/core/file_facts.h"
#include "viscera/document/axes_commands.h"
#include "viscera/document/organ_commands.h"
#include "viscera/presentation/opened_heart.h"
#include "viscera/report/report_file.h"

namespace viscera::app::cli {
namespace {

/// `viscera report SESSION|ORGAN... -o FILE`: writes a report on a session or organs, for a patient's file.
class ReportCommand final : public Command {
public:
  std::string name() const override { return "report"; }
  std::string summary() const override {
    return "Report on a session or on organs as PDF or HTML: pictures, volumes, measurements, stress, motion";
  }
  std::vector<OutputOption> outputs() const override { return {{"--output"}}; }

  void addOptions(CLI::App& options) override {
    options
        .add_option("WHAT", files_,
                    "One session (.viscera), or organs (surface files, label maps, sample:NAME)")
        ->required();
    options.add_option("-o,--output", output_, "File to write: .pdf or .html")->type_name("FILE")->required();
    options.add_option("--title", title_, "What the report is called; the first organ's name when not said");
    options.add_flag("--stress", stress_,
                     "Tell the stress of the pose, also where the session does not show it");
  }

  Outcome run(CommandContext& context) override {
    const auto begin = std::chrono::steady_clock::now();
    if (!report::isReportFile(output_))
      throw UsageError("A report cannot be written to this kind of file", output_,
                       "let it end in .pdf or .html");
    Outcome outcome;
    Material material = this->material(context, outcome.warnings);
    for (Text& doubt : document::doubtsAboutPatient(*material.state.organs))
      outcome.warnings.push_back(std::move(doubt));
    const auto posed = posedSession(material.state, material.view, context);
    report::ReportSource source;
    source.state = posed->state();
    source.view = material.view;
    source.organs = &posed->organs();
    source.systems = &context.systems;
    if (material.view.scan.warped && material.state.scan && !material.state.measurements->empty()) {
      try {
        if (live::LiveWarp* warp = posed->warp())
          source.tissue = live::tissueMotionOf(*warp);
      } catch (const DataError& error) { // Everything else can be reported.
        outcome.warnings.push_back(error.explanation());
      }
    }
    source.title = title_;
    source.file = material.file;
    source.notes = material.notes;
    source.sequence = posed->sharedSequence();
    if (source.sequence)
      if (Text unsuited =
              live::unsuitedMotion(posed->state(), presentation::motionOf(material.view), *source.sequence);
          !unsuited.empty())
        outcome.warnings.insert(outcome.warnings.begin(), std::move(unsuited));
    if (material.view.playing)
      source.ratePerMinute = material.view.playing->ratePerMinute;
    source.prescribed = live::prescribedVolume(posed->state(), presentation::motionOf(material.view));
    live::StressCopy stress;
    if (material.view.shown.stress || stress_) {
      if (const Text missing = makeStress(*posed, material.view); !missing.empty())
        outcome.warnings.push_back("there is no stress to report: " + missing.english());
      stress = posed->stressMap().copy();
      source.stress = &stress;
      source.stressStatus = posed->stressMap().status();
    }
    source.heartTissue = presentation::heartTissueFor(source.state, source.view, context.samples,
                                                      context.progress, context.threads);
    const report::Report made = report::makeReport(source, context.threads, context.progress);
    context.progress.throwIfCancelled();
    const int pages = report::writeReport(output_, made);
    outcome.json = {{"file", output_},
                    {"pages", pages},
                    {"pictures", made.pictures()},
                    {"bytes", fileBytes(output_)},
                    {"title", made.title},
                    {"sections", nlohmann::ordered_json::array()},
                    {"warnings", outcome.warnings}};
    for (const report::Section& section : made.sections)
      if (!section.title.empty())
        outcome.json["sections"].push_back(section.title);
    outcome.json["warnings"] = outcome.warnings;
    outcome.json["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    outcome.text = Listing()
                       .add("report", output_)
                       .add("pages", std::to_string(pages))
                       .add("pictures", std::to_string(made.pictures()))
                       .text();
    return outcome;
  }

private:
  /// What the report is about.
  struct Material {
    document::DocumentState state;
    presentation::ViewState view;
    std::string file;
    std::vector<Text> notes; ///< Of the files, for its reader.
  };

  Material material(CommandContext& context, std::vector<Text>& warnings) const {
    Material material;
    if (document::isSessionFile(files_.front())) {
      if (files_.size() > 1)
        throw UsageError("A session is reported on alone", files_[1], "name one session, or organs only");
      const document::OpenedSession opened =
          document::readSession(files_.front(), context.samples, context.progress);
      material.state = opened.contents.state;
      material.view = presentation::viewFromJson(opened.contents.view, *opened.contents.state.circulation);
      material.view.shown.rest = false; // A report shows the pose, even if the view shows the handles at
                                        // rest.
      material.file = files_.front();
      material.notes = warnings = opened.warnings;
      return material;
    }
    std::vector<document::NewOrgan> organs;
    for (const std::string& file : files_)
      for (document::Organ& organ : organInputs(file, context.samples, context.progress))
        organs.push_back({std::move(organ), -1});
    document::Document document;
    document::UndoStack undo(document);
    undo.perform(document::addOrgans(std::move(organs)));
    material.state = document.state();
    for (const auto& organ : *material.state.organs)
      warnings.insert(warnings.end(), organ->warnings.begin(), organ->warnings.end());
    return material;
  }

  std::vector<std::string> files_;
  std::string output_;
  std::string title_;
  bool stress_ = false;
};

} // namespace

std::unique_ptr<Command> reportCommand() {
  return std::make_unique<ReportCommand>();
}

} // namespace viscera::app::cli
