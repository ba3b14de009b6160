#include "cli/commands/all_commands.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include "cli/heart_signs.h"
#include "cli/inputs.h"
#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "cli/pose_strain.h"
#include "cli/session_input.h"
#include "cli/slice_picture.h"
#include "cli/stage_options.h"
#include "cli/still_organs.h"
#include "cli/system_options.h"
#include "viscera/core/error.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/document/open_files.h"
#include "viscera/document/session_file.h"
#include "viscera/live/movable_binding.h"
#include "viscera/scene/picture.h"

namespace viscera::app::cli {
namespace {

/// The contents of the given files.
struct Contents {
  std::vector<document::Organ> organs;
  std::optional<document::Rig> rig;
  std::optional<Points> pose;                     ///< Of the rig; none: at rest.
  std::shared_ptr<const document::ScanItem> scan; ///< Null: none was asked for, or there is none.
  std::vector<Text> warnings;
};

/// The coordinates of one picture, with the values to show.
struct Shown {
  std::shared_ptr<const coordinates::CoordinateSystem> system;
  coordinates::BindOptions options;
  std::vector<std::shared_ptr<Values>> influences; ///< One an organ; empty when none is asked for.
  scene::ValueRange range{0, 0};                   ///< Of the influences of all pictures.
};

/// Degrees; less is rounding.
constexpr double kNoStress = 1e-6;

void add(Contents& contents, std::vector<document::Organ> organs) {
  for (document::Organ& organ : organs) {
    contents.warnings.insert(contents.warnings.end(), organ.warnings.begin(), organ.warnings.end());
    contents.organs.push_back(std::move(organ));
  }
}

/// Reads a file that may be the scan, as that or as a label map; false for any other.
bool addImage(Contents& contents, const std::string& file, Progress& progress) {
  auto image = file.starts_with("sample:") ? std::nullopt : document::openImage(file, progress);
  if (!image)
    return false;
  if (auto* scan = std::get_if<document::ScanItem>(&*image))
    contents.scan = std::make_shared<const document::ScanItem>(std::move(*scan));
  else
    add(contents, organInputs(std::get<medical_io::LabelMap>(std::move(*image)), file, progress));
  return true;
}

/// Handles that no organ is bound to are only drawn: they may be landmarks.
Contents read(const std::vector<std::string>& files, const std::string& cage, const CommandContext& context,
              bool withScan, bool bound) {
  Contents contents;
  for (const std::string& file : files) {
    if (withScan && !contents.scan && addImage(contents, file, context.progress))
      continue;
    if (document::isHandleFile(file)) {
      if (contents.rig)
        throw UsageError("a second handle file", file, "name one handle file");
      contents.rig = bound ? rigInput(file, contents.warnings, cage) : drawnHandles(file, contents.warnings);
      continue;
    }
    add(contents, organInputs(file, context.samples, context.progress));
  }
  if (contents.organs.empty() && !contents.scan)
    throw UsageError("no organ is named", {}, "name a surface file or sample:NAME");
  return contents;
}

std::vector<std::string> colorMapNames() {
  std::vector<std::string> names;
  for (const scene::ColorMap& map : scene::colorMaps())
    names.push_back(map.name);
  return names;
}

/// The influence of a handle on every organ.
std::vector<std::shared_ptr<Values>> influencesOf(const Contents& contents, int handle,
                                                  const coordinates::CoordinateSystem& system,
                                                  const coordinates::BindOptions& options,
                                                  Progress& progress) {
  const coordinates::HandleSet handles = document::handleSet(*contents.rig);
  std::vector<std::shared_ptr<Values>> influences;
  for (const document::Organ& organ : contents.organs) {
    const auto binding = deformation::bindOrgan(system, handles, organ.mesh->points, options, progress);
    influences.push_back(std::make_shared<Values>(binding->influence(handle)));
  }
  return influences;
}

/// The organs and the handles in a pose.
void showPose(StillOrgans& organs, const Contents& contents, const coordinates::CoordinateSystem& system,
              const coordinates::BindOptions& options, Progress& progress) {
  const coordinates::HandleSet handles = document::handleSet(*contents.rig);
  for (std::size_t i = 0; i < contents.organs.size(); ++i) {
    auto points = std::make_shared<Points>();
    live::bindMovable(contents.organs[i], system, handles, options, progress)
        ->deform(*contents.pose, *points, options.threads);
    organs.setPoints(i, std::move(points));
  }
  organs.showPose(*contents.pose);
}

/// The rotational stress of every organ's tissue at the surface, in degrees; folded tissue has a colour of
/// its own.
presentation::SurfaceMap stressOf(const StillOrgans& organs, const Contents& contents,
                                  const coordinates::CoordinateSystem& system,
                                  const coordinates::BindOptions& options, const std::string& colors,
                                  Progress& progress) {
  const coordinates::HandleSet handles = document::handleSet(*contents.rig);
  presentation::SurfaceMap shown;
  shown.range = {0, 0};
  for (std::size_t i = 0; i < contents.organs.size(); ++i) {
    deformation::StressMap map;
    deformation::bindWitnesses(system, handles, contents.organs[i].mesh->points, options, progress)
        ->evaluate(*contents.pose, map, options.threads);
    auto degrees = std::make_shared<Values>(180 / std::numbers::pi * map.rotationalStress);
    shown.range.high = std::max(shown.range.high, degrees->maxCoeff());
    for (Eigen::Index row = 0; row < degrees->size(); ++row)
      if (map.volumeRatio[row] <= 0)
        (*degrees)[row] = std::nan("");
    if (map.folded > 0)
      shown.mark = "folded";
    shown.values[organs.idOf(i)] = std::move(degrees);
  }
  if (!(shown.range.high > kNoStress))
    shown.range.high = 1; // Nothing is distorted: one colour, and a legend from 0 to 1.
  shown.colors = presentation::stressColors(colors);
  shown.title = "Rotational stress";
  shown.unit = "deg";
  return shown;
}

/// `viscera render`: organs and handles as one picture, of several sides or coordinates beside each other.
class RenderCommand final : public Command {
public:
  std::string name() const override { return "render"; }
  std::string summary() const override { return "Draw organs and handles as a PNG"; }
  std::vector<OutputOption> outputs() const override { return {pictureOutput("--output")}; }

