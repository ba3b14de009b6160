#include "cli/commands/all_commands.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/bound_input.h"
#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "viscera/core/error.h"
#include "viscera/deformation/deformer.h"
#include "viscera/deformation/inverse_displacements.h"
#include "viscera/deformation/least_stress.h"
#include "viscera/deformation/restoration_model.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/deformation/volume_lock.h"
#include "viscera/document/organ.h"
#include "viscera/live/movable_binding.h"
#include "viscera/live/tissue_energy.h"
#include "viscera/medical_io/displacement_file.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::app::cli {
namespace {

constexpr const char* kLeastDisplacement = "least-displacement";
constexpr const char* kLeastStress = "least-stress";
constexpr std::size_t kMovesListed = 8;
constexpr double kAsAskedMm = 0.005; ///< What two digits do not show.

int movedHandles(const Points& rest, const Points& pose) {
  return static_cast<int>(((pose - rest).rowwise().squaredNorm().array() > 0).count());
}

/// How far a handle is from rest: as the pose asks, and as it is with a kept volume.
struct HandleMove {
  std::string label;
  double askedMm = 0;
  double givenMm = 0;
  double offMm = 0; ///< From the place that the pose asks for.
};

/// The handles that the pose moves, and those that compensate.
std::vector<HandleMove> movesOf(const document::Rig& rig, const Points& asked, const Points& given) {
  const Points rest = rig.restPositions();
  std::vector<HandleMove> moves;
  for (Eigen::Index row = 0; row < rest.rows(); ++row) {
    const HandleMove move{rig.handles[static_cast<std::size_t>(row)].label,
                          (asked.row(row) - rest.row(row)).norm(), (given.row(row) - rest.row(row)).norm(),
                          (given.row(row) - asked.row(row)).norm()};
    if (move.askedMm > 0 || move.givenMm > 0)
      moves.push_back(move);
  }
  return moves;
}

nlohmann::ordered_json movesJson(const std::vector<HandleMove>& moves) {
  auto list = nlohmann::ordered_json::array();
  for (const HandleMove& move : moves)
    list.push_back(
        {{"label", move.label}, {"askedMm", move.askedMm}, {"givenMm", move.givenMm}, {"offMm", move.offMm}});
  return list;
}

std::string moveText(const HandleMove& move) {
  return fixed(move.askedMm, 2) + " mm asked, " + fixed(move.givenMm, 2) + " mm given";
}

/// Lists what was asked and given, and warns of handles that are not where the pose asks for them.
void tellMoves(const std::vector<HandleMove>& moves, Listing& listing, std::vector<Text>& warnings) {
  std::size_t asked = 0, compensating = 0;
  double farthest = 0;
  std::string changed;
  for (const HandleMove& move : moves) {
    if (move.askedMm > 0 && asked++ < kMovesListed)
      listing.add("handle " + move.label, moveText(move));
    if (move.askedMm > 0 && move.offMm > kAsAskedMm)
      changed += (changed.empty() ? "" : "; ") + move.label + " " + moveText(move);
    if (move.askedMm == 0) {
      ++compensating;
      farthest = std::max(farthest, move.givenMm);
    }
  }
  if (asked > kMovesListed)
    listing.add("", std::to_string(asked - kMovesListed) + " more, which --json lists");
  listing.add("compensating",
              std::to_string(compensating) + " handles, by " + fixed(farthest, 2) + " mm at most");
  if (!changed.empty())
    warnings.push_back("to keep the volume, handles that the pose moves are elsewhere than it asks: " +
                       changed + "; --compensate with other handles leaves them there");
}

/// `viscera deform`: poses an organ and reports the change of its volume.
class DeformCommand final : public Command {
public:
  std::string name() const override { return "deform"; }
  std::string summary() const override { return "Pose an organ by its handles"; }
  std::vector<OutputOption> outputs() const override {
    return {{"--output"}, {"--displacement"}, {"--transform"}};
  }

