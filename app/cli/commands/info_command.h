#pragma once

#include "cli/command.h"

namespace viscera::app::cli {

/// `viscera info FILE`: what is in an organ, label map or handle file.
class InfoCommand final : public Command {
public:
  std::string name() const override { return "info"; }
  std::string summary() const override {
    return "Say what is in an organ, label map, handle or session file";
  }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  std::string file_;
};

} // namespace viscera::app::cli
