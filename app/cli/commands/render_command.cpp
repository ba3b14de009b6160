#include "cli/commands/render_command.h"

#include <algorithm>
#include <memory>
#include <optional>

#include <vtkImageData.h>

#include <CLI/CLI.hpp>

#include "cli/inputs.h"
#include "cli/listing.h"
#include "cli/picture_size.h"
#include "viscera/core/error.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/scene/contact_sheet.h"
#include "viscera/scene/picture.h"
#include "viscera/session/open_files.h"

namespace viscera::app::cli {
namespace {

/// What the files named hold.
struct Contents {
  std::vector<session::Organ> organs;
  std::optional<RigInput> rig;
  std::vector<std::string> warnings;
};

Contents read(const std::vector<std::string>& files, const Surroundings& surroundings) {
  Contents contents;
  for (const std::string& file : files) {
    if (session::isHandleFile(file)) {
      if (contents.rig)
        throw UsageError("a second handle file", file, "name one handle file");
      contents.rig = rigInput(file, contents.warnings);
      continue;
    }
    for (session::Organ& organ : organInputs(file, surroundings.samples, surroundings.progress)) {
      contents.warnings.insert(contents.warnings.end(), organ.warnings.begin(), organ.warnings.end());
      contents.organs.push_back(std::move(organ));
    }
  }
  if (contents.organs.empty())
    throw UsageError("no organ is named", {}, "name a surface file or sample:NAME");
  return contents;
}

/// Colours every organ by the influence that a handle has on it.
void showInfluence(Stage& stage, const Contents& contents, const std::string& label,
                   const coordinates::CoordinateSystem& system, const coordinates::BindOptions& options,
                   Progress& progress) {
  if (!contents.rig)
    throw UsageError("needs a handle file among the files", "--influence " + label);
  const int handle = contents.rig->indexOf(label);
  std::vector<std::shared_ptr<Values>> influences;
  scene::ValueRange range{0, 0};
  for (const session::Organ& organ : contents.organs) {
    const auto binding =
        deformation::bindOrgan(system, contents.rig->handles, organ.mesh->points, options, progress);
    influences.push_back(std::make_shared<Values>(binding->influence(handle)));
    range.low = std::min(range.low, influences.back()->minCoeff());
    range.high = std::max(range.high, influences.back()->maxCoeff());
  }
  const scene::ColorMap map = scene::viridis();
  for (std::size_t i = 0; i < influences.size(); ++i)
    stage.view().organs()[i]->showScalars(influences[i], map, range);
  stage.view().legend().show("Influence of " + label, {}, map, range);
}

} // namespace

void RenderCommand::addOptions(CLI::App& options) {
  options.add_option("FILE", files_, "Organs (surface files, sample:NAME) and at most one handle file")
      ->required();
  options.add_option("-o,--output", output_, "Picture to write (.png)")->type_name("FILE")->required();
  addStageOptions(options, stage_, size_);
  options
      .add_option("--views", views_, "Several sides beside each other in one picture: anterior,left,superior")
      ->type_name("NAMES")
      ->delimiter(',')
      ->excludes("--view");
  options.add_option("--influence", influence_, "Colour the organs by the influence of this handle")
      ->type_name("LABEL");
  options.add_option("--opacity", opacity_, "Of the organs, 0 to 1")->check(CLI::Range(0.0, 1.0));
  system_.addTo(options);
}

Outcome RenderCommand::run(Surroundings& surroundings) {
  const auto system = system_.system(surroundings);
  const coordinates::BindOptions options = system_.bindOptions(*system, surroundings);
  stage_.size = pictureSize(size_);
  Contents contents = read(files_, surroundings);
  Stage stage(stage_, surroundings.threads);
  for (const session::Organ& organ : contents.organs)
    stage.add(organ, opacity_);
  if (contents.rig)
    stage.showHandles(*contents.rig);
  if (!influence_.empty())
    showInfluence(stage, contents, influence_, *system, options, surroundings.progress);
  if (views_.empty())
    views_.push_back(stage_.view);
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  for (const std::string& view : views_) {
    stage.compose(view);
    surroundings.progress.throwIfCancelled();
    pictures.push_back(stage.picture());
  }
  if (pictures.size() == 1)
    scene::writePng(output_, pictures.front());
  else
    scene::writeSmallPng(output_, scene::contactSheet(pictures, static_cast<int>(pictures.size())));

  Outcome outcome;
  outcome.json = {{"png", output_},
                  {"width", stage_.size.width * static_cast<int>(pictures.size())},
                  {"height", stage_.size.height},
                  {"view", views_.front()},
                  {"views", views_},
                  {"organs", contents.organs.size()},
                  {"handles", contents.rig ? contents.rig->labels.size() : 0}};
  outcome.text = Listing().add("picture", output_).text();
  outcome.warnings = std::move(contents.warnings);
  return outcome;
}

} // namespace viscera::app::cli