  void addOptions(CLI::App& options) override {
    input_.addTo(options, true);
    CLI::Option* lock =
        options.add_flag("--lock-volume", lockVolume_,
                         "Move the handles that the pose leaves at rest so that the volume is kept");
    options.add_option("--target-ml", targetMl_, "As --lock-volume, but for this volume")
        ->type_name("ML")
        ->check(above(0))
        ->excludes(lock);
    options.add_option("--compensate", compensate_, "Move only these handles to reach the volume")
        ->type_name("LABEL");
    options.add_flag(
        "--exact", exact_,
        "Refuse when a handle that the pose moves would have to be elsewhere to keep the volume");
    options
        .add_option("--restore", restore_,
                    "How the compensating handles share the motion: least-displacement, or least-stress of "
                    "the tissue inside")
        ->check(CLI::IsMember({kLeastDisplacement, kLeastStress}))
        ->type_name("HOW")
        ->capture_default_str();
    CLI::Option* follow = options.add_flag(
        "--free-handles-follow", follow_,
        "Move the handles that the pose leaves at rest to where the elastic energy of the tissue is least");
    options.add_option("--hold", hold_, "Leave these handles at rest while the others follow")
        ->type_name("LABEL")
        ->needs(follow);
    options.add_option("--witnesses", witnesses_, "Witness points for least-stress, 200 to 200000")
        ->type_name("N")
        ->capture_default_str();
    options
        .add_option(
            "--mobility", mobility_,
            "How the organ follows the handles: bends, rigid (as a whole) or fixed; without it a bone is "
            "rigid and all else bends")
        ->check(CLI::IsMember({"bends", "rigid", "fixed"}))
        ->type_name("HOW");
    options.add_option("-o,--output", output_, "Surface file for the posed organ")->type_name("FILE");
    options
        .add_option("--displacement", displacement_,
                    "Write the organ at rest with the vector of every vertex's motion (.vtp)")
        ->type_name("FILE");
    CLI::Option* transform =
        options
            .add_option(
                "--transform", transform_,
                "Write the motion of the space around the organ as a displacement field for 3D Slicer "
                "and ITK (.nrrd, .mha)")
            ->type_name("FILE");
    options.add_option("--spacing", spacing_, "Spacing of the displacement field's grid")
        ->type_name("MM")
        ->check(above(0))
        ->needs(transform)
        ->capture_default_str();
  }

