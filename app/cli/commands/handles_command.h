#pragma once

#include "cli/command.h"

namespace viscera::app::cli {

/// `viscera handles`: places handles around an organ.
class HandlesCommand final : public Command {
public:
  std::string name() const override { return "handles"; }
  std::string summary() const override { return "Place handles around an organ"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  std::string organ_;
  std::string output_;
  int count_ = 30;
  bool enclosing_ = false;
};

} // namespace viscera::app::cli
