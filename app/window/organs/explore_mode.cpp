#include "window/organs/explore_mode.h"

#include <QAction>
#include <QVBoxLayout>

#include "viscera/document/measurement_commands.h"
#include "window/measure/measure_box.h"
#include "window/measure/resection_box.h"
#include "window/organs/cut_box.h"
#include "window/organs/explore_page.h"
#include "window/quiz/quiz_box.h"
#include "window/quiz/quiz_prompt.h"
#include "window/slices/slice_panes.h"
#include "window/view/view_area.h"
#include "window/view/view_model.h"
#include "window/view/view_widget.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {

using Kind = document::MeasurementKind;

ExploreMode::ExploreMode(const ModeParts& parts, SlicePanes& slices, Actions& actions)
    : Mode(parts, {"explore", "explore", 1, tr("Explore"),
                   tr("Left drag rotates, Shift+left pans, right drag or wheel zooms, click "
                      "selects an organ, D and A measure")}),
      tool_(parts.workspace, *parts.area.view(), parts.picture, parts.handles), slices_(slices),
      onSlices_(tool_, slices), quiz_(parts.workspace, parts.picture) {
  slices.addGrip(onSlices_);
  connect(&tool_, &MeasureTool::changed, this, &ExploreMode::showMeasuring);
  connect(&tool_, &MeasureTool::stateChanged, &actions, &Actions::sync);
  connect(&tool_, &MeasureTool::stateChanged, this, &Mode::hintChanged);
  const QString onBoth = tr("Click two points on an organ or on a slice; Esc ends");
  makeMeasure(actions, Kind::distance, "measure.distance",
              {tr("Measure &distance"), "distance", {Qt::Key_D}, onBoth})
      ->setIconText(tr("Distance"));
  makeMeasure(actions, Kind::angle, "measure.angle",
              {tr("Measure &angle"),
               "angle",
               {Qt::Key_A},
               tr("Click three points on an organ or on a slice, the corner second; Esc ends")})
      ->setIconText(tr("Angle"));
  makeMeasure(
      actions, Kind::rectangle, "measure.rectangle",
      {tr("Measure the values in a &rectangle"),
       "rectangle",
       {tr("Shift+A")},
       tr("Drag on a slice from corner to corner: mean and deviation of the scan's values; Esc ends")})
      ->setIconText(tr("Rectangle"));
  makeMeasure(actions, Kind::sphere, "measure.sphere",
              {tr("Measure the values in a &sphere"),
               "sphere",
               {tr("Shift+B")},
               tr("Drag on a slice from the middle to the border: mean and deviation of the scan's values; "
                  "Esc ends")})
      ->setIconText(tr("Sphere"));
  actions.add("measure.removeAll", {tr("Remove all &measurements"), "remove", {}, {}},
              [this] { workspace_.perform(document::removeAllMeasurements()); });
  actions.enableWhile({"measure.removeAll"},
                      [this] { return !workspace_.document().measurements().empty(); });
  parts.view.addToggle(actions, "view.measurements",
                       {tr("&Measurements"), "distance", {}, tr("Show the measurements")},
                       &presentation::ViewState::measurements);
  addQuiz(actions);
  new QuizPrompt(quiz_, *parts.area.view()); // The view owns it.
  studyFollowed_ = workspace_.onChange([this](const document::Change& change) {
    if (change.study() || change.scan()) // They play in the timeline.
      Q_EMIT panelsChanged();
  });
}

