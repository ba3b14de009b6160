#include "cli/commands/all_commands.h"

#include <algorithm>
#include <chrono>
#include <map>

#include <CLI/CLI.hpp>

#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "viscera/phantom/write_phantom.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;

/// `viscera phantom`: images of organs whose motion is known everywhere.
class PhantomCommand final : public Command {
public:
  std::string name() const override { return "phantom"; }
  std::string summary() const override { return "Make a moving phantom with exact motion"; }

  void addOptions(CLI::App& options) override {
    phantom::MotionOptions& motion = made_.motion;
    options.add_flag("--heartbeat", motion.heartbeat, "The heart beats");
    options.add_flag("--breathing", motion.breathing,
                     "The liver, what is around it and the heart go with the breath");
    options
        .add_option("--ejection-fraction", motion.ejectionFraction,
                    "Of the left ventricle, 0.2 to 0.7 [0.58]")
        ->check(between(0.2, 0.7));
    options.add_option("--rate", motion.beatsPerMinute, "Beats a minute, 40 to 150 [75]")
        ->check(between(40, 150));
    options.add_option("--modality", modality_, "ct, cine (DICOM, MR) or labels [ct]")
        ->check(CLI::IsMember({"ct", "cine", "labels"}));
    options
        .add_option("--spacing", spacing_,
                    "mm along x, y and z [3,3,3]; of a cine pixels and thickness [1.5,1.5,8]")
        ->type_name("X,Y,Z");
    options
        .add_option(
            "--slices", slices_,
            "Of a cine: sax:N,GAP for N slices across the left ventricle with gaps in mm, and lax for planes "
            "along it [sax:9,2 lax]")
        ->type_name("sax:N,GAP lax");
    options
        .add_option("--noise", noise_, "rician:S or gaussian:S, S being the deviation in the image's unit")
        ->type_name("KIND:S");
    options
        .add_option("--shift-slices", made_.shiftSlicesMm, "How far each slice of a cine lies aside, mm [0]")
        ->check(between(0, 30));
    options.add_option("--phases", phases_, "Images over one beat or breath [20; of a cine 25]")
        ->check(wholeBetween(1, 200));
    options
        .add_option("--fields", made_.fieldSpacingMm, "Spacing of the displacement fields, mm; 0: none [8]")
        ->check(between(0, 40));
    options.add_flag(
        "--over-time", made_.overTime,
        "One file over time for the CT and one for the labels (4D NIfTI, .seq.nrrd), not one for "
        "each phase");
    options.add_option("--format", format_, "Of volumes and fields: nrrd or nifti [nrrd]")
        ->check(CLI::IsMember({"nrrd", "nifti"}));
    options.add_option("--seed", made_.seed, "Of grain, noise and shifts [1]");
    options.add_option("-o,--output", folder_, "Folder to write into; made when it is not there")
        ->type_name("FOLDER")
        ->required();
  }

  Outcome run(CommandContext& context) override {
    const auto begin = std::chrono::steady_clock::now();
    const phantom::PhantomReport report =
        phantom::writePhantom(folder_, chosen(), context.samples, context.progress, context.threads);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return outcomeOf(report, seconds);
  }

private:
  phantom::PhantomOptions chosen() const {
    phantom::PhantomOptions options = made_;
    options.modality = phantom::modalityFrom(modality_);
    const bool cine = options.modality == phantom::Modality::cine;
    options.spacing = !spacing_.empty() ? phantom::spacingFrom(spacing_)
                      : cine            ? Vec3(1.5, 1.5, 8)
                                        : Vec3::Constant(3);
    constexpr int kCinePhases = 25;
    options.phases = phases_ > 0 ? phases_ : cine ? kCinePhases : options.phases;
    if (!slices_.empty())
      options.slices = phantom::slicesFrom(slices_);
    if (!noise_.empty())
      phantom::setNoise(noise_, options);
    options.format = format_ == "nifti" ? ".nii.gz" : ".nrrd";
    return options;
  }

  Outcome outcomeOf(const phantom::PhantomReport& report, double seconds) const {
    Outcome outcome;
    if (report.foldedMl > 0)
      outcome.warnings.push_back(misuse("the motion folds %1 ml of space, where the way back is a guess",
                                        inDigits(report.foldedMl)));
    outcome.json = {{"folder", folder_}, {"phases", ordered_json::array()}};
    std::map<std::string, std::pair<double, double>> ranges;
    for (const phantom::PhantomPhase& phase : report.phases) {
      outcome.json["phases"].push_back({{"timeMs", 1000 * phase.seconds},
                                        {"beatFraction", phase.beatFraction},
                                        {"inspiration", phase.inspiration}});
      for (const auto& [tissue, ml] : phase.volumesMl) {
        const auto [range, isNew] = ranges.emplace(tissue, std::pair(ml, ml));
        range->second = {std::min(range->second.first, ml), std::max(range->second.second, ml)};
      }
    }
    Listing listing;
    listing.add("folder", folder_);
    listing.add("phases", std::to_string(report.phases.size()));
    for (const auto& [tissue, range] : ranges) {
      outcome.json["volumes"][tissue] = {{"minMl", range.first}, {"maxMl", range.second}};
      listing.add(tissue, fixed(range.first, 1) + " to " + fixed(range.second, 1) + " ml");
    }
    if (made_.motion.heartbeat) {
      outcome.json["ejectionFraction"] = report.ejectionFraction;
      listing.add("ejection fraction", fixed(report.ejectionFraction, 3));
    }
    outcome.json["foldedMl"] = report.foldedMl;
    outcome.json["files"] = report.files;
    outcome.json["seconds"] = seconds;
    outcome.json["warnings"] = outcome.warnings;
    outcome.text = listing.add("files", std::to_string(report.files.size()) + ", described in phantom.json")
                       .add("time", fixed(seconds, 1) + " s")
                       .text();
    return outcome;
  }

  phantom::PhantomOptions made_;
  std::string modality_ = "ct";
  std::string spacing_;
  std::vector<std::string> slices_;
  std::string noise_;
  int phases_ = 0;
  std::string format_ = "nrrd";
  std::string folder_;
};

} // namespace

std::unique_ptr<Command> phantomCommand() {
  return std::make_unique<PhantomCommand>();
}

} // namespace viscera::app::cli
