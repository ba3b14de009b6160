#include "window/handle_placer.h"

#include <algorithm>
#include <utility>

#include "viscera/document/rig_commands.h"

namespace viscera::app {
namespace {

const Vec3 kEnclosingColor(0.45, 0.55, 0.62);
const Vec3 kSurfaceColor(0.98, 0.72, 0.25);
constexpr int kCorners = 8;

/// Organs that are no cavity of another one; all where there is none.
document::OrganList wholeOf(const document::OrganList& organs) {
  document::OrganList whole;
  for (const auto& organ : organs)
    if (!organ->parent)
      whole.push_back(organ);
  return whole.empty() ? organs : whole;
}

/// The opposite corners of each organ's box.
Points endsOf(const document::OrganList& organs) {
  Points ends(2 * static_cast<Eigen::Index>(organs.size()), 3);
  Eigen::Index row = 0;
  for (const auto& organ : organs) {
    const Bounds box = boundsOf(organ->mesh->points);
    ends.row(row++) = box.low.transpose();
    ends.row(row++) = box.high.transpose();
  }
  return ends;
}

} // namespace

HandlePlacer::HandlePlacer(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {}

void HandlePlacer::setCount(int count) {
  placement_.count = std::clamp(count, fewest(), most());
  if (!choosing_)
    workspace_.guarded([this] { choosing_.emplace(workspace_.undo(), tr("Place handles").toStdString()); });
  place();
}

void HandlePlacer::finish() {
  if (auto step = std::exchange(choosing_, std::nullopt))
    workspace_.guarded([&step] { step->finish(); });
}

void HandlePlacer::setEnclosing(bool enclosing) {
  finish();
  placement_.enclosing = enclosing;
  placement_.count = std::clamp(placement_.count, fewest(), most());
  Q_EMIT placementChanged();
  place();
}

document::OrganList HandlePlacer::chosen() const {
  const document::OrganList& organs = workspace_.document().organs();
  if (const auto organ = workspace_.document().organ(workspace_.selection().organ()))
    return {organ};
  const document::OrganList whole = wholeOf(organs);
  document::OrganList visible;
  for (const auto& organ : whole)
    if (organ->look.visible)
      visible.push_back(organ);
  return visible.empty() ? whole : visible;
}

void HandlePlacer::place() {
  const document::OrganList around = chosen();
  if (around.empty())
    return;
  workspace_.guarded([&] { workspace_.undo().perform(command(around, workspace_.document().organs())); });
  Q_EMIT placementChanged();
}

Points HandlePlacer::around(const document::OrganList& chosen, const document::OrganList& organs) const {
  std::vector<const geometry::TriangleMesh*> meshes;
  for (const auto& organ : chosen)
    meshes.push_back(organ->mesh.get());
  Points handles = deformation::placeHandles(meshes, placement_);
  if (placement_.enclosing)
    handles.topRows(kCorners) = deformation::enclosingHandles(endsOf(organs), placement_.boxMargin);
  return handles;
}

document::Command HandlePlacer::command(const document::OrganList& organs) const {
  return command(wholeOf(organs), organs);
}

document::Command HandlePlacer::command(const document::OrganList& chosen,
                                        const document::OrganList& organs) const {
  document::Rig rig = document::rigAt(around(chosen, organs));
  const int corners = placement_.enclosing ? kCorners : 0;
  std::vector<int> enclosing, surface;
  for (int i = 0; i < static_cast<int>(rig.handles.size()); ++i)
    (i < corners ? enclosing : surface).push_back(i);
  rig.addGroup(tr("Surface").toStdString(), kSurfaceColor, surface);
  if (corners > 0)
    rig.addGroup(tr("Enclosing").toStdString(), kEnclosingColor, enclosing);
  return document::replaceRig(std::move(rig), tr("Place handles").toStdString());
}

document::Command HandlePlacer::commandOrBox(const document::OrganList& organs) const {
  try {
    return command(organs);
  } catch (const DataError&) {
    document::Rig rig = document::rigAt(deformation::enclosingHandles(endsOf(organs), placement_.boxMargin));
    rig.addGroup(tr("Enclosing").toStdString(), kEnclosingColor, {0, 1, 2, 3, 4, 5, 6, 7});
    return document::replaceRig(std::move(rig), tr("Place handles").toStdString());
  }
}

} // namespace viscera::app
