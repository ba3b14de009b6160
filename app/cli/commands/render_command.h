#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>

#include "cli/command.h"
#include "cli/inputs.h"
#include "cli/stage_options.h"
#include "cli/system_options.h"
#include "viscera/scene/region_hulls.h"

namespace CLI {
class Option;
}

namespace viscera::app::cli {

class StillOrgans;

/// What the files named hold.
struct Contents {
  std::vector<document::Organ> organs;
  std::optional<RigInput> rig;
  std::optional<Points> pose; ///< Of the rig; none: at rest.
  std::vector<std::string> warnings;
};

/// `viscera render`: organs and handles as one picture, of several sides or coordinates beside each other.
class RenderCommand final : public Command {
public:
  std::string name() const override { return "render"; }
  std::string summary() const override { return "Draw organs and handles as a PNG"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  struct Shown;
  std::vector<Shown> shown(const Surroundings& surroundings) const;
  using Pictures = std::vector<vtkSmartPointer<vtkImageData>>;
  /// One picture a side that is asked for.
  Pictures draw(const Shown& shown, const Contents& contents, int width, Surroundings& surroundings) const;
  presentation::SurfaceMap influenceOf(const Shown& shown, const StillOrgans& organs) const;
  /// A session as the window showed it.
  Outcome drawSession(Surroundings& surroundings);

  std::vector<std::string> files_;
  std::string output_;
  std::string size_ = "1600x1000";
  std::string influence_;
  std::vector<std::string> views_;
  std::string beside_;
  scene::LayoutParts parts_{.regions = false};
  std::string pose_;
  bool stress_ = false;
  StageOptions stage_;
  CLI::Option* viewGiven_ = nullptr;
  double opacity_ = 1;
  SystemOptions system_;
};

} // namespace viscera::app::cli