  void addOptions(CLI::App& options) override {
    options
        .add_option("FILE", files_,
                    "Organs (surface files, sample:NAME) and at most one handle file; or one session")
        ->required();
    options.add_option("-o,--output", output_, "Picture to write (.png)")->type_name("FILE")->required();
    addStageOptions(options, stage_, size_);
    options
        .add_option(
            "--views", views_,
            "Several sides beside each other in one picture: anterior,left,superior; --size is the size of "
            "each")
        ->type_name("NAMES")
        ->delimiter(',')
        ->excludes("--view");
    viewGiven_ = options.get_option("--view");
    CLI::Option* influence =
        options.add_option("--influence", influence_, "Colour the organs by the influence of this handle")
            ->type_name("LABEL");
    CLI::Option* pose = options
                            .add_option("--pose", pose_,
                                        "Pose the organs by the handle positions in this file; handles that "
                                        "it leaves out stay at rest")
                            ->type_name("FILE");
    options.add_flag("--stress", stress_, "Colour the organs by the rotational stress of the pose")
        ->needs(pose)
        ->excludes(influence);
    options
        .add_option("--strain", strain_,
                    "Colour the left ventricle's wall by the strain of its 17 segments in the pose, against "
                    "rest")
        ->type_name("DIRECTION")
        ->check(CLI::IsMember(strainDirectionNames()))
        ->needs(pose)
        ->excludes(influence)
        ->excludes("--stress");
    options.add_option("--color-map", colors_, "Colours of the influence or of the stress")
        ->check(CLI::IsMember(colorMapNames()));
    options
        .add_option(
            "--beside", beside_,
            "A second picture on the right, with these coordinates; --param goes to whichever takes it")
        ->type_name("ID");
    options.add_flag("--regions", parts_.regions, "Draw the regions of the handles' groups");
    options.add_flag("--zones", parts_.zones, "Draw the zones in which regions meet");
    options.add_flag("--super-regions", parts_.superRegions, "Draw the super-regions of the zones");
    options.add_option("--opacity", opacity_, "Of the organs, 0 to 1")->check(between(0.0, 1.0));
    CLI::Option* slice =
        options
            .add_option("--slice", slice_,
                        "Draw one slice of the scan among the files, with the organs' contours: axial:MM, "
                        "coronal:MM or sagittal:MM, in mm LPS")
            ->type_name("DIRECTION:MM");
    CLI::Option* width = options.add_option("--window", width_, "Width of the values from black to white")
                             ->check(above(0))
                             ->needs(slice);
    CLI::Option* level = options.add_option("--level", level_, "The value that is middle grey")->needs(slice);
    width->needs(level);
    level->needs(width);
    signs_.addTo(options);
    options.get_option("--signs")->excludes(slice);
    system_.addTo(options);
  }

