#pragma once

#include <string>

#include "cli/command.h"
#include "cli/inputs.h"
#include "cli/system_options.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/live/witness_sampling.h"

namespace viscera::app::cli {

/// `viscera stress`: the distortion that a pose means for the tissue, at witness points inside the organ.
class StressCommand final : public Command {
public:
  std::string name() const override { return "stress"; }
  std::string summary() const override { return "Measure how a pose distorts the tissue inside an organ"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  std::string organ_;
  std::string handles_;
  std::string pose_;
  std::string output_;
  std::string csv_;
  double memoryMb_ = 2048;
  live::WitnessOptions witnesses_;
  SystemOptions system_;
};

} // namespace viscera::app::cli
