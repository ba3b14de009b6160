#include "cli/bound_input.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "viscera/core/error.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/deformation/witness_mesh.h"

namespace viscera::app::cli {

void BoundInputOptions::addTo(CLI::App& options, bool posed) {
  options.add_option("ORGAN", organ_, "A surface file, or sample:NAME[/SURFACE][@RESOLUTION]")->required();
  options.add_option("--handles", handles_, "The rest handles (.mrk.json)")->type_name("FILE")->required();
  if (posed)
    options
        .add_option("--pose", pose_,
                    "Where the handles are (.mrk.json), by their labels; others stay at rest")
        ->type_name("FILE")
        ->required();
  system_.addTo(options);
}

BoundInput BoundInputOptions::read(const CommandContext& context, std::vector<Text>& warnings) const {
  BoundInput input;
  input.system = system_.system(context);
  input.options = system_.bindOptions(*input.system, context);
  input.rig = rigInput(handles_, warnings, system_.cage());
  input.handles = document::handleSet(input.rig);
  input.pose = pose_.empty() ? input.handles.positions : poseInput(pose_, input.rig, warnings);
  input.organ = organInput(organ_, context.samples, context.progress);
  return input;
}

WitnessedOrgan interiorOf(const BoundInput& input, const live::WitnessOptions& witnesses,
                          std::vector<Text>& warnings, Progress& progress,
                          const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& cavities,
                          std::shared_ptr<const deformation::WitnessMesh> cells) {
  WitnessedOrgan interior;
  interior.ownCells = cells != nullptr;
  if (cells) {
    deformation::requireUsable(*cells, input.organ.file.string());
    interior.sample.mesh = std::move(cells);
    if (!cavities.empty())
      interior.sample.mesh = std::make_shared<const deformation::WitnessMesh>(
          deformation::withoutCavities(*interior.sample.mesh, cavities, witnesses.threads));
  } else {
    interior.sample = live::withoutCavities(live::sampleWitnesses(*input.organ.mesh, witnesses, progress),
                                            cavities, witnesses);
  }
  interior.gradients = deformation::bindWitnesses(*input.system, input.handles, interior.mesh().points,
                                                  input.options, progress);
  warnings.insert(warnings.end(), interior.sample.remarks.begin(), interior.sample.remarks.end());
  const auto& failures = interior.gradients->failures();
  const auto within = std::lower_bound(failures.begin(), failures.end(), interior.mesh().witnesses);
  if (within != failures.begin())
    throw DataError(std::to_string(within - failures.begin()) +
                        " witness points have no coordinates (the first is number " +
                        std::to_string(failures.front()) + ")",
                    "handles", "enclose the organ: viscera handles ORGAN does so");
  if (!failures.empty())
    warnings.push_back(std::to_string(failures.size()) +
                       " points of the surface have no coordinates; they are shown at rest.");
  return interior;
}

} // namespace viscera::app::cli
