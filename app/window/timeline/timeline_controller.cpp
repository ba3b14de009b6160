#include "window/timeline/timeline_controller.h"

#include <QAction>

namespace viscera::app {

TimelineController::TimelineController(Playback& playback, TimelineBar& bar, Actions& actions,
                                       QObject* parent)
    : QObject(parent), playback_(playback), bar_(bar) {
  addTo(actions);
  connectBar();
  connect(&playback, &Playback::stateChanged, this, &TimelineController::sync);
  connect(&playback, &Playback::advanced, this, &TimelineController::syncInstant);
  sync();
}

void TimelineController::addTo(Actions& actions) {
  loop_ = actions.addToggle("play.loop", {tr("&Repeat"), "loop", {Qt::Key_L}, tr("Repeat the cycle")}, true,
                            [this](bool on) { playback_.setLooping(on); });
  transport_ = {actions.add("play.toggle", {tr("&Play or pause"), "play", {Qt::Key_Space}, {}},
                            [this] { playback_.toggle(); }),
                actions.add("play.start", {tr("To the &start"), "to_start", {Qt::Key_Home}, {}},
                            [this] { playback_.toStart(); }),
                actions.add("play.back", {tr("One frame &back"), "step_back", {Qt::Key_Comma}, {}},
                            [this] { playback_.step(-1); }),
                actions.add("play.forward", {tr("One frame &forward"), "step_forward", {Qt::Key_Period}, {}},
                            [this] { playback_.step(1); }),
                loop_};
}

void TimelineController::connectBar() {
  connect(&bar_, &TimelineBar::playToggled, &playback_, &Playback::toggle);
  connect(&bar_, &TimelineBar::loopToggled, &playback_, &Playback::setLooping);
  connect(&bar_, &TimelineBar::rateChosen, &playback_, &Playback::setRate);
  connect(&bar_, &TimelineBar::speedChosen, &playback_, &Playback::setSpeed);
  connect(&bar_, &TimelineBar::scrubbed, &playback_, &Playback::seek);
  connect(&bar_, &TimelineBar::stepRequested, &playback_, &Playback::step);
  connect(&bar_, &TimelineBar::startRequested, &playback_, &Playback::toStart);
}

void TimelineController::sync() {
  const motion::Player& player = playback_.player();
  const sequences::Sequence* sequence = playback_.sequence();
  for (QAction* action : transport_)
    action->setEnabled(sequence);
  syncCourse();
  if (!sequence)
    return bar_.clearSequence();
  bar_.setSequence(text(sequence->name()), tr("/ min"), sequence->lowestRatePerMinute(),
                   sequence->highestRatePerMinute());
  bar_.setRate(player.ratePerMinute());
  bar_.setPlaying(player.playing());
  bar_.setLooping(player.loop());
  loop_->setChecked(player.loop());
  std::vector<PhaseBand> bands;
  for (const sequences::Phase& phase : sequence->phases(player.ratePerMinute()))
    bands.push_back({text(phase.name), phase.begin, phase.end});
  bar_.setPhases(std::move(bands));
  syncInstant();
}

void TimelineController::syncCourse() {
  std::vector<CoursePlace> course;
  if (const sequences::Sequence* sequence = playback_.sequence())
    for (const sequences::NamedPlace& place : sequence->course())
      course.push_back({text(place.name), place.place});
  bar_.setCourse(std::move(course));
  bar_.setSpeed(playback_.player().speed());
}

void TimelineController::syncInstant() {
  const motion::Player& player = playback_.player();
  std::vector<CourseMark> marks;
  if (const sequences::Sequence* sequence = playback_.sequence())
    for (const auto& mark : sequence->travelling(player.secondsInCycle(), player.ratePerMinute()))
      marks.push_back({mark.place, mark.strength});
  bar_.setMarks(std::move(marks));
  bar_.setInstant(player.fraction(), player.secondsInCycle());
}

} // namespace viscera::app
