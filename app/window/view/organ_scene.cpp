#include "window/view/organ_scene.h"

#include "viscera/scene/color_map.h"

namespace viscera::app {
namespace {

/// Looks at points that somebody else owns; the live binding keeps them in place until it says otherwise.
std::shared_ptr<const Points> lookAt(const Points& points) {
  return {std::shared_ptr<void>(), &points};
}

constexpr double kPercent = 100;

} // namespace

OrganScene::OrganScene(Workspace& workspace, scene::OrganView& view, QObject* parent)
    : QObject(parent), workspace_(workspace), view_(view) {
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      syncOrgans();
    if (change.rig())
      syncInfluence();
  }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent& event) { onLive(event); }));
  subscriptions_.push_back(workspace.selection().onChange([this] {
    syncSelection();
    syncInfluence();
  }));
  syncOrgans();
}

OrganScene::~OrganScene() {
  for (auto& [id, shown] : shown_) {
    if (shown.ghost)
      shown.ghost->setRenderer(nullptr);
    view_.remove(shown.actor);
  }
}

document::OrganId OrganScene::organOf(const scene::OrganActor* actor) const {
  for (const auto& [id, shown] : shown_)
    if (shown.actor.get() == actor)
      return id;
  return {};
}

std::shared_ptr<scene::OrganActor> OrganScene::actorOf(document::OrganId organ) const {
  const auto found = shown_.find(organ);
  return found == shown_.end() ? nullptr : found->second.actor;
}

void OrganScene::syncOrgans() {
  bool listChanged = false;
  for (auto found = shown_.begin(); found != shown_.end();) {
    const auto organ = workspace_.document().organ(found->first);
    if (organ && organ->mesh == found->second.organ->mesh) {
      ++found;
      continue;
    }
    if (found->second.ghost)
      found->second.ghost->setRenderer(nullptr);
    view_.remove(found->second.actor);
    found = shown_.erase(found);
    listChanged = true;
  }
  for (const auto& organ : workspace_.document().organs()) {
    const auto found = shown_.find(organ->id);
    if (found == shown_.end()) {
      addOrgan(organ);
      listChanged = true;
    } else if (found->second.organ != organ) {
      found->second.organ = organ;
      applyLook(found->second);
    }
  }
  if (listChanged) {
    syncSelection();
    Q_EMIT organsChanged();
  }
  Q_EMIT looksApplied();
  Q_EMIT changed();
}

void OrganScene::addOrgan(const std::shared_ptr<const document::Organ>& organ) {
  Shown& shown = shown_[organ->id];
  shown.organ = organ;
  shown.actor = std::make_shared<scene::OrganActor>(organ->mesh);
  shown.actor->setPoints(lookAt(workspace_.live().points(organ->id)));
  applyLook(shown);
  view_.add(shown.actor);
  syncGhosts();
}

void OrganScene::applyLook(Shown& shown) {
  const document::OrganLook& look = shown.organ->look;
  shown.actor->setColor(look.color);
  shown.actor->setVertexColorsShown(look.vertexColors);
  shown.actor->setOpacity(look.opacity);
  if (!suspended_)
    shown.actor->setVisible(look.visible);
  if (shown.ghost)
    shown.ghost->setVisible(ghostShown_ && look.visible);
}

void OrganScene::onLive(const live::LiveEvent& event) {
  const auto found = shown_.find(event.organ);
  // Of another surface this part may have to hear yet; what shows the last one is about to go.
  const auto organ = workspace_.document().organ(event.organ);
  if (found == shown_.end() || !organ || organ->mesh != found->second.organ->mesh)
    return;
  if (event.replaced)
    found->second.actor->setPoints(lookAt(workspace_.live().points(event.organ)));
  else if (event.moved)
    found->second.actor->pointsChanged();
  if (event.status || event.replaced)
    syncInfluence();
  if (event.moved || event.replaced)
    Q_EMIT changed();
}

void OrganScene::syncSelection() {
  const document::OrganId selected = workspace_.selection().organ();
  for (auto& [id, shown] : shown_)
    shown.actor->setSelected(id == selected);
  Q_EMIT changed();
}

void OrganScene::setGhostShown(bool shown) {
  ghostShown_ = shown;
  syncGhosts();
}

void OrganScene::setGhostColor(const Vec3& color) {
  ghostColor_ = color;
  for (auto& [id, shown] : shown_)
    if (shown.ghost)
      shown.ghost->setColor(color);
}

void OrganScene::syncGhosts() {
  for (auto& [id, shown] : shown_) {
    if (ghostShown_ && !shown.ghost) {
      shown.ghost = std::make_unique<scene::GhostOutline>(shown.organ->mesh);
      shown.ghost->setColor(ghostColor_);
      shown.ghost->setRenderer(view_.renderer());
    }
    if (shown.ghost)
      shown.ghost->setVisible(ghostShown_ && shown.organ->look.visible);
  }
  Q_EMIT changed();
}

void OrganScene::setInfluenceShown(bool shown) {
  influenceShown_ = shown;
  syncInfluence();
}

void OrganScene::setSuspended(bool suspended) {
  if (suspended == suspended_)
    return;
  suspended_ = suspended;
  for (auto& [id, shown] : shown_) {
    shown.actor->hideScalars();
    shown.actor->clearClipPlane();
    applyLook(shown);
  }
  view_.legend().hide();
  syncInfluence();
}

void OrganScene::syncInfluence() {
  if (suspended_)
    return;
  const document::HandleId handle = workspace_.selection().currentHandle();
  const int row = workspace_.document().rig().indexOf(handle);
  const bool show = influenceShown_ && row >= 0;
  const scene::ColorMap map = scene::viridis();
  std::map<document::OrganId, std::shared_ptr<const Values>> influences;
  scene::ValueRange range{0, 0};
  for (const auto& [id, shown] : shown_) {
    // What is drawn may outlive its organ for a moment: the selection can change before this observer hears.
    const bool present = static_cast<bool>(workspace_.document().organ(id));
    Values influence = show && present ? workspace_.live().influence(id, handle) : Values();
    if (influence.size() == 0)
      continue;
    influence *= kPercent;
    if (shown.organ->look.visible)
      range.high = std::max(range.high, influence.maxCoeff());
    influences[id] = std::make_shared<Values>(std::move(influence));
  }
  if (range.high <= 0)
    range.high = kPercent;
  for (auto& [id, shown] : shown_) {
    const auto found = influences.find(id);
    if (found != influences.end())
      shown.actor->showScalars(found->second, map, range);
    else if (shown.actor->scalarsShown())
      shown.actor->hideScalars();
  }
  if (influences.empty())
    view_.legend().hide();
  else
    view_.legend().show(
        tr("Influence of %1").arg(text(workspace_.document().rig().handles[row].label)).toStdString(), "%",
        map, range);
  Q_EMIT changed();
}

} // namespace viscera::app
