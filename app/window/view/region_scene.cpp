#include "window/view/region_scene.h"

#include "viscera/geometry/convex_hull.h"

namespace viscera::app {
namespace {

/// The cage that the chosen coordinates work with; without triangles where there is none.
Triangles cageOf(const coordinates::HandleSet& handles) {
  if (handles.cage.rows() > 0)
    return handles.cage;
  try {
    return geometry::ConvexHull(handles.positions).triangles();
  } catch (const Error&) {
    return {}; // Flat handles, say: binding fails for the same reason and tells it.
  }
}

} // namespace

RegionScene::RegionScene(Workspace& workspace, GroupLayout& layout, scene::OrganView& view, QObject* parent)
    : QObject(parent), workspace_(workspace), layout_(layout), view_(view) {
  subscription_ = workspace.onChange([this](const session::Change& change) {
    if (change.rig() || change.system())
      sync();
  });
}

RegionScene::~RegionScene() {
  view_.regions().setHulls({});
}

void RegionScene::setMode(Mode mode) {
  mode_ = mode;
  sync();
}

void RegionScene::setShown(const scene::LayoutParts& shown) {
  shown_ = shown;
  sync();
}

void RegionScene::sync() {
  std::vector<scene::RegionHull> hulls;
  if (mode_ == Mode::handles && shown_.any()) {
    std::vector<Vec3> colors;
    for (const session::Group& group : workspace_.document().rig().groups)
      colors.push_back(group.color);
    hulls = scene::layoutHulls(layout_.now(), colors, shown_);
  }
  if (mode_ == Mode::handles && shown_.regions && workspace_.systemTraits().needsCage) {
    const coordinates::HandleSet handles = session::handleSet(workspace_.document().rig());
    if (const Triangles cage = cageOf(handles); cage.rows() > 0)
      hulls.push_back(scene::cageHull(handles.positions, cage));
  }
  if (hulls.empty() && view_.regions().hulls().empty())
    return;
  view_.regions().setHulls(std::move(hulls));
  Q_EMIT changed();
}

} // namespace viscera::app
