#include "window/handle_placer.h"

#include <algorithm>
#include <utility>

#include "viscera/document/rig_commands.h"

namespace viscera::app {
namespace {

const Vec3 kEnclosingColor(0.45, 0.55, 0.62);
const Vec3 kSurfaceColor(0.98, 0.72, 0.25);
constexpr int kCorners = 8;

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

void HandlePlacer::place() {
  const auto organ = workspace_.currentOrgan();
  if (!organ)
    return;
  workspace_.guarded([&] { workspace_.undo().perform(command(*organ)); });
  Q_EMIT placementChanged();
}

Points HandlePlacer::around(const document::Organ& organ, const document::OrganList& organs) const {
  Points handles = deformation::placeHandles(*organ.mesh, placement_);
  if (!placement_.enclosing)
    return handles;
  Points ends(2 * static_cast<Eigen::Index>(organs.size()) + 2, 3);
  auto addEnds = [&, row = Eigen::Index{0}](const document::Organ& one) mutable {
    const Bounds box = boundsOf(one.mesh->points);
    ends.row(row++) = box.low.transpose();
    ends.row(row++) = box.high.transpose();
  };
  addEnds(organ);
  for (const auto& other : organs)
    addEnds(*other);
  handles.topRows(kCorners) = deformation::enclosingHandles(ends, placement_.boxMargin);
  return handles;
}

document::Command HandlePlacer::command(const document::Organ& organ) const {
  return command(organ, workspace_.document().organs());
}

document::Command HandlePlacer::command(const document::Organ& organ,
                                        const document::OrganList& organs) const {
  document::NewRig rig;
  rig.handles = document::newHandles(around(organ, organs));
  const int corners = placement_.enclosing ? kCorners : 0;
  document::NewGroup enclosing{tr("Enclosing").toStdString(), kEnclosingColor, {}};
  document::NewGroup surface{tr("Surface").toStdString(), kSurfaceColor, {}};
  for (int i = 0; i < static_cast<int>(rig.handles.size()); ++i)
    (i < corners ? enclosing : surface).handles.push_back(i);
  rig.groups.push_back(std::move(surface));
  if (corners > 0)
    rig.groups.push_back(std::move(enclosing));
  return document::replaceRig(std::move(rig), tr("Place handles").toStdString());
}

document::Command HandlePlacer::commandOrBox(const document::Organ& organ,
                                             const document::OrganList& organs) const {
  try {
    return command(organ, organs);
  } catch (const DataError&) {
    document::NewRig rig;
    rig.handles =
        document::newHandles(deformation::enclosingHandles(organ.mesh->points, placement_.boxMargin));
    rig.groups.push_back({tr("Enclosing").toStdString(), kEnclosingColor, {0, 1, 2, 3, 4, 5, 6, 7}});
    return document::replaceRig(std::move(rig), tr("Place handles").toStdString());
  }
}

} // namespace viscera::app
