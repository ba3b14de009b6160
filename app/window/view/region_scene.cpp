#include "window/view/region_scene.h"

#include "viscera/coordinates/cage/cage.h"

namespace viscera::app {
namespace {

/// The cage that the chosen coordinates work with; without triangles where there is none.
Triangles cageToDraw(const coordinates::HandleSet& handles) {
  try {
    return coordinates::cageOf(handles);
  } catch (const Error&) {
    return {}; // Flat handles, say: binding fails for the same reason and tells it.
  }
}

} // namespace

std::vector<scene::RegionHull> regionHulls(const document::Rig& rig, const coordinates::SpaceLayout& layout,
                                           const scene::LayoutParts& shown, bool withCage) {
  std::vector<Vec3> colors;
  for (const document::Group& group : rig.groups)
    colors.push_back(group.color);
  std::vector<scene::RegionHull> hulls = scene::layoutHulls(layout, colors, shown);
  if (!withCage || !shown.regions)
    return hulls;
  const coordinates::HandleSet handles = document::handleSet(rig);
  if (const Triangles cage = cageToDraw(handles); cage.rows() > 0)
    hulls.push_back(scene::cageHull(handles.positions, cage));
  return hulls;
}

RegionScene::RegionScene(Workspace& workspace, GroupLayout& layout, const ViewModel& model,
                         scene::OrganView& view, QObject* parent)
    : QObject(parent), workspace_(workspace), layout_(layout), model_(model), view_(view) {
  connect(&model, &ViewModel::changed, this, &RegionScene::sync);
  subscription_ = workspace.onChange([this](const document::Change& change) {
    if (change.rig() || change.system())
      sync();
  });
}

RegionScene::~RegionScene() {
  view_.regions().setHulls({});
}

void RegionScene::sync() {
  std::vector<scene::RegionHull> hulls;
  if (model_.state().shown.regions)
    hulls = regionHulls(workspace_.document().rig(), layout_.now(), model_.state().layout,
                        workspace_.systemTraits().needsCage);
  if (hulls.empty() && view_.regions().hulls().empty())
    return;
  view_.regions().setHulls(std::move(hulls));
  Q_EMIT changed();
}

} // namespace viscera::app
