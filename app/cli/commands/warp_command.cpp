#include "cli/commands/all_commands.h"

#include <chrono>

#include <CLI/CLI.hpp>

#include "cli/inputs.h"
#include "cli/listing.h"
#include "cli/scan_input.h"
#include "cli/system_options.h"
#include "viscera/deformation/inverse_map.h"
#include "viscera/medical_io/image_file.h"
#include "viscera/medical_io/warped_image.h"

namespace viscera::app::cli {
namespace {

/// The warped image, before it is reported.
struct Warped {
  std::string kind;
  std::array<int, 3> size = {};
  Vec3 spacing = Vec3::Ones();
  medical_io::WarpReport report;
};

/// `viscera warp`: warps a scan or a label map by a pose of the handles.
class WarpCommand final : public Command {
public:
  std::string name() const override { return "warp"; }
  std::string summary() const override { return "Warp a scan or label map along with the handles"; }
  std::vector<OutputOption> outputs() const override { return {{"--output"}}; }

  void addOptions(CLI::App& options) override {
    scan_.addTo(options);
    options.add_option("--handles", handles_, "The rest handles (.mrk.json)")->type_name("FILE")->required();
    options
        .add_option("--pose", pose_,
                    "Where the handles are (.mrk.json), by their labels; others stay at rest")
        ->type_name("FILE")
        ->required();
    system_.addTo(options);
    options.add_option("-o,--output", output_, "The warped image (.nii.gz, .nii, .nrrd)")
        ->type_name("FILE")
        ->required();
  }

  Outcome run(CommandContext& context) override {
    const auto begin = std::chrono::steady_clock::now();
    Outcome outcome;
    const auto system = system_.system(context);
    const coordinates::BindOptions options = system_.bindOptions(*system, context);
    const RigInput rig = rigInput(handles_, outcome.warnings, system_.cage());
    const Points pose = poseInput(pose_, rig, outcome.warnings);
    const auto mapFor = [&](const Vec3& spacing) {
      return deformation::InverseMap(*system, rig.handles, pose, options, medical_io::warpOptions(spacing),
                                     context.progress);
    };
    const medical_io::ScanOrLabels image =
        medical_io::readScanOrLabels(scan_.file(), scan_.chosen(), context.progress, scan_.chosenPhase());
    Warped warped;
    if (const auto* labels = std::get_if<medical_io::LabelMap>(&image))
      warpLabels(*labels, warped, mapFor, *system, outcome.warnings, context.progress);
    else
      warpScan(std::get<medical_io::Scan>(image), warped, mapFor, *system, outcome.warnings,
               context.progress);
    report(warped, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), outcome);
    return outcome;
  }

private:
  template <class MapFor>
  void warpScan(const medical_io::Scan& scan, Warped& warped, const MapFor& mapFor,
                const coordinates::CoordinateSystem& system, std::vector<Text>& warnings,
                Progress& progress) const {
    appendFindings(warnings, scan);
    warped = {"scan", scan.size, scan.spacing(), {}};
    const deformation::InverseMap map = mapFor(warped.spacing);
    medical_io::writeScan(output_, medical_io::warpedScan(scan, {map, system}, warped.report, progress));
  }

  template <class MapFor>
  void warpLabels(const medical_io::LabelMap& labels, Warped& warped, const MapFor& mapFor,
                  const coordinates::CoordinateSystem& system, std::vector<Text>& warnings,
                  Progress& progress) const {
    warped = {"label map", labels.size, labels.spacing(), {}};
    const deformation::InverseMap map = mapFor(warped.spacing);
    const medical_io::LabelMap moved =
        medical_io::warpedLabelMap(labels, {map, system}, warped.report, progress);
    warnings.insert(warnings.end(), moved.warnings.begin(), moved.warnings.end());
    medical_io::writeLabelMap(output_, moved);
  }

  void report(const Warped& warped, double seconds, Outcome& outcome) const {
    const double errorVoxel = warped.report.largestErrorMm / warped.spacing.minCoeff();
    const auto voxels = static_cast<std::size_t>(warped.size[0]) * static_cast<std::size_t>(warped.size[1]) *
                        static_cast<std::size_t>(warped.size[2]);
    if (warped.report.folded > 0)
      outcome.warnings.push_back("The pose folds the tissue at " + std::to_string(warped.report.folded) +
                                 " voxels: what they show is an estimate");
    outcome.json = {{"file", output_},
                    {"kind", warped.kind},
                    {"size", warped.size},
                    {"moved", warped.report.moved},
                    {"largestErrorVoxel", errorVoxel},
                    {"folded", warped.report.folded},
                    {"seconds", seconds},
                    {"warnings", outcome.warnings}};
    outcome.text =
        Listing()
            .add("file", output_)
            .add("kind", warped.kind)
            .add("moved", std::to_string(warped.report.moved) + " of " + std::to_string(voxels) + " voxels")
            .add("largest error", significant(errorVoxel, 2) + " voxels")
            .add("folded", std::to_string(warped.report.folded))
            .add("time", fixed(seconds, 1) + " s")
            .text();
  }

  ScanInputOptions scan_;
  std::string handles_;
  std::string pose_;
  SystemOptions system_;
  std::string output_;
};

} // namespace

std::unique_ptr<Command> warpCommand() {
  return std::make_unique<WarpCommand>();
}

} // namespace viscera::app::cli