  Outcome run(CommandContext& context) override {
    const auto begin = std::chrono::steady_clock::now();
    Outcome outcome;
    BoundInput input = input_.read(context, outcome.warnings);
    takeMobility(input.organ, outcome.warnings);
    const auto& [system, options, rig, handles, pose, organ] = input;
    deformation::Deformer deformer(organ.mesh,
                                   live::bindMovable(organ, *system, handles, options, context.progress),
                                   handles.positions, context.threads);
    deformer.setPose(pose);
    const std::vector<int> following = follow(deformer, input, context.progress);
    keepVolume(deformer, input, following, outcome.warnings, context.progress);

    const double restMl = deformer.restVolumeMm3() / kMm3PerMl;
    const double nowMl = deformer.volumeMm3() / kMm3PerMl;
    const double error = (nowMl - targetMl(deformer)) / std::abs(targetMl(deformer));
    const double change = (nowMl - restMl) / std::abs(restMl);
    const int moved = movedHandles(handles.positions, deformer.pose());
    const std::vector<HandleMove> moves = movesOf(rig, pose, deformer.pose());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    outcome.json = {{"organ", organ.name},
                    {"system", system->id()},
                    {"mobility", document::nameOf(organ.mobility)},
                    {"closed", organ.closed()},
                    {"volumeRestMl", restMl},
                    {"volumeMl", nowMl},
                    {"relativeVolumeError", error},
                    {"movedHandles", moved},
                    {"maxDisplacementMm", deformer.maxDisplacementMm()},
                    {"seconds", seconds},
                    {"handles", movesJson(moves)}};
    Listing listing;
    if (organ.closed())
      listing.add("volume at rest", fixed(restMl, 3) + " ml")
          .add("volume",
               fixed(nowMl, 3) + " ml (" + (change < 0 ? "" : "+") + fixed(100 * change, 3) + " %)");
    else
      listing.add("volume", "none: the surface is open");
    listing.add("moved handles", std::to_string(moved))
        .add("largest displacement", fixed(deformer.maxDisplacementMm(), 2) + " mm of the surface");
    if (follow_) {
      outcome.json["followingHandles"] = following.size();
      listing.add("following handles", std::to_string(following.size()));
    }
    if (lockVolume_ || targetMl_)
      tellMoves(moves, listing, outcome.warnings);
    writeOutputs(input, deformer, context.progress, outcome, listing);
    outcome.text = listing.text();
    outcome.warnings.insert(outcome.warnings.end(), organ.warnings.begin(), organ.warnings.end());
    const auto& notes = deformer.binding().report().notes;
    outcome.warnings.insert(outcome.warnings.end(), notes.begin(), notes.end());
    outcome.json["warnings"] = outcome.warnings;
    return outcome;
  }

private:
  /// Takes the mobility that is asked for; says so when a bone is rigid by its name.
  void takeMobility(document::Organ& organ, std::vector<Text>& warnings) const {
    if (const auto asked = document::mobilityFromName(mobility_))
      organ.mobility = *asked;
    else if (organ.mobility == document::Mobility::rigid)
      warnings.push_back(organ.name +
                         " is a bone, which moves as a rigid body; --mobility bends lets it bend");
  }

  /// Lets the handles follow that the pose leaves at rest and that are not held; returns which.
  std::vector<int> follow(deformation::Deformer& deformer, const BoundInput& input,
                          Progress& progress) const {
    if (!follow_)
      return {};
    if (input.organ.mobility != document::Mobility::bends)
      throw UsageError("The organ does not bend, so that its handles have nothing to follow",
                       "--free-handles-follow");
    std::vector<int> following = deformation::restingHandles(input.handles.positions, deformer.pose());
    for (const std::string& label : hold_)
      std::erase(following, rowOfHandle(input.rig, label));
    const auto tissue = live::tissueEnergy({input.organ.mesh}, *input.system, input.handles,
                                           deformation::withTetgen(input.options), progress);
    std::optional<deformation::VolumeLock> lock;
    if (lockVolume_ || targetMl_)
      if (input.organ.closed())
        lock.emplace(std::vector<deformation::LockedSurface>{{input.organ.name, deformer.sharedRest(),
                                                              deformer.sharedBinding(),
                                                              targetMl(deformer) * kMm3PerMl}});
    deformer.setPose(tissue->relax(deformer.pose(), following, lock ? &*lock : nullptr).pose);
    return following;
  }

  /// Moves compensating handles so that the organ has the volume given by an option, if any.
  void keepVolume(deformation::Deformer& deformer, const BoundInput& input, const std::vector<int>& following,
                  std::vector<Text>& warnings, Progress& progress) const {
    if (!lockVolume_ && !targetMl_) {
      if (!compensate_.empty())
        throw UsageError("It goes with --lock-volume or --target-ml", "--compensate");
      if (restore_ != kLeastDisplacement)
        throw UsageError("It goes with --lock-volume or --target-ml", "--restore");
      if (exact_)
        throw UsageError("It goes with --lock-volume or --target-ml", "--exact");
      return;
    }
    const auto restoration = model(input, warnings, progress);
    if (!input.organ.closed())
      throw DataError("the surface is open, so it has no volume to keep", input_.organ(),
                      "close its holes first");
    std::vector<int> compensating;
    for (const std::string& label : compensate_)
      compensating.push_back(rowOfHandle(input.rig, label));
    const std::vector<int> resting =
        follow_ ? following : deformation::restingHandles(input.handles.positions, deformer.pose());
    for (const int handle : compensating)
      if (exact_ && std::find(resting.begin(), resting.end(), handle) == resting.end())
        throw UsageError("The pose moves this handle, so that it cannot compensate exactly",
                         "--compensate " + input.rig.handles[static_cast<std::size_t>(handle)].label,
                         "name handles that the pose leaves at rest");
    if (compensating.empty())
      compensating = resting;
    deformation::restoreVolume(deformer, targetMl(deformer) * kMm3PerMl, compensating, *restoration);
  }

