#include "window/play_parts.h"

#include <QAction>
#include <QDesktopServices>
#include <QFileInfo>
#include <QUrl>

#include <algorithm>
#include <cmath>

#include "viscera/document/organ_commands.h"
#include "viscera/motion/sequence_setup.h"
#include "window/panels/play_page.h"
#include "window/status_line.h"
#include "window/timeline/timeline_bar.h"
#include "window/timeline/volume_panel.h"

namespace viscera::app {
namespace {

constexpr double kWallOpacity = 0.28;
/// An organ without cavities hides nothing of its own, only its neighbours.
constexpr double kPlainOpacity = 0.45;
constexpr double kOpaque = 0.99;
constexpr double kSpeeds[] = {1, 0.5, 0.25, 0.1};

bool hasInside(const document::OrganList& organs, document::OrganId id) {
  return std::any_of(organs.begin(), organs.end(), [id](const auto& other) { return other->parent == id; });
}

/// The organs through which one looks: walls of cavities, or all of them when there is none.
std::vector<std::shared_ptr<const document::Organ>> wallsOf(const document::OrganList& organs) {
  std::vector<std::shared_ptr<const document::Organ>> walls;
  std::copy_if(organs.begin(), organs.end(), std::back_inserter(walls),
               [&](const auto& organ) { return hasInside(organs, organ->id); });
  return walls.empty() ? organs : walls;
}

} // namespace

PlayParts::PlayParts(const Window& window)
    : window_(window),
      labels_(std::make_unique<LabelScene>(window.workspace, window.organs, window.area.view()->view())),
      comparison_(std::make_unique<Comparison>(Comparison::First{window.workspace, window.playback,
                                                                 window.volumes, window.area, window.settings,
                                                                 window.organs, window.handles})),
      recorder_(std::make_unique<Recorder>(window.workspace)),
      recorded_(std::make_unique<RecordedMotion>(window.workspace, window.playback)) {
  connect(labels_.get(), &LabelScene::changed, window.area.view(), &ViewWidget::scheduleRender);
  connect(recorder_.get(), &Recorder::finished, this, &PlayParts::sayRecorded);
  subscription_ = window.workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      syncLookActions();
  });
}

PlayParts::~PlayParts() {
  comparison_->end();
  if (status_)
    status_->unwatch(recorder_->jobs());
}

void PlayParts::makeActions(Actions& actions) {
  actions_ = &actions;
  makeLookActions(actions);
  actions.add("play.slower",
              {tr("Slow &motion"), "tour", {Qt::Key_S}, tr("Slower, down to a tenth; then real time again")},
              [this] { slower(); });
  actions.addToggle("play.cycle",
                    {tr("&Chart of one cycle"),
                     "chart",
                     {Qt::Key_O},
                     tr("Draw one cycle with a cursor; else the last seconds")},
                    true, [this](bool on) {
                      if (chart_)
                        chart_->setCycleShown(on);
                    });
  actions.add(
      "play.addKey",
      {tr("Record a &key"), "record", {tr("Ctrl+K")}, tr("Take the present pose into the recorded sequence")},
      [this] { addKey(); });
  actions.add("play.compare",
              {tr("Compare two &rates"),
               "compare",
               {tr("Ctrl+2")},
               tr("The same organs a second time beside these, at another rate")},
              [this] { comparison_->showSameOrgan(); });
  actions.add("play.compareSystems",
              {tr("Compare &coordinates"),
               "compare",
               {tr("Ctrl+3")},
               tr("The same organs and handles a second time beside these, tied by other coordinates")},
              [this] { comparison_->showOtherCoordinates(); });
  actions.add("play.compareFiles",
              {tr("Compare with another &organ..."), "patient", {}, tr("Open files beside these organs")},
              [this] { comparison_->chooseFiles(); });
  actions.add("play.single", {tr("&One view"), nullptr, {tr("Ctrl+1")}, tr("Close the second view")},
              [this] { comparison_->end(); });
  connect(comparison_.get(), &Comparison::toggled, this, [this, &actions](bool on) {
    actions["play.single"]->setEnabled(on);
    if (!status_)
      return;
    if (secondJobs_)
      status_->unwatch(*secondJobs_);
    secondJobs_ = on ? &comparison_->workspace().jobs() : nullptr;
    if (secondJobs_)
      status_->watch(*secondJobs_);
  });
  actions["play.single"]->setEnabled(false);
}

void PlayParts::makeLookActions(Actions& actions) {
  actions.addToggle("view.labels",
                    {tr("Organ &labels"), "label", {Qt::Key_N}, tr("Write names beside the organs")}, false,
                    [this](bool on) {
                      labels_->setShown(on);
                      comparison_->setLabelsShown(on);
                    });
  actions.addToggle(
      "view.seeThrough",
      {tr("See &through"), "see_through", {Qt::Key_X}, tr("Look through the wall at the cavities")}, false,
      [this](bool on) { setSeeThrough(on); });
}

std::vector<const char*> PlayParts::menu() {
  return {"play.addKey",
          "",
          "play.slower",
          "play.cycle",
          "",
          "view.labels",
          "view.seeThrough",
          "",
          "play.compare",
          "play.compareSystems",
          "play.compareFiles",
          "play.single"};
}

