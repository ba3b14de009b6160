#pragma once

#include "cli/command.h"
#include "cli/system_options.h"

namespace viscera::app::cli {

/// `viscera bind`: computes coordinates and says how good they are.
class BindCommand final : public Command {
public:
  std::string name() const override { return "bind"; }
  std::string summary() const override { return "Compute an organ's coordinates"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  std::string organ_;
  std::string handles_;
  std::string output_;
  SystemOptions system_;
};

} // namespace viscera::app::cli
