#include "window/work/handle_placer.h"

#include <algorithm>
#include <utility>

#include "viscera/workbench/handle_placement.h"

namespace viscera::app {
namespace {

/// The names in the language of the window.
workbench::PlacementNames placementNames() {
  return {HandlePlacer::tr("Place handles").toStdString(), HandlePlacer::tr("Surface").toStdString(),
          HandlePlacer::tr("Enclosing").toStdString()};
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
  const document::OrganList whole = workbench::wholeOrgans(organs);
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

document::Command HandlePlacer::command(const document::OrganList& organs) const {
  return command(workbench::wholeOrgans(organs), organs);
}

document::Command HandlePlacer::command(const document::OrganList& chosen,
                                        const document::OrganList& organs) const {
  return workbench::placeHandles(chosen, organs, placement_, placementNames());
}

document::Command HandlePlacer::commandOrBox(const document::OrganList& organs) const {
  return workbench::placeHandlesOrBox(organs, placement_, placementNames());
}

} // namespace viscera::app
