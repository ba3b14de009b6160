#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/stage.h"
#include "cli/system_options.h"

namespace viscera::app::cli {

/// `viscera render`: one picture of organs and handles.
class RenderCommand final : public Command {
public:
  std::string name() const override { return "render"; }
  std::string summary() const override { return "Draw organs and handles as a PNG"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  std::vector<std::string> files_;
  std::string output_;
  std::string size_ = "1600x1000";
  std::string influence_;
  std::vector<std::string> views_;
  StageOptions stage_;
  double opacity_ = 1;
  SystemOptions system_;
};

} // namespace viscera::app::cli
