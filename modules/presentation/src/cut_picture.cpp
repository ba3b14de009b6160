#include "cut_picture.h"

#include <algorithm>

#include "viscera/geometry/plane_cut.h"
#include "viscera/presentation/resection.h"

namespace viscera::presentation {
namespace {

/// A face is a little paler than the surface, as cut flesh is.
constexpr double kPaler = 0.25;
/// The face of blood lies that far behind that of the tissue, mm, which so is seen where both are.
constexpr double kBloodBehind = 0.2;

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

Vec3 faceColor(const document::Organ& organ) {
  return (1 - kPaler) * shownColor(organ.look.color) + kPaler * Vec3::Ones();
}

bool isIn(const document::Organ& organ, const live::SampleHeartOrgans& heart) {
  const auto same = [&](const auto& other) { return other->id == organ.id; };
  return same(heart.outer) || std::any_of(heart.cavities.begin(), heart.cavities.end(), same);
}

} // namespace

std::vector<scene::CutCaps::Face> CutPicture::facesOf(const Scene& scene, const HeartPicture& heart) const {
  const geometry::Plane plane{plane_->origin, plane_->normal};
  const auto cutOf = [&scene](const document::Organ& organ, const geometry::Plane& at) {
    const auto points = scene.organs.sharedPoints(organ.id);
    return geometry::cutSurface({points.get(), &organ.mesh->triangles}, at);
  };
  std::vector<scene::CutCaps::Face> faces;
  if (const auto& opened = heart.opened()) {
    faces.push_back({geometry::cutSurface(heart.surface(), plane), {}, faceColor(*opened->heart.outer)});
    const geometry::Plane behind{plane.origin + kBloodBehind * plane.normal, plane.normal};
    for (const auto& cavity : opened->heart.cavities)
      if (opened->blood && cavity->look.visible && cavity->closed())
        faces.push_back({cutOf(*cavity, behind), {}, shownColor(cavity->look.color)});
  }
  for (const auto& organ : *scene.state.organs) {
    if (!organ->look.visible || !organ->closed() || hollow(*organ, scene.state) ||
        (heart.opened() && isIn(*organ, heart.opened()->heart)))
      continue;
    scene::CutCaps::Face face{cutOf(*organ, plane), {}, faceColor(*organ)};
    for (const auto& other : *scene.state.organs)
      if (other->parent == organ->id && other->closed())
        face.cavities.push_back(cutOf(*other, plane));
    faces.push_back(std::move(face));
  }
  return faces;
}

void CutPicture::update(const Scene& scene, const HeartPicture& heart) {
  const auto plane = cutWanted(scene) ? std::optional(planeOf(scene.view.cut, scene.state)) : std::nullopt;
  Moment moment;
  if (plane)
    for (const auto& organ : *scene.state.organs)
      moment[organ->id] = {scene.organs.sharedPoints(organ->id), scene.organs.revision(organ->id)};
  if (plane == plane_ && moment == moment_ && heart_ == heart.revision() &&
      (!plane || organs_ == scene.state.organs))
    return;
  plane_ = plane;
  moment_ = std::move(moment);
  heart_ = heart.revision();
  organs_ = scene.state.organs;
  caps_.setFaces(plane_ ? facesOf(scene, heart) : std::vector<scene::CutCaps::Face>(),
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
