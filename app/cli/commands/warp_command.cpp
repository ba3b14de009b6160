#include "cli/commands/all_commands.h"

#include <chrono>

#include <CLI/CLI.hpp>

#include "cli/inputs.h"
#include "cli/listing.h"
#include "cli/scan_input.h"
#include "cli/system_options.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/inverse_map.h"
#include "viscera/deformation/stiff_bodies.h"
#include "viscera/document/open_files.h"
#include "viscera/live/movable_binding.h"
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
  std::vector<std::string> rigid; ///< Names of the organs that did not bend.
};

using StiffOrgans = std::vector<std::shared_ptr<const document::Organ>>;

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
    options
        .add_option("--rigid", rigid_,
                    "Organs that do not bend in the scan, such as bones (surfaces, label maps, sample:NAME); "
                    "of several in one file the bones")
        ->type_name("ORGAN");
    options.add_flag("--bend-bones", bendBones_, "Let the bones of a label map bend, too");
  }

  Outcome run(CommandContext& context) override {
    const auto begin = std::chrono::steady_clock::now();
    Outcome outcome;
    const auto system = system_.system(context);
    const coordinates::BindOptions options = system_.bindOptions(*system, context);
    const document::Rig rig = rigInput(handles_, outcome.warnings, system_.cage());
    const coordinates::HandleSet handles = document::handleSet(rig);
    const Points pose = poseInput(pose_, rig, outcome.warnings);
    const medical_io::ScanOrLabels image =
        medical_io::readScanOrLabels(scan_.file(), scan_.chosen(), context.progress, scan_.chosenPhase());
    const auto* labels = std::get_if<medical_io::LabelMap>(&image);
    const Vec3 spacing = labels ? labels->spacing() : std::get<medical_io::Scan>(image).spacing();
    const deformation::InverseMap map(*system, handles, pose, options, medical_io::warpOptions(spacing),
                                      context.progress);
    const StiffOrgans stiff = stiffOrgans(labels, context);
    const auto bodies = live::stiffBodies(stiff, options.threads, context.progress);
    poseBodies(stiff, {*system, handles, options, pose}, map, *bodies, context.progress);
    const medical_io::Warp warp{map, *system, bodies->empty() ? nullptr : bodies.get()};
    Warped warped;
    if (labels)
      warpLabels(*labels, warped, warp, outcome.warnings, context.progress);
    else
      warpScan(std::get<medical_io::Scan>(image), warped, warp, outcome.warnings, context.progress);
    for (const auto& organ : stiff)
      warped.rigid.push_back(organ->name);
    report(warped, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), outcome);
    return outcome;
  }

private:
  /// The organs of `--rigid`, and the bones of a label map.
  StiffOrgans stiffOrgans(const medical_io::LabelMap* labels, CommandContext& context) const {
    StiffOrgans stiff;
    const auto add = [&](std::vector<document::Organ> organs, bool bonesOnly) {
      for (document::Organ& organ : organs)
        if (!bonesOnly || organ.mobility == document::Mobility::rigid) {
          organ.mobility = document::Mobility::rigid;
          stiff.push_back(std::make_shared<const document::Organ>(std::move(organ)));
        }
    };
    for (const std::string& file : rigid_) {
      std::vector<document::Organ> organs = organInputs(file, context.samples, context.progress);
      const bool several = organs.size() > 1;
      const std::size_t before = stiff.size();
      add(std::move(organs), several);
      if (stiff.size() == before)
        throw UsageError("None of its organs is a bone by its name", file,
                         "name one of them behind a slash, as in " + file + "/NAME");
    }
    std::vector<std::string> bones;
    for (const medical_io::Segment& segment : labels ? labels->segments : std::vector<medical_io::Segment>())
      if (!bendBones_ && document::usualMobility(segment.name) == document::Mobility::rigid)
        bones.push_back(segment.name);
    if (!bones.empty())
      add(document::readLabelOrgans(scan_.file(), bones, context.progress), true);
    return stiff;
  }

  /// The handles and their pose, as the coordinates take them.
  struct Posed {
    const coordinates::CoordinateSystem& system;
    const coordinates::HandleSet& handles;
    const coordinates::BindOptions& options;
    const Points& pose;
  };

  /// Moves bones as `viscera deform` moves them; those that are not wholly between the handles as the tissue
  /// around them.
  static void poseBodies(const StiffOrgans& stiff, const Posed& posed, const deformation::InverseMap& map,
                         deformation::StiffBodies& bodies, Progress& progress) {
    std::vector<Points> places(stiff.size());
    std::vector<const Points*> all;
    for (std::size_t i = 0; i < stiff.size(); ++i) {
      try {
        live::bindMovable(*stiff[i], posed.system, posed.handles, posed.options, progress)
            ->deform(posed.pose, places[i], posed.options.threads);
      } catch (const deformation::UnboundVertices&) {
        places[i] = map.posedPoints(stiff[i]->mesh->points);
      }
      all.push_back(&places[i]);
    }
    bodies.setPose(all, map);
  }

  void warpScan(const medical_io::Scan& scan, Warped& warped, const medical_io::Warp& warp,
                std::vector<Text>& warnings, Progress& progress) const {
    appendFindings(warnings, scan);
    warped = {"scan", scan.size, scan.spacing(), {}, {}};
    medical_io::writeScan(output_, medical_io::warpedScan(scan, warp, warped.report, progress));
  }

  void warpLabels(const medical_io::LabelMap& labels, Warped& warped, const medical_io::Warp& warp,
                  std::vector<Text>& warnings, Progress& progress) const {
    warped = {"label map", labels.size, labels.spacing(), {}, {}};
    const medical_io::LabelMap moved = medical_io::warpedLabelMap(labels, warp, warped.report, progress);
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
    std::string rigid;
    for (const std::string& name : warped.rigid)
      rigid += (rigid.empty() ? "" : ", ") + name;
    outcome.json = {{"file", output_},
                    {"kind", warped.kind},
                    {"size", warped.size},
                    {"moved", warped.report.moved},
                    {"largestErrorVoxel", errorVoxel},
                    {"folded", warped.report.folded},
                    {"rigid", warped.rigid},
                    {"seconds", seconds},
                    {"warnings", outcome.warnings}};
    outcome.text =
        Listing()
            .add("file", output_)
            .add("kind", warped.kind)
            .add("moved", std::to_string(warped.report.moved) + " of " + std::to_string(voxels) + " voxels")
            .add("largest error", significant(errorVoxel, 2) + " voxels")
            .add("folded", std::to_string(warped.report.folded))
            .add("rigid", rigid.empty() ? "nothing" : rigid)
            .add("time", fixed(seconds, 1) + " s")
            .text();
  }

  ScanInputOptions scan_;
  std::string handles_;
  std::string pose_;
  SystemOptions system_;
  std::string output_;
  std::vector<std::string> rigid_;
  bool bendBones_ = false;
};

} // namespace

std::unique_ptr<Command> warpCommand() {
  return std::make_unique<WarpCommand>();
}

} // namespace viscera::app::cli
