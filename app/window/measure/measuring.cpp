#include "window/measure/measuring.h"

#include <QAction>

#include "viscera/document/measurement_commands.h"
#include "window/measure/measure_box.h"

namespace viscera::app {

Measuring::Measuring(Workspace& workspace, ViewArea& area, OrganScene& organs, HandleScene& handles,
                     std::function<void()> explore, QObject* parent)
    : QObject(parent), workspace_(workspace), area_(area), explore_(std::move(explore)),
      glyphs_(area.view()->view()), tool_(workspace, *area.view(), organs, handles, glyphs_),
      scene_(workspace, tool_, glyphs_) {
  connect(&scene_, &MeasureScene::changed, area.view(), &ViewWidget::scheduleRender);
  connect(&tool_, &MeasureTool::stateChanged, this, [this] {
    syncActions();
    Q_EMIT stateChanged();
  });
  subscription_ = workspace.onChange([this](const document::Change& change) {
    if (change.organs() || change.measurements())
      syncActions();
  });
}

void Measuring::addTo(Actions& actions) {
  using Kind = document::MeasurementKind;
  actions_ = &actions;
  actions.addToggle(
      "measure.distance",
      {tr("Measure &distance"), "distance", {Qt::Key_D}, tr("Click two points on an organ; Esc ends")}, false,
      [this](bool on) { toggle(Kind::distance, on); });
  actions.addToggle("measure.angle",
                    {tr("Measure &angle"),
                     "angle",
                     {Qt::Key_A},
                     tr("Click three points on an organ, the corner second; Esc ends")},
                    false, [this](bool on) { toggle(Kind::angle, on); });
  actions.add("measure.removeAll", {tr("Remove all &measurements"), "remove", {}, {}},
              [this] { workspace_.perform(document::removeAllMeasurements()); });
  actions.addToggle("view.measurements", {tr("&Measurements"), "distance", {}, tr("Show what is measured")},
                    true, [this](bool on) { scene_.setShown(on); });
  actions["measure.distance"]->setIconText(tr("Distance"));
  actions["measure.angle"]->setIconText(tr("Angle"));
  syncActions();
}

MeasureBox* Measuring::makeBox() {
  return new MeasureBox(workspace_, tool_, *actions_);
}

void Measuring::setTheme() {
  scene_.setTheme(area_.view()->view().theme());
}

QString Measuring::hint() const {
  return tool_.kind() == document::MeasurementKind::angle
             ? tr("Click three points on an organ, the corner second; drags turn the view, Esc ends")
             : tr("Click two points on an organ; drags turn the view, Esc ends");
}

void Measuring::toggle(MeasureTool::Kind kind, bool on) {
  if (on) {
    explore_();
    (*actions_)["view.measurements"]->setChecked(true);
    tool_.begin(kind);
  } else if (tool_.kind() == kind) {
    tool_.end();
  }
}

void Measuring::syncActions() {
  if (!actions_)
    return;
  using Kind = document::MeasurementKind;
  const auto check = [this](const char* id, bool on) {
    if ((*actions_)[id]->isChecked() != on)
      (*actions_)[id]->setChecked(on);
  };
  check("measure.distance", tool_.kind() == Kind::distance);
  check("measure.angle", tool_.kind() == Kind::angle);
  const bool organs = !workspace_.document().organs().empty();
  for (const char* id : {"measure.distance", "measure.angle"})
    (*actions_)[id]->setEnabled(organs);
  (*actions_)["measure.removeAll"]->setEnabled(!workspace_.document().measurements().empty());
}

} // namespace viscera::app
