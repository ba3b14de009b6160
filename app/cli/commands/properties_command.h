#pragma once

#include <string>
#include <vector>

#include "cli/command.h"

namespace viscera::app::cli {

/// `viscera properties`: every coordinate system measured side by side.
class PropertiesCommand final : public Command {
public:
  std::string name() const override { return "properties"; }
  std::string summary() const override { return "Measure what the coordinate systems keep and break"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  std::vector<std::string> systems_;
  std::vector<std::string> parameters_;
  std::string output_;
  int points_ = 400;
};

} // namespace viscera::app::cli
