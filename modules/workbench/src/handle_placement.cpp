#include "viscera/workbench/handle_placement.h"

#include <utility>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/document/rig_commands.h"

namespace viscera::workbench {
namespace {

const Vec3 kEnclosingColor(0.45, 0.55, 0.62);
const Vec3 kSurfaceColor(0.98, 0.72, 0.25);
constexpr int kCorners = 8;

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

Points around(const document::OrganList& chosen, const document::OrganList& organs,
              const deformation::Placement& placement) {
  std::vector<const geometry::TriangleMesh*> meshes;
  for (const auto& organ : chosen)
    meshes.push_back(organ->mesh.get());
  Points handles = deformation::placeHandles(meshes, placement);
  if (placement.enclosing)
    handles.topRows(kCorners) = deformation::enclosingHandles(endsOf(organs), placement.boxMargin);
  return handles;
}

} // namespace

document::OrganList wholeOrgans(const document::OrganList& organs) {
  document::OrganList whole;
  for (const auto& organ : organs)
    if (!organ->parent)
      whole.push_back(organ);
  return whole.empty() ? organs : whole;
}

document::Command placeHandles(const document::OrganList& chosen, const document::OrganList& organs,
                               const deformation::Placement& placement, const PlacementNames& names) {
  document::Rig rig = document::rigAt(around(chosen, organs, placement));
  const int corners = placement.enclosing ? kCorners : 0;
  std::vector<int> enclosing, surface;
  for (int i = 0; i < static_cast<int>(rig.handles.size()); ++i)
    (i < corners ? enclosing : surface).push_back(i);
  rig.addGroup(names.surface, kSurfaceColor, surface);
  if (corners > 0)
    rig.addGroup(names.enclosing, kEnclosingColor, enclosing);
  return document::replaceRig(std::move(rig), names.step);
}

document::Command placeHandlesOrBox(const document::OrganList& organs,
                                    const deformation::Placement& placement, const PlacementNames& names) {
  try {
    return placeHandles(wholeOrgans(organs), organs, placement, names);
  } catch (const DataError&) {
    document::Rig rig = document::rigAt(deformation::enclosingHandles(endsOf(organs), placement.boxMargin));
    rig.addGroup(names.enclosing, kEnclosingColor, {0, 1, 2, 3, 4, 5, 6, 7});
    return document::replaceRig(std::move(rig), names.step);
  }
}

} // namespace viscera::workbench
