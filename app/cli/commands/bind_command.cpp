#include "cli/commands/bind_command.h"

#include <CLI/CLI.hpp>

#include "cli/inputs.h"
#include "cli/listing.h"
#include "cli/npy_file.h"
#include "viscera/deformation/bind_organ.h"

namespace viscera::app::cli {
namespace {

/// `points x handles`, row by row as NumPy likes it.
Weights weightsOf(const coordinates::Binding& binding) {
  Weights weights(binding.pointCount(), binding.handleCount());
  for (Eigen::Index handle = 0; handle < weights.cols(); ++handle)
    weights.col(handle) = binding.influence(static_cast<int>(handle));
  return weights;
}

} // namespace

void BindCommand::addOptions(CLI::App& options) {
  options.add_option("ORGAN", organ_, "A surface file, or sample:NAME[/SURFACE][@RESOLUTION]")->required();
  options.add_option("--handles", handles_, "The rest handles (.mrk.json)")->type_name("FILE")->required();
  system_.addTo(options);
  options
      .add_option("-o,--output", output_, "NumPy file for the coordinates: vertices x handles, 64 bit (.npy)")
      ->type_name("FILE");
}

Outcome BindCommand::run(Surroundings& surroundings) {
  const auto system = system_.system(surroundings);
  const coordinates::BindOptions options = system_.bindOptions(*system, surroundings);
  Outcome outcome;
  const RigInput rig = rigInput(handles_, outcome.warnings, system_.cage());
  const document::Organ organ = organInput(organ_, surroundings.samples, surroundings.progress);
  const auto binding =
      deformation::bindOrgan(*system, rig.handles, organ.mesh->points, options, surroundings.progress);
  const coordinates::BindingReport& report = binding->report();
  const double identity = report.identityError / boundsOf(organ.mesh->points).diagonal();
  if (!output_.empty()) {
    surroundings.progress.throwIfCancelled();
    writeNpy(output_, weightsOf(*binding));
  }

  outcome.json = {{"system", system->id()},
                  {"organ", organ.name},
                  {"vertices", binding->pointCount()},
                  {"handles", binding->handleCount()},
                  {"seconds", report.seconds},
                  {"threads", report.threads},
                  {"identityError", identity},
                  {"unityError", report.unityError},
                  {"minWeight", report.minWeight},
                  {"failures", report.failures.size()}};
  Listing listing;
  listing.add("system", system->name())
      .add("vertices", std::to_string(binding->pointCount()))
      .add("handles", std::to_string(binding->handleCount()))
      .add("time", fixed(report.seconds * 1e3, 1) + " ms, " + std::to_string(report.threads) + " threads")
      .add("identity error", significant(identity) + " of the organ's diagonal")
      .add("unity error", significant(report.unityError))
      .add("smallest weight", significant(report.minWeight))
      .add("failures", std::to_string(report.failures.size()));
  if (!output_.empty()) {
    outcome.json["file"] = output_;
    listing.add("file", output_);
  }
  outcome.text = listing.text();
  outcome.warnings.insert(outcome.warnings.end(), organ.warnings.begin(), organ.warnings.end());
  const auto& notes = report.notes;
  outcome.warnings.insert(outcome.warnings.end(), notes.begin(), notes.end());
  outcome.json["warnings"] = outcome.warnings;
  return outcome;
}

} // namespace viscera::app::cli
