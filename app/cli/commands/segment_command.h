#pragma once

#include "cli/command.h"
#include "viscera/medical_io/label_surfaces.h"

namespace viscera::app::cli {

/// `viscera segment LABELMAP -o DIR`: a label map's organs as surfaces.
class SegmentCommand final : public Command {
public:
  std::string name() const override { return "segment"; }
  std::string summary() const override { return "Make organ surfaces of a label map"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  std::string file_;
  std::string folder_;
  std::vector<std::string> labels_;
  std::string format_ = "vtp";
  medical_io::LabelSurfaceOptions options_;
};

} // namespace viscera::app::cli