PlayPage* PlayParts::makePage(const Actions& actions) {
  return new PlayPage(
      {window_.workspace, window_.playback, window_.volumes, *window_.area.view(), *this, window_.settings},
      actions);
}

void PlayParts::connectPanels(TimelineBar& timeline, VolumePanel& chart, StatusLine& status) {
  chart_ = &chart;
  status_ = &status;
  status.watch(recorder_->jobs());
  Playback& playback = window_.playback;
  connect(&timeline, &TimelineBar::speedChosen, &playback, &Playback::setSpeed);
  const auto syncCourse = [&timeline, &playback] {
    std::vector<CoursePlace> course;
    if (const sequences::Sequence* sequence = playback.sequence())
      for (const sequences::NamedPlace& place : sequence->course())
        course.push_back({text(place.name), place.place});
    timeline.setCourse(std::move(course));
    timeline.setSpeed(playback.player().speed());
  };
  const auto syncMarks = [&timeline, &playback] {
    std::vector<CourseMark> marks;
    const motion::Player& player = playback.player();
    if (const sequences::Sequence* sequence = playback.sequence())
      for (const auto& mark : sequence->travelling(player.secondsInCycle(), player.ratePerMinute()))
        marks.push_back({mark.place, mark.strength});
    timeline.setMarks(std::move(marks));
  };
  connect(&playback, &Playback::stateChanged, this, [syncCourse, syncMarks] {
    syncCourse();
    syncMarks();
  });
  connect(&playback, &Playback::advanced, this, syncMarks);
  syncCourse();
}

void PlayParts::setTheme(const Theme& theme) {
  labels_->setTheme(window_.area.view()->view().theme());
  comparison_->setTheme(theme);
}

void PlayParts::chooseSequence(const QString& id) {
  for (const Playback::Motion& motion : window_.playback.motions()) {
    if (text(motion.sequence->id()) != id)
      continue;
    window_.playback.choose(motion.sequence.get());
    window_.playback.play();
    return;
  }
  for (const motion::SampleSequence& sample : motion::sampleSequences())
    if (text(sample.id) == id)
      window_.samples.load(text(sample.organ), true);
}

bool PlayParts::seesThrough() const {
  const auto walls = wallsOf(window_.workspace.document().organs());
  return !walls.empty() && std::all_of(walls.begin(), walls.end(),
                                       [](const auto& organ) { return organ->look.opacity < kOpaque; });
}

void PlayParts::setSeeThrough(bool on) {
  if (on == seesThrough())
    return;
  const document::OrganList& organs = window_.workspace.document().organs();
  std::vector<document::Command> commands;
  for (const auto& organ : wallsOf(organs)) {
    document::OrganLook look = organ->look;
    look.opacity = !on ? 1 : hasInside(organs, organ->id) ? kWallOpacity : kPlainOpacity;
    commands.push_back(document::setOrganLook(organ->id, look));
  }
  for (const auto& organ : organs) {
    document::OrganLook look = organ->look;
    look.visible = true;
    look.opacity = 1;
    if (on && organ->parent)
      commands.push_back(document::setOrganLook(organ->id, look));
  }
  if (!commands.empty())
    window_.workspace.perform(document::combined(
        (on ? tr("See through") : tr("Close the wall")).toStdString(), std::move(commands)));
  syncLookActions();
}

void PlayParts::syncLookActions() {
  if (!actions_)
    return;
  QAction* action = (*actions_)["view.seeThrough"];
  action->setChecked(seesThrough());
  action->setEnabled(!window_.workspace.document().organs().empty());
}

void PlayParts::slower() {
  const double speed = window_.playback.player().speed();
  const auto* next = std::find_if(std::begin(kSpeeds), std::end(kSpeeds),
                                  [speed](double other) { return other < speed - 1e-9; });
  window_.playback.setSpeed(next == std::end(kSpeeds) ? 1 : *next);
}

void PlayParts::addKey() {
  const double seconds = recorded_->nextSeconds();
  if (recorded_->addKey(seconds, sequences::Easing::smooth))
    window_.area.showBadge(tr("Key at %1 s").arg(seconds, 0, 'f', 2));
}

bool PlayParts::record(const RecordingPlan& plan) {
  const bool labels = labels_->labels().shown();
  std::vector<RecordingStage::Source> sources;
  const bool measurements = actions_ && (*actions_)["view.measurements"]->isChecked();
  sources.push_back({window_.workspace, window_.playback, window_.area.view()->view(), labels, measurements});
  if (comparison_->on())
    sources.push_back(
        {comparison_->workspace(), comparison_->playback(), comparison_->view().view(), labels});
  return recorder_->start(plan, sources);
}

void PlayParts::sayRecorded(bool complete, const RecordingPlan& plan) {
  if (!complete)
    return;
  const QFileInfo file(plan.file);
  Message message;
  message.text = tr("Recorded as %1").arg(plan.file);
  message.seconds = 8;
  message.offers.push_back({tr("Open folder"), [folder = file.absolutePath()] {
                              QDesktopServices::openUrl(QUrl::fromLocalFile(folder));
                            }});
  window_.workspace.say(message);
}

} // namespace viscera::app