  /// The restoration model chosen by `--restore`. Fills the organ with witness points if the model needs
  /// them.
  std::unique_ptr<deformation::RestorationModel> model(const BoundInput& input, std::vector<Text>& warnings,
                                                       Progress& progress) const {
    if (restore_ == kLeastDisplacement)
      return std::make_unique<deformation::LeastDisplacement>();
    live::WitnessOptions witnesses;
    witnesses.wanted = witnesses_;
    witnesses.threads = input.options.threads;
    const WitnessedOrgan interior = interiorOf(input, witnesses, warnings, progress);
    return std::make_unique<deformation::LeastStress>(interior.gradients, interior.mesh().witnesses,
                                                      input.options.threads);
  }

  double targetMl(const deformation::Deformer& deformer) const {
    return targetMl_.value_or(deformer.restVolumeMm3() / kMm3PerMl);
  }

  /// Writes the requested files (posed surface, displacements, displacement field) and lists them.
  void writeOutputs(const BoundInput& input, const deformation::Deformer& deformer, Progress& progress,
                    Outcome& outcome, Listing& listing) const {
    const document::Organ& organ = input.organ;
    progress.throwIfCancelled();
    if (!output_.empty()) {
      medical_io::writeSurface(output_, {deformer.points(), organ.mesh->triangles, organ.mesh->colors},
                               {.name = organ.name});
      outcome.json["file"] = output_;
      listing.add("file", output_);
    }
    if (!displacement_.empty()) {
      medical_io::writeDisplacements(displacement_, *organ.mesh, deformer.points(), organ.name);
      outcome.json["displacement"] = displacement_;
      listing.add("displacements", displacement_);
    }
    if (transform_.empty())
      return;
    const deformation::DisplacementGrid grid = deformation::inverseDisplacements(
        *input.system, input.handles, deformer.pose(), input.options,
        deformation::gridAround(organ.mesh->points, deformer.points(), spacing_), progress);
    medical_io::writeTransform(transform_, grid);
    outcome.json["transform"] = {{"file", transform_},
                                 {"size", {grid.size[0], grid.size[1], grid.size[2]}},
                                 {"spacingMm", grid.spacing},
                                 {"largestErrorMm", grid.largestErrorMm},
                                 {"unreached", grid.unreached}};
    listing.add("displacement field", transform_ + " (" + std::to_string(grid.size[0]) + " x " +
                                          std::to_string(grid.size[1]) + " x " +
                                          std::to_string(grid.size[2]) + ")");
    if (grid.unreached > 0)
      outcome.warnings.push_back(std::to_string(grid.unreached) + " of " +
                                 std::to_string(grid.vectors.rows()) +
                                 " points of the displacement field have no certain place at rest: the pose "
                                 "folds the tissue there, or it has no coordinates");
  }

  BoundInputOptions input_;
  std::string output_;
  std::string displacement_;
  std::string transform_;
  double spacing_ = 5;
  bool lockVolume_ = false;
  std::optional<double> targetMl_;
  std::vector<std::string> compensate_;
  std::string restore_ = "least-displacement";
  std::string mobility_;
  bool exact_ = false;
  bool follow_ = false;
  std::vector<std::string> hold_;
  int witnesses_ = 2000;
};

} // namespace

std::unique_ptr<Command> deformCommand() {
  return std::make_unique<DeformCommand>();
}

} // namespace viscera::app::cli