  Outcome run(CommandContext& context) override {
    if (std::any_of(files_.begin(), files_.end(),
                    [](const auto& file) { return document::isSessionFile(file); }))
      return drawSession(context);
    if (signs_.given())
      throw UsageError("Only a session has the instant of a beat", signs_.text(),
                       "draw a session that shows a beating heart, or a movie with 'viscera play'");
    std::vector<Shown> all = shown(context);
    stage_.size = pictureSize(size_);
    if (views_.empty())
      views_.push_back(stage_.view);
    const bool bound = !influence_.empty() || !pose_.empty() || parts_.any() || !system_.cage().empty();
    Contents contents = read(files_, system_.cage(), context, !slice_.empty(), bound);
    if (!contents.rig && (!influence_.empty() || parts_.any()))
      throw UsageError("It needs a handle file among the files", influence_.empty()
                                                                     ? "--regions, --zones or --super-regions"
                                                                     : "--influence " + influence_);
    if (!pose_.empty()) {
      if (!contents.rig)
        throw UsageError("It needs a handle file among the files", "--pose");
      contents.pose = poseInput(pose_, *contents.rig, contents.warnings);
    }
    if (!slice_.empty())
      return drawSlice(contents, all.front(), context);
    Outcome outcome;
    outcome.json = {{"png", output_},
                    {"height", stage_.size.height},
                    {"view", views_.front()},
                    {"views", views_},
                    {"organs", contents.organs.size()},
                    {"handles", contents.rig ? contents.rig->handles.size() : 0}};
    scene::ValueRange range{0, 0};
    for (Shown& one : all) {
      if (influence_.empty())
        continue;
      one.influences = influencesOf(contents, rowOfHandle(*contents.rig, influence_), *one.system,
                                    one.options, context.progress);
      Eigen::Index reached = 0, vertices = 0;
      for (const auto& values : one.influences) {
        range.low = std::min(range.low, values->minCoeff());
        range.high = std::max(range.high, values->maxCoeff());
        reached += (values->array() != 0).count();
        vertices += values->size();
      }
      outcome.json["influence"].push_back(
          {{"system", one.system->id()}, {"vertices", vertices}, {"reached", reached}});
    }
    Pictures pictures;
    for (Shown& one : all) {
      context.progress.throwIfCancelled();
      one.range = range;
      const Pictures drawn =
          draw(one, contents, stage_.size.width / static_cast<int>(all.size()), context, outcome);
      pictures.insert(pictures.end(), drawn.begin(), drawn.end());
    }
    const auto sheet = scene::contactSheet(pictures, static_cast<int>(pictures.size()));
    outcome.json["width"] = sheet->GetDimensions()[0];
    if (pictures.size() > 1)
      scene::writeSmallPng(output_, sheet);
    else
      scene::writePng(output_, sheet);
    outcome.text = Listing().add("picture", output_).text();
    outcome.warnings.insert(outcome.warnings.begin(), contents.warnings.begin(), contents.warnings.end());
    return outcome;
  }

private:
  std::vector<Shown> shown(const CommandContext& context) const {
    const auto system = system_.system(context);
    if (beside_.empty())
      return {{system, system_.bindOptions(*system, context), {}}};
    const auto beside = context.systems.find(beside_);
    return {{system, system_.bindOptions(*system, context, beside.get()), {}},
            {beside, system_.bindOptions(*beside, context, system.get()), {}}};
  }

