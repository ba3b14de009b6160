#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/inputs.h"
#include "cli/listing.h"
#include "cli/system_options.h"
#include "viscera/deformation/deformer.h"
#include "viscera/deformation/restoration_model.h"

namespace viscera::app::cli {

/// `viscera deform`: poses an organ and says what became of its volume.
class DeformCommand final : public Command {
public:
  std::string name() const override { return "deform"; }
  std::string summary() const override { return "Pose an organ by its handles"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  /// Moves compensating handles so that the volume is the one asked for. Nothing to do when none is.
  void keepVolume(deformation::Deformer& deformer, const RigInput& rig, const document::Organ& organ,
                  const deformation::RestorationModel& model) const;
  /// What a compensating motion costs, as `--restore` says. Fills the organ with witness points where that
  /// takes some.
  std::unique_ptr<deformation::RestorationModel> model(const document::Organ& organ, const RigInput& rig,
                                                       const coordinates::CoordinateSystem& system,
                                                       const coordinates::BindOptions& options,
                                                       std::vector<std::string>& warnings,
                                                       Progress& progress) const;
  double targetMl(const deformation::Deformer& deformer) const;
  /// Writes the posed surface, the displacements and the displacement field that are asked for, and says so.
  void writeOutputs(const document::Organ& organ, const deformation::Deformer& deformer, const RigInput& rig,
                    const coordinates::CoordinateSystem& system, const coordinates::BindOptions& options,
                    Progress& progress, Outcome& outcome, Listing& listing) const;

  std::string organ_;
  std::string handles_;
  std::string pose_;
  std::string output_;
  std::string displacement_;
  std::string transform_;
  double spacing_ = 5;
  bool lockVolume_ = false;
  std::optional<double> targetMl_;
  std::vector<std::string> compensate_;
  std::string restore_ = "least-displacement";
  int witnesses_ = 2000;
  SystemOptions system_;
};

} // namespace viscera::app::cli
