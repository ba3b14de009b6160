#pragma once

#include <string>
#include <vector>

#include "cli/command.h"

namespace viscera::app::cli {

/// `viscera reproduce`: the thesis's figures and tables, done again.
class ReproduceCommand final : public Command {
public:
  std::string name() const override { return "reproduce"; }
  std::string summary() const override { return "Do the thesis's figures and tables again, as one page"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  std::string output_;
  std::vector<std::string> only_;
};

} // namespace viscera::app::cli