  using Pictures = std::vector<vtkSmartPointer<vtkImageData>>;

  /// One picture a side that is asked for; adds to `outcome` what was measured for it.
  Pictures draw(const Shown& shown, const Contents& contents, int width, CommandContext& context,
                Outcome& outcome) const {
    std::vector<document::Organ> seen = contents.organs;
    for (document::Organ& organ : seen)
      organ.look.opacity = opacity_;
    StillOrgans organs(std::move(seen));
    presentation::ViewState view;
    std::optional<presentation::SurfaceMap> map;
    if (contents.rig) {
      organs.setRig(*contents.rig, {shown.system->id(), shown.options.parameters});
      view.handles = view.shown.movable = true;
      view.shown.regions = parts_.any();
      view.layout = parts_;
    }
    if (!shown.influences.empty()) {
      map = influenceOf(shown, organs);
      view.selection.handles = {organs.handle(rowOfHandle(*contents.rig, influence_))};
    }
    if (contents.pose) {
      Progress& progress = context.progress;
      showPose(organs, contents, *shown.system, shown.options, progress);
      if (stress_)
        map = stressOf(organs, contents, *shown.system, shown.options, colors_, progress);
      if (!strain_.empty()) {
        PoseStrain strain = strainOfPose(organs, *contents.rig, *contents.pose, shown.system, shown.options,
                                         strain_, progress);
        map = std::move(strain.map);
        outcome.json["strain"].push_back(std::move(strain.json));
        outcome.warnings.insert(outcome.warnings.end(), strain.warnings.begin(), strain.warnings.end());
      }
    }
    StageOptions options = stage_;
    options.size.width = width;
    presentation::Stage stage = stageFor(options, context.threads);
    stage.presenter().update({organs.state(), organs, view, context.systems, nullptr, map ? &*map : nullptr});
    Pictures pictures;
    for (const std::string& side : views_) {
      stage.compose(scene::standardViewFromName(side), views_.size() > 1 ? kRoomOnASheet : 0);
      pictures.push_back(stage.picture());
    }
    return pictures;
  }

  presentation::SurfaceMap influenceOf(const Shown& shown, const StillOrgans& organs) const {
    presentation::SurfaceMap map;
    for (std::size_t i = 0; i < shown.influences.size(); ++i)
      map.values[organs.idOf(i)] = shown.influences[i];
    map.colors = scene::colorMapByName(colors_);
    map.range = shown.range;
    map.title = "Influence of " + influence_ + (beside_.empty() ? "" : ", " + shown.system->name());
    return map;
  }

  /// A slice of a scan, with the organs' contours.
  Outcome drawSlice(const Contents& contents, const Shown& shown, CommandContext& context) const {
    StillOrgans organs(contents.organs);
    if (contents.rig)
      organs.setRig(*contents.rig, {shown.system->id(), shown.options.parameters});
    if (contents.pose)
      showPose(organs, contents, *shown.system, shown.options, context.progress);
    organs.setScan(contents.scan);
    presentation::ViewState view;
    view.scan.level = level_;
    view.scan.width = width_;
    const SliceOutcome slice =
        slicePicture({organs.state(), organs, view}, sliceRequest(slice_), stage_, context.threads);
    scene::writePng(output_, slice.image);
    Outcome outcome;
    outcome.json = {{"png", output_},
                    {"width", stage_.size.width},
                    {"height", stage_.size.height},
                    {"organs", contents.organs.size()},
                    {"scan", contents.scan ? contents.scan->name : ""},
                    {"contours", slice.contours}};
    outcome.text = Listing().add("picture", output_).text();
    outcome.warnings = contents.warnings;
    return outcome;
  }

