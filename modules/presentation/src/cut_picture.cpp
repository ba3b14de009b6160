#include "cut_picture.h"

#include <algorithm>

#include "viscera/geometry/plane_cut.h"
#include "viscera/presentation/resection.h"

namespace viscera::presentation {
namespace {

/// A face is a little paler than the surface, as cut flesh is.
constexpr double kPaler = 0.25;

bool cutWanted(const Scene& scene) {
  return scene.view.cut.on && !scene.view.shown.stress && !scene.state.organs->empty();
}

const document::Organ* parentOf(const document::Organ& organ, const document::DocumentState& state) {
  for (const auto& other : *state.organs)
    if (other->id == organ.parent)
      return other.get();
  return nullptr;
}

/// Whether an organ is a hollow in another one that is seen.
bool hollow(const document::Organ& organ, const document::DocumentState& state) {
  const document::Organ* parent = parentOf(organ, state);
  return parent && parent->look.visible;
}

} // namespace

std::vector<scene::CutCaps::Face> CutPicture::facesOf(const Scene& scene) const {
  const geometry::Plane plane{plane_->origin, plane_->normal};
  const auto cutOf = [&](const document::Organ& organ) {
    const auto points = scene.organs.sharedPoints(organ.id);
    return geometry::cutSurface({points.get(), &organ.mesh->triangles}, plane);
  };
  std::vector<scene::CutCaps::Face> faces;
  for (const auto& organ : *scene.state.organs) {
    if (!organ->look.visible || !organ->closed() || hollow(*organ, scene.state))
      continue;
    scene::CutCaps::Face face{
        cutOf(*organ), {}, (1 - kPaler) * shownColor(organ->look.color) + kPaler * Vec3::Ones()};
    for (const auto& other : *scene.state.organs)
      if (other->parent == organ->id && other->closed())
        face.cavities.push_back(cutOf(*other));
    faces.push_back(std::move(face));
  }
  return faces;
}

void CutPicture::update(const Scene& scene) {
  const auto plane = cutWanted(scene) ? std::optional(planeOf(scene.view.cut, scene.state)) : std::nullopt;
  Moment moment;
  if (plane)
    for (const auto& organ : *scene.state.organs)
      moment[organ->id] = {scene.organs.sharedPoints(organ->id), scene.organs.revision(organ->id)};
  if (plane == plane_ && moment == moment_ && (!plane || organs_ == scene.state.organs))
    return;
  plane_ = plane;
  moment_ = std::move(moment);
  organs_ = scene.state.organs;
  caps_.setFaces(plane_ ? facesOf(scene) : std::vector<scene::CutCaps::Face>(),
                 plane_ ? Vec3(-plane_->normal) : Vec3::UnitZ());
}

void CutPicture::apply(const Scene& scene, std::map<document::OrganId, Appearance>& appearances) const {
  if (!plane_)
    return;
  for (const auto& organ : *scene.state.organs) {
    const auto [found, fresh] = appearances.try_emplace(organ->id);
    if (fresh)
      found->second = {organ->look.visible, organ->look.opacity};
    found->second.clip = plane_;
  }
}

} // namespace viscera::presentation
