#include "viscera/presentation/space_parts.h"

#include "viscera/coordinates/cage/cage.h"
#include "viscera/core/error.h"

namespace viscera::presentation {
namespace {

/// The cage that the chosen coordinates work with; without triangles where there is none.
Triangles cageToDraw(const coordinates::HandleSet& handles) {
  try {
    return coordinates::cageOf(handles);
  } catch (const Error&) {
    return {}; // For example for handles in one plane: binding fails for the same reason and reports it.
  }
}

} // namespace

std::shared_ptr<const document::Organ> currentOrgan(const document::DocumentState& state,
                                                    document::OrganId selected) {
  if (auto organ = state.organ(selected))
    return organ;
  for (const auto& organ : *state.organs)
    if (!organ->parent)
      return organ;
  return nullptr;
}

coordinates::Traits traitsOf(const document::DocumentState& state, const coordinates::Registry& systems) {
  const std::string& id = state.system->id;
  return systems.contains(id) ? systems.find(id)->traits() : coordinates::Traits();
}

coordinates::SpaceLayout layoutOf(const document::DocumentState& state,
                                  const coordinates::Registry& systems) {
  if (!systems.contains(state.system->id) || state.rig->handles.empty())
    return {};
  try {
    return systems.find(state.system->id)->layout(document::handleSet(*state.rig), state.system->parameters);
  } catch (const Error&) {
    return {}; // For example for a group in one plane: binding fails for the same reason and reports it.
  }
}

std::vector<scene::RegionHull> regionHulls(const document::DocumentState& state,
                                           const scene::LayoutParts& shown,
                                           const coordinates::Registry& systems) {
  std::vector<Vec3> colors;
  for (const document::Group& group : state.rig->groups)
    colors.push_back(group.color);
  std::vector<scene::RegionHull> hulls = scene::layoutHulls(layoutOf(state, systems), colors, shown);
  if (!shown.regions || !traitsOf(state, systems).needsCage)
    return hulls;
  const coordinates::HandleSet handles = document::handleSet(*state.rig);
  if (const Triangles cage = cageToDraw(handles); cage.rows() > 0)
    hulls.push_back(scene::cageHull(handles.positions, cage));
  return hulls;
}

std::optional<deformation::MirrorPlane> mirrorPlaneOf(const document::DocumentState& state,
                                                      document::OrganId selected, Mirror mirror) {
  const auto organ = currentOrgan(state, selected);
  if (mirror == Mirror::off || !organ)
    return std::nullopt;
  // LPS: x runs from side to side, y from front to back, z from foot to head.
  const int axis = mirror == Mirror::sagittal ? 0 : mirror == Mirror::coronal ? 1 : 2;
  return deformation::MirrorPlane{boundsOf(organ->mesh->points).center(), Vec3::Unit(axis)};
}

} // namespace viscera::presentation