  /// A session as the window showed it.
  Outcome drawSession(CommandContext& context) {
    const bool more = files_.size() > 1 || !views_.empty() || !influence_.empty() || !pose_.empty() ||
                      !beside_.empty() || parts_.any();
    if (more)
      throw UsageError(
          "It is drawn as it is: only --view, --slice, --signs, --size and --theme go with a session",
          files_.front(), "draw its organs' and handles' own files for anything else");
    stage_.size = pictureSize(size_);
    const document::OpenedSession opened =
        document::readSession(files_.front(), context.samples, context.progress);
    if (!slice_.empty())
      return drawSlice(opened, context);
    std::optional<ShownBeat> beat;
    std::optional<SignsBelow> signs;
    if (signs_.given()) {
      if (!(beat = shownBeat(opened, context)))
        throw UsageError("It was not saved at an instant of a beat", signs_.text(),
                         "save it in the window while the heart beats or stands at an instant");
      signs.emplace(signs_, beat->beat, stage_);
    }
    SessionPicture picture =
        sessionPicture(opened, signs ? signs->above() : stage_, viewGiven_->count() > 0, context);
    if (signs)
      picture.image = signs->below(picture.image, beat->fraction);
    scene::writePng(output_, picture.image);
    Outcome outcome;
    outcome.json = {{"png", output_},
                    {"width", stage_.size.width},
                    {"height", stage_.size.height},
                    {"organs", opened.contents.state.organs->size()},
                    {"handles", opened.contents.state.rig->handles.size()}};
    if (signs)
      outcome.json["signs"] = signs->drawn();
    outcome.text = Listing().add("picture", output_).text();
    outcome.warnings = opened.warnings;
    std::string leftOut;
    for (const std::string& item : picture.leftOut)
      leftOut += (leftOut.empty() ? "" : ", ") + item;
    if (!leftOut.empty())
      outcome.warnings.push_back("the window showed what is not drawn here: " + leftOut);
    return outcome;
  }

  /// A slice of a session's scan, as the window showed it but for its place, size and, where they are given,
  /// level and width.
  Outcome drawSlice(const document::OpenedSession& opened, CommandContext& context) const {
    const document::DocumentState& state = opened.contents.state;
    const SliceOutcome slice = sessionSlice(opened, sliceRequest(slice_), level_, width_, stage_, context);
    scene::writePng(output_, slice.image);
    Outcome outcome;
    outcome.json = {{"png", output_},
                    {"width", stage_.size.width},
                    {"height", stage_.size.height},
                    {"organs", state.organs->size()},
                    {"scan", state.scan ? state.scan->name : ""},
                    {"contours", slice.contours}};
    outcome.text = Listing().add("picture", output_).text();
    outcome.warnings = opened.warnings;
    return outcome;
  }

  std::vector<std::string> files_;
  std::string output_;
  std::string size_ = "1600x1000";
  std::string influence_;
  std::vector<std::string> views_;
  std::string beside_;
  scene::LayoutParts parts_{.regions = false};
  std::string pose_;
  bool stress_ = false;
  std::string strain_; ///< The direction; empty: it is not asked for.
  std::string colors_ = scene::viridis().name;
  std::string slice_;
  double level_ = 0;
  double width_ = 0; ///< 0: as the scan proposes.
  StageOptions stage_;
  CLI::Option* viewGiven_ = nullptr;
  double opacity_ = 1;
  SignsOption signs_;
  SystemOptions system_;
};

} // namespace

std::unique_ptr<Command> renderCommand() {
  return std::make_unique<RenderCommand>();
}

} // namespace viscera::app::cli
