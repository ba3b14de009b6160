#include "cli/commands/all_commands.h"

#include <filesystem>

#include <CLI/CLI.hpp>

#include "cli/inputs.h"
#include "cli/listing.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;

/// The outer surface gets the name asked for, a cavity that name with its own: heart.stl, heart-lv.stl.
std::filesystem::path fileOf(const std::filesystem::path& output, const std::string& surface, bool first) {
  if (first)
    return output;
  std::filesystem::path file = output;
  return file.replace_filename(output.stem().string() + "-" + surface + output.extension().string());
}

std::string lastPart(const std::string& name) {
  return name.substr(name.find('/') + 1);
}

/// `viscera sample`: lists the sample organs, or makes one and writes its surfaces.
class SampleCommand final : public Command {
public:
  std::string name() const override { return "sample"; }
  std::string summary() const override { return "List the sample organs, or make one"; }
  std::vector<OutputOption> outputs() const override { return {{"--output"}}; }

  void addOptions(CLI::App& options) override {
    CLI::Option* list = options.add_flag("--list", list_, "List the sample organs");
    options.add_option("ORGAN", organ_, "heart, or heart/lv for one of its surfaces")->excludes(list);
    options
        .add_option("-o,--output", output_,
                    "Surface file to write; cavities go beside it, with their names: heart.stl, heart-lv.stl")
        ->type_name("FILE")
        ->excludes(list);
    options.add_option("--resolution", resolution_, "Fineness of the surface [medium]")
        ->check(CLI::IsMember({"low", "medium", "high"}))
        ->excludes(list);
  }

  Outcome run(CommandContext& context) override {
    if (list_)
      return list(context);
    if (organ_.empty())
      throw UsageError("no sample organ is named", {}, "viscera sample --list shows them");
    return make(context);
  }

private:
  Outcome list(const CommandContext& context) const {
    Outcome outcome;
    outcome.json["organs"] = sample_organs::sampleNames(context.samples);
    for (const auto& name : outcome.json["organs"])
      outcome.text += name.get<std::string>() + "\n";
    return outcome;
  }

  Outcome make(CommandContext& context) const {
    std::string reference = isSample(organ_) ? organ_ : "sample:" + organ_;
    if (!resolution_.empty())
      reference = reference.substr(0, reference.rfind('@')) + "@" + resolution_;
    const std::vector<document::Organ> surfaces = organInputs(reference, context.samples, context.progress);

    Outcome outcome;
    ordered_json& json = outcome.json;
    const document::Organ& outer = surfaces.front();
    json = {{"organ", sampleReference(reference).organ},
            {"resolution", sample_organs::nameOf(sampleReference(reference).resolution)},
            {"vertices", outer.mesh->points.rows()},
            {"triangles", outer.mesh->triangles.rows()},
            {"volumeMl", outer.restVolumeMm3 / kMm3PerMl},
            {"surfaces", ordered_json::array()}};
    Listing listing;
    for (const document::Organ& surface : surfaces) {
      const double volumeMl = surface.restVolumeMm3 / kMm3PerMl;
      const bool first = &surface == &outer;
      ordered_json row = {{"name", first && surfaces.size() > 1 ? "outer" : lastPart(surface.name)},
                          {"vertices", surface.mesh->points.rows()},
                          {"triangles", surface.mesh->triangles.rows()},
                          {"closed", surface.closed()},
                          {"volumeMl", volumeMl}};
      std::string text =
          std::to_string(surface.mesh->triangles.rows()) + " triangles, " + fixed(volumeMl, 1) + " ml";
      if (!output_.empty()) {
        const std::filesystem::path file = fileOf(output_, lastPart(surface.name), first);
        context.progress.throwIfCancelled();
        medical_io::writeSurface(file, *surface.mesh, {.name = surface.name});
        row["file"] = file.string();
        text += ", " + file.string();
      }
      json["surfaces"].push_back(std::move(row));
      listing.add(surface.name, text);
    }
    outcome.text = listing.text();
    return outcome;
  }

  bool list_ = false;
  std::string organ_;
  std::string output_;
  std::string resolution_;
};

} // namespace

std::unique_ptr<Command> sampleCommand() {
  return std::make_unique<SampleCommand>();
}

} // namespace viscera::app::cli
