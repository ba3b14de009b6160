#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "viscera/medical_io/space.h"

namespace viscera::app::cli {

/// `viscera convert`: surfaces and handle files into other formats, axes and units. Repairs only what it is
/// asked to.
class ConvertCommand final : public Command {
public:
  std::string name() const override { return "convert"; }
  std::string summary() const override { return "Convert a surface or a handle file"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  Outcome convertSurface(Surroundings& surroundings) const;
  Outcome convertHandles() const;
  /// The repairs asked for, in the order in which they are done.
  std::vector<std::string> repairs() const;
  void requireNoSurfaceOptions() const;
  medical_io::Space written() const;

  std::string in_;
  std::string out_;
  std::string space_ = "LPS";
  std::string fromSpace_;
  std::string unit_ = "mm";
  bool fillHoles_ = false;
  bool keepLargest_ = false;
  bool orient_ = false;
  bool mirror_ = false;
  std::optional<int> remesh_;
};

} // namespace viscera::app::cli
