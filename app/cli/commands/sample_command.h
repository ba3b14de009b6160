#pragma once

#include "cli/command.h"

namespace viscera::app::cli {

/// `viscera sample`: lists the sample organs, or makes one and writes its surfaces.
class SampleCommand final : public Command {
public:
  std::string name() const override { return "sample"; }
  std::string summary() const override { return "List the sample organs, or make one"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  Outcome list(const Surroundings& surroundings) const;
  Outcome make(Surroundings& surroundings) const;

  bool list_ = false;
  std::string organ_;
  std::string output_;
  std::string resolution_;
};

} // namespace viscera::app::cli
