#include "window/measure/measure_scene.h"

namespace viscera::app {

QString formatMeasured(document::MeasurementKind kind, double value) {
  return kind == document::MeasurementKind::distance
             ? MeasureScene::tr("%1 mm").arg(value, 0, 'f', 1)
             : QStringLiteral("%1%2").arg(value, 0, 'f', 1).arg(QChar(0xb0));
}

namespace {

document::PointsOf pointsNow(Workspace& workspace) {
  return [&workspace](document::OrganId organ) -> const Points& { return workspace.live().points(organ); };
}

} // namespace

document::MeasuredValues measuredNow(Workspace& workspace, const document::Measurement& measurement) {
  return document::measure(measurement, workspace.state(), pointsNow(workspace));
}

std::vector<scene::MeasurementGlyphs::Item> measurementItems(const document::DocumentState& state,
                                                             const document::PointsOf& pointsOf) {
  std::vector<scene::MeasurementGlyphs::Item> items;
  for (const document::Measurement& measurement : *state.measurements) {
    document::MeasuredValues values = document::measure(measurement, state, pointsOf);
    const QString value = formatMeasured(kindOf(measurement), values.now);
    items.push_back({std::move(values.places),
                     MeasureScene::tr("%1: %2").arg(text(measurement.name), value).toStdString(), false});
  }
  return items;
}

MeasureScene::MeasureScene(Workspace& workspace, const MeasureTool& tool, scene::MeasurementGlyphs& glyphs,
                           QObject* parent)
    : QObject(parent), workspace_(workspace), tool_(tool), glyphs_(glyphs) {
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.measurements() || change.organs())
      sync();
  }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent& event) {
    if (event.moved || event.replaced)
      sync();
  }));
  connect(&tool, &MeasureTool::changed, this, &MeasureScene::sync);
  sync();
}

void MeasureScene::setShown(bool shown) {
  glyphs_.setShown(shown);
  Q_EMIT changed();
}

void MeasureScene::setTheme(const scene::Theme& theme) {
  glyphs_.setTheme(theme);
  Q_EMIT changed();
}

bool MeasureScene::highlighted(std::size_t index) const {
  const auto hovered = tool_.hovered();
  return workspace_.document().measurements()[index].id == tool_.chosen() ||
         (hovered && hovered->item == index);
}

void MeasureScene::sync() {
  std::vector<scene::MeasurementGlyphs::Item> items =
      measurementItems(workspace_.state(), pointsNow(workspace_));
  for (std::size_t i = 0; i < items.size(); ++i)
    items[i].highlighted = highlighted(i);
  document::Measurement pending;
  pending.points = tool_.pending();
  if (!pending.points.empty()) {
    scene::MeasurementGlyphs::Item item;
    item.highlighted = true;
    // Of an angle the first leg has no value yet.
    const bool distance = tool_.kind() == document::MeasurementKind::distance;
    if (pending.points.size() == 1) {
      pending.points.push_back(pending.points.front());
      item.points = {measuredNow(workspace_, pending).places.front()};
    } else {
      document::MeasuredValues values = measuredNow(workspace_, pending);
      item.points = std::move(values.places);
      if (distance || item.points.size() == 3)
        item.text = formatMeasured(kindOf(pending), values.now).toStdString();
    }
    items.push_back(std::move(item));
  }
  if (items.empty() && glyphs_.items().empty())
    return;
  glyphs_.setItems(std::move(items));
  Q_EMIT changed();
}

} // namespace viscera::app
