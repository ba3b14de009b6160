#include "organ_picture.h"

#include <algorithm>
#include <utility>

namespace viscera::presentation {
namespace {

void cutLike(scene::GhostOutline& outline, const std::optional<scene::CutPlane>& plane) {
  if (plane)
    outline.setClipPlane(plane->origin, plane->normal);
  else
    outline.clearClipPlane();
}

} // namespace

OrganPicture::~OrganPicture() {
  for (auto& [id, shown] : shown_)
    drop(shown);
  updateTransientSurfaces({});
}

void OrganPicture::drop(Shown& shown) {
  if (shown.ghost)
    shown.ghost->setRenderer(nullptr);
  if (shown.outline)
    shown.outline->setRenderer(nullptr);
  view_.remove(shown.actor);
}

void OrganPicture::add(const std::shared_ptr<const document::Organ>& organ) {
  Shown& shown = shown_[organ->id];
  shown.organ = organ;
  shown.actor = std::make_shared<scene::OrganActor>(organ->mesh, threads_);
  view_.add(shown.actor);
}

/// Points that moved in place are computed anew; points elsewhere are taken with what keeps them.
void OrganPicture::follow(Shown& shown, const live::PosedOrgans& organs) {
  const std::uint64_t revision = organs.revision(shown.organ->id);
  auto points = organs.sharedPoints(shown.organ->id);
  if (points != shown.points)
    shown.actor->setPoints(points);
  else if (revision != shown.revision)
    shown.actor->pointsChanged();
  if (shown.outline && (points != shown.points || revision != shown.revision))
    shown.outline->setPoints(*points, shown.actor->normals());
  shown.points = std::move(points);
  shown.revision = revision;
}

bool OrganPicture::updateOrgans(const Scene& scene) {
  bool others = false;
  for (auto found = shown_.begin(); found != shown_.end();) {
    const auto organ = scene.state.organ(found->first);
    if (organ && organ->mesh == found->second.organ->mesh) {
      ++found;
      continue;
    }
    drop(found->second);
    found = shown_.erase(found);
    others = true;
  }
  for (const auto& organ : *scene.state.organs) {
    if (shown_.count(organ->id) == 0) {
      add(organ);
      others = true;
    }
    Shown& shown = shown_.at(organ->id);
    shown.organ = organ;
    follow(shown, scene.organs);
  }
  return others;
}

void OrganPicture::updateTransientSurfaces(const std::vector<TransientSurface>& transient) {
  std::vector<std::shared_ptr<scene::OrganActor>> now;
  for (const TransientSurface& guest : transient) {
    const auto same = [&guest](const auto& actor) { return &actor->mesh() == guest.mesh.get(); };
    const auto found = std::find_if(transient_.begin(), transient_.end(), same);
    now.push_back(found == transient_.end() ? std::make_shared<scene::OrganActor>(guest.mesh, threads_)
                                            : *found);
    now.back()->setColor(shownColor(guest.color));
    now.back()->setOpacity(guest.opacity);
    now.back()->setVertexColorsShown(guest.vertexColors);
    view_.add(now.back());
  }
  for (const auto& actor : transient_)
    if (std::find(now.begin(), now.end(), actor) == now.end())
      view_.remove(actor);
  transient_ = std::move(now);
}

void OrganPicture::updateGhost(Shown& shown, bool wanted) {
  if (wanted && !shown.ghost) {
    shown.ghost = std::make_unique<scene::GhostOutline>(shown.organ->mesh);
    shown.ghost->setRenderer(view_.renderer());
  }
  if (!shown.ghost)
    return;
  shown.ghost->setColor(view_.theme().muted);
  shown.ghost->setVisible(wanted);
}

/// Whether there are organs to tell apart; a cavity belongs to the organ around it.
bool OrganPicture::showsSeveral() const {
  return std::count_if(shown_.begin(), shown_.end(), [](const auto& one) {
           return !one.second.organ->parent && one.second.organ->look.visible;
         }) > 1;
}

/// Among several organs an outline marks the selected one, because brightening alone makes it look flat.
void OrganPicture::updateSelection(Shown& shown, bool selected, bool visible) {
  const bool outlined = selected && visible && showsSeveral();
  shown.actor->setSelected(selected && !outlined);
  if (!outlined && shown.outline) {
    shown.outline->setRenderer(nullptr);
    shown.outline.reset();
  }
  if (!outlined)
    return;
  if (!shown.outline) {
    shown.outline = std::make_unique<scene::GhostOutline>(shown.organ->mesh);
    shown.outline->setPoints(*shown.points, shown.actor->normals());
    shown.outline->setOpacity(1);
    shown.outline->setSeenThrough(false);
    shown.outline->setRenderer(view_.renderer());
  }
  shown.outline->setColor(view_.theme().accent);
}

/// A table of colours is made only for other colours; numbers that changed in place are only told.
void OrganPicture::updateColors(Shown& shown, const Appearance& appearance, const MapColors& colors) {
  const bool sameTable = colors.colors.name == colors_.colors.name && colors.range == colors_.range;
  if (!appearance.values) {
    if (shown.values)
      shown.actor->hideScalars();
  } else if (appearance.values != shown.values || !sameTable) {
    shown.actor->showScalars(appearance.values, colors.colors, colors.range);
  } else if (colors.revision != colors_.revision) {
    shown.actor->scalarsChanged();
  }
  shown.values = appearance.values;
}

void OrganPicture::updateLooks(const Scene& scene, const std::map<document::OrganId, Appearance>& appearances,
                               const MapColors& colors) {
  for (auto& [id, shown] : shown_) {
    const document::OrganLook& look = shown.organ->look;
    const auto found = appearances.find(id);
    const Appearance appearance =
        found == appearances.end() ? Appearance{look.visible, look.opacity} : found->second;
    scene::OrganActor& actor = *shown.actor;
    actor.setColor(shownColor(look.color));
    if (std::exchange(shown.vertexColors, look.vertexColors) != look.vertexColors)
      actor.setVertexColorsShown(look.vertexColors);
    actor.setVisible(appearance.visible);
    actor.setRole(appearance.drawn ? scene::SurfaceRole::whole : scene::SurfaceRole::body);
    actor.setOpacity(appearance.opacity);
    updateColors(shown, appearance, colors);
    if (appearance.clip && appearance.clip != shown.clip)
      actor.setClipPlane(appearance.clip->origin, appearance.clip->normal);
    else if (!appearance.clip && shown.clip)
      actor.clearClipPlane();
    shown.clip = appearance.clip;
    updateSelection(shown, id == scene.view.selection.organ, appearance.visible);
    updateGhost(shown, scene.view.ghost && look.visible);
    if (shown.outline)
      cutLike(*shown.outline, shown.clip);
  }
  colors_ = colors;
}

document::OrganId OrganPicture::organOf(const scene::OrganActor* actor) const {
  for (const auto& [id, shown] : shown_)
    if (shown.actor.get() == actor)
      return id;
  return {};
}

std::shared_ptr<scene::OrganActor> OrganPicture::actorOf(document::OrganId organ) const {
  const auto found = shown_.find(organ);
  return found == shown_.end() ? nullptr : found->second.actor;
}

} // namespace viscera::presentation
