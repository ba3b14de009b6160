#include "cli/stage.h"

#include <CLI/CLI.hpp>
#include <vtkImageData.h>

#include "viscera/scene/picture.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"

namespace viscera::app::cli {
namespace {

/// Handles farther from the organs than this part of their diagonal (the corners of an enclosing box) may lie
/// outside the picture: the organs are what it is about.
constexpr double kNear = 0.1;

/// Handles in no group.
const Vec3 kUngrouped(0.90, 0.62, 0.00);

/// Each handle in the colour of its first group, as in the window.
Colors handleColors(const RigInput& rig) {
  const auto bytes = [](const Vec3& color) -> Eigen::Matrix<std::uint8_t, 1, 3> {
    return (255 * color).array().round().matrix().cast<std::uint8_t>().transpose();
  };
  Colors colors = bytes(kUngrouped).replicate(rig.handles.positions.rows(), 1);
  for (std::size_t group = rig.handles.groups.size(); group-- > 0;)
    for (const int handle : rig.handles.groups[group].handles)
      colors.row(handle) = bytes(rig.groupColors[group]);
  return colors;
}

Bounds joined(const Bounds& a, const Bounds& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

} // namespace

void addStageOptions(CLI::App& options, StageOptions& stage, std::string& size) {
  options.add_option("--size", size, "Size of the picture in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  options
      .add_option("--view", stage.view, "From where: anterior, posterior, left, right, superior, inferior")
      ->type_name("NAME")
      ->capture_default_str();
  options.add_option("--theme", stage.theme, "Colours around the organs")
      ->check(CLI::IsMember({"dark", "light"}))
      ->capture_default_str();
}

Stage::Stage(const StageOptions& options, Threads threads)
    : threads_(threads), side_(scene::standardViewFromName(options.view)),
      window_(options.size.width, options.size.height) {
  view_.setWindow(window_.window());
  view_.setTheme(options.theme == "light" ? scene::lightTheme() : scene::darkTheme());
}

std::shared_ptr<scene::OrganActor> Stage::add(const document::Organ& organ, double opacity) {
  auto actor = std::make_shared<scene::OrganActor>(organ.mesh, threads_);
  actor->setColor(organ.look.color);
  actor->setOpacity(opacity);
  view_.add(actor);
  return actor;
}

void Stage::showHandles(const RigInput& rig) {
  view_.handles()->SetPositions(rig.handles.positions);
  view_.handles()->SetColors(handleColors(rig));
}

void Stage::compose() {
  lookAtAll(0);
}

void Stage::compose(const std::string& view, double room) {
  side_ = scene::standardViewFromName(view);
  lookAtAll(room);
}

void Stage::lookAtAll(double room) {
  const Bounds organs = view_.bounds();
  Bounds bounds = organs;
  for (const auto& row : view_.handles()->GetPositions().rowwise()) {
    const Vec3 handle = row.transpose();
    const Vec3 beyond = (organs.low - handle).cwiseMax(handle - organs.high).cwiseMax(0);
    if (beyond.norm() <= kNear * organs.diagonal())
      bounds = joined(bounds, {handle, handle});
  }
  for (const scene::RegionHull& hull : view_.regions().hulls())
    bounds = joined(bounds, boundsOf(hull.vertices));
  const Vec3 around = Vec3::Constant(room * bounds.diagonal());
  view_.lookFrom(side_, {bounds.low - around, bounds.high + around});
}

vtkSmartPointer<vtkImageData> Stage::picture() {
  return scene::grabPicture(window_.window());
}

} // namespace viscera::app::cli
