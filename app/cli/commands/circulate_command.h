#pragma once

#include <string>
#include <vector>

#include "cli/command.h"

namespace viscera::app::cli {

/// `viscera circulate`: the circulation's periodic state in one scenario, with parameters of the user's.
class CirculateCommand final : public Command {
public:
  std::string name() const override { return "circulate"; }
  std::string summary() const override {
    return "Compute pressures, volumes and flows of heart and circulation";
  }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  Outcome list() const;
  Outcome published(Surroundings& surroundings) const;
  Outcome vary(Surroundings& surroundings) const;

  std::string scenario_ = "rest";
  std::vector<std::string> parameters_;
  std::string vary_;
  std::string csv_;
  std::string png_;
  std::string size_ = "1600x1000";
  bool list_ = false;
  bool published_ = false;
};

} // namespace viscera::app::cli