void ExploreMode::addQuiz(Actions& actions) {
  parts_.view.addToggle(actions, "view.parts",
                        {tr("Names of &parts"),
                         "label",
                         {static_cast<int>(Qt::SHIFT) + static_cast<int>(Qt::Key_N)},
                         tr("Name the parts of the organs, such as the apex of the heart")},
                        &presentation::ViewState::partNames);
  QAction* quiz = actions.addToggle(
      "quiz.start",
      {tr("&Quiz on the parts"),
       "label",
       {static_cast<int>(Qt::SHIFT) + static_cast<int>(Qt::Key_Q)},
       tr("Hide the names and ask for one part after the other; answer with a click on the organ")},
      false, [this](bool on) {
        if (!on)
          return quiz_.end();
        Q_EMIT wanted();
        tool_.end();
        quiz_.begin();
      });
  actions.enableWhile({"quiz.start"}, [this] { return quiz_.possible(); });
  actions.onSync([this, quiz] { quiz->setChecked(quiz_.active()); });
  connect(&quiz_, &QuizTool::changed, &actions, &Actions::sync);
  connect(&quiz_, &QuizTool::changed, this, &Mode::hintChanged);
}

void ExploreMode::leave() {
  tool_.setEnabled(false);
  quiz_.end();
}

bool ExploreMode::escape() {
  if (tool_.escape())
    return true;
  if (!quiz_.active())
    return false;
  quiz_.end();
  return true;
}

QAction* ExploreMode::makeMeasure(Actions& actions, Kind kind, const char* id,
                                  const Actions::Description& description) {
  QAction* action = actions.addToggle(id, description, false, [this, kind](bool on) {
    if (on) {
      Q_EMIT wanted();
      parts_.view.change([kind](presentation::ViewState& view) {
        view.measurements = true;
        if (document::isRegion(kind) && view.scan.layout == "3d")
          view.scan.layout = "four";
      });
      tool_.begin(kind);
    } else if (tool_.kind() == kind) {
      tool_.end();
    }
  });
  actions.enableWhile({id}, [this, kind] {
    return workspace_.state().scan || (!document::isRegion(kind) && !workspace_.document().organs().empty());
  });
  actions.onSync([this, action, kind] { action->setChecked(tool_.kind() == kind); });
  return action;
}

/// The plane's controls, and what it leaves of the organs.
QWidget* ExploreMode::makeCut(const Actions& actions) {
  auto* box = new QWidget;
  auto* column = makeLayout<QVBoxLayout>(box, 6);
  column->addWidget(new CutBox(workspace_, parts_.view, *parts_.area.view(), actions, box));
  column->addWidget(new ResectionBox(workspace_, parts_.view, box));
  return box;
}

QWidget* ExploreMode::makePage(const Actions& actions) {
  return new ExplorePage(workspace_, actions, makeCut(actions), new MeasureBox(workspace_, tool_, actions),
                         new QuizBox(actions));
}

QString ExploreMode::hint() const {
  if (quiz_.active())
    return tr("%1. Drags turn the view, Esc ends the quiz")
        .arg(quiz_.question().section(QLatin1Char('\n'), 0, 0));
  if (!measuring())
    return Mode::hint();
  switch (*tool_.kind()) {
  case Kind::distance:
    return tr("Click two points on an organ or on a slice; drags turn the view, Esc ends");
  case Kind::angle:
    return tr(
        "Click three points on an organ or on a slice, the corner second; drags turn the view, Esc ends");
  case Kind::rectangle:
    return tr("Drag on a slice from corner to corner; Esc ends");
  case Kind::sphere:
  case Kind::gap: // Measured without a click.
    break;
  }
  return tr("Drag on a slice from the middle of a sphere to its border; Esc ends");
}

/// Shows the measurement under way, which is in no document yet.
void ExploreMode::showMeasuring() {
  presentation::PendingMeasurement now{{}, tool_.pending()};
  if (tool_.chosen())
    now.highlighted.push_back(tool_.chosen());
  const auto& measurements = workspace_.document().measurements();
  if (const auto hovered = tool_.hovered(); hovered && hovered->item < measurements.size())
    now.highlighted.push_back(measurements[hovered->item].id);
  slices_.setMeasuring(now);
  parts_.picture.setMeasuring(std::move(now));
}

void ExploreMode::click(const ClickedPlace* place) {
  if (!measuring() && !quiz_.click(place))
    Mode::click(place);
}

} // namespace viscera::app
