#include "window/view/label_scene.h"

#include <algorithm>

namespace viscera::app {

QString labelOf(const document::Organ& organ) {
  if (organ.name == "LV")
    return LabelScene::tr("Left ventricle");
  if (organ.name == "RV")
    return LabelScene::tr("Right ventricle");
  return text(organ.name);
}

std::vector<scene::OrganLabels::Item>
labelItems(const document::Document& document,
           const std::function<std::shared_ptr<const scene::OrganActor>(document::OrganId)>& actorOf) {
  std::vector<scene::OrganLabels::Item> items;
  for (const auto& organ : document.organs()) {
    const auto isInside = [&](const auto& other) { return other->parent == organ->id; };
    const bool full = std::any_of(document.organs().begin(), document.organs().end(), isInside);
    if (auto actor = actorOf(organ->id))
      items.push_back({labelOf(*organ).toStdString(), std::move(actor), full});
  }
  return items;
}

LabelScene::LabelScene(Workspace& workspace, OrganScene& organs, scene::OrganView& view, QObject* parent)
    : QObject(parent), workspace_(workspace), organs_(organs), labels_(view) {
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      sync();
  }));
  connect(&organs, &OrganScene::organsChanged, this, &LabelScene::sync);
  sync();
}

void LabelScene::setShown(bool shown) {
  labels_.setShown(shown);
  Q_EMIT changed();
}

void LabelScene::setTheme(const scene::Theme& theme) {
  labels_.setTheme(theme);
}

void LabelScene::sync() {
  labels_.setItems(
      labelItems(workspace_.document(), [this](document::OrganId organ) { return organs_.actorOf(organ); }));
  Q_EMIT changed();
}

} // namespace viscera::app
