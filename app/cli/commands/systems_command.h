#pragma once

#include "cli/command.h"

namespace viscera::app::cli {

/// `viscera systems`: the coordinate systems there are.
class SystemsCommand final : public Command {
public:
  std::string name() const override { return "systems"; }
  std::string summary() const override { return "List the coordinate systems and their parameters"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;
};

} // namespace viscera::app::cli
