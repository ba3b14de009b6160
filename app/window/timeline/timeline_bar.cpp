#include "window/timeline/timeline_bar.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/heart/beating_heart.h"
#include "window/style/icon.h"
#include "window/style/language.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {
/// Logical pixels that the strip keeps: without names below it; beside a slider; beside the name of the
/// phase, which stands below a wide strip, too.
constexpr int kNarrowestStrip = 120, kStripBesideSlider = 200, kStripBesidePhase = 360;
} // namespace

void showRate(QSpinBox& box, const sequences::Sequence& sequence, double ratePerMinute) {
  const QSignalBlocker quiet(&box);
  const int shown = static_cast<int>(std::lround(ratePerMinute));
  box.setSpecialValueText({});
  box.setRange(std::min(shown, static_cast<int>(std::ceil(sequence.lowestRatePerMinute()))),
               std::max(shown, static_cast<int>(std::floor(sequence.highestRatePerMinute()))));
  box.setValue(shown);
  box.setEnabled(box.minimum() < box.maximum());
  const QString unit = TimelineBar::tr("/ min");
  const heart::BeatingHeart* heart = sequence.heart();
  const bool ofCirculation = heart && !heart->textbookBeat(ratePerMinute);
  if (ofCirculation)
    box.setToolTip(TimelineBar::tr("%1: %2 %3. The heart rate of the circulation sets it.")
                       .arg(inWords(sequence.name()))
                       .arg(shown)
                       .arg(unit));
  else
    box.setToolTip(TimelineBar::tr("%1: %2 to %3 %4")
                       .arg(inWords(sequence.name()))
                       .arg(box.minimum())
                       .arg(box.maximum())
                       .arg(unit));
}

TimelineBar::TimelineBar(Playback& playback, Actions& actions, QWidget* parent)
    : QWidget(parent), playback_(playback) {
  setObjectName(QStringLiteral("panel"));
  setAttribute(Qt::WA_StyledBackground);
  addTo(actions);
  auto* row = makeLayout<QHBoxLayout>(this, 4, {8, 4, 12, 4});
  addButton("to_start", tr("To the start of the cycle (Home)"), [this] { seek(0); });
  addButton("step_back", tr("One frame back (,)"), [this] { step(-1); });
  play_ = addButton("play", tr("Play or pause (Space)"), [this] { toggle(); });
  play_->setIconSize(QSize(24, 24));
  play_->setObjectName(QStringLiteral("playButton"));
  addButton("step_forward", tr("One frame forward (.)"), [this] { step(1); });
  loop_ = addButton("loop", tr("Repeat the cycle (L)"), [this](bool on) { setLooping(on); });
  loop_->setCheckable(true);
  row->addSpacing(8);
  addRate();
  row->addSpacing(8);
  auto* strips = makeLayout<QVBoxLayout>(nullptr, 0);
  scrubber_ = new PhaseScrubber(this);
  strips->addWidget(scrubber_);
  signs_ = new BeatStrip(this);
  signs_->hide();
  strips->addWidget(signs_);
  row->addLayout(strips, 1);
  phase_ = new QLabel(this);
  phase_->setObjectName(QStringLiteral("phase"));
  row->addSpacing(8);
  row->addWidget(phase_);
  connect(scrubber_, &PhaseScrubber::scrubbed, this, &TimelineBar::seek);
  connect(&playback, &Playback::stateChanged, this, &TimelineBar::sync);
  connect(&playback, &Playback::advanced, this, &TimelineBar::syncInstant);
  connect(&playback, &Playback::stillPoseChanged, this, &TimelineBar::syncInstant);
  sync();
}

void TimelineBar::addTo(Actions& actions) {
  loopAction_ = actions.addToggle("play.loop", {tr("&Repeat"), "loop", {Qt::Key_L}, tr("Repeat the cycle")},
                                  true, [this](bool on) { setLooping(on); });
  transport_ = {
      actions.add("play.toggle", {tr("&Play or pause"), "play", {Qt::Key_Space}, {}}, [this] { toggle(); }),
      actions.add("play.start", {tr("To the &start"), "to_start", {Qt::Key_Home}, {}}, [this] { seek(0); }),
      actions.add("play.back", {tr("One frame &back"), "step_back", {Qt::Key_Comma}, {}},
                  [this] { step(-1); }),
      actions.add("play.forward", {tr("One frame &forward"), "step_forward", {Qt::Key_Period}, {}},
                  [this] { step(1); }),
      actions.add("play.backFinely",
                  {tr("A fine step bac&k"),
                   "step_back",
                   {tr("Shift+,"), Qt::Key_Less},
                   tr("Go back by ten milliseconds in a heartbeat, by one frame in other sequences")},
                  [this] { step(-1, true); }),
      actions.add("play.forwardFinely",
                  {tr("A fine step for&ward"),
                   "step_forward",
                   {tr("Shift+."), Qt::Key_Greater},
                   tr("Go forward by ten milliseconds in a heartbeat, by one frame in other sequences")},
                  [this] { step(1, true); }),
      loopAction_};
}

template <typename Clicked>
QToolButton* TimelineBar::addButton(const char* iconName, const QString& tip, Clicked clicked) {
  auto* button = makeIconButton(iconName, tip, this, 20);
  layout()->addWidget(button);
  connect(button, &QToolButton::clicked, this, clicked);
  return button;
}

void TimelineBar::addRate() {
  rateSlider_ = new QSlider(Qt::Horizontal, this);
  rateSlider_->setFixedWidth(96);
  rateSlider_->setAccessibleName(tr("Rate"));
  rate_ = new QSpinBox(this);
  rate_->setObjectName(QStringLiteral("rate"));
  rate_->setAccessibleName(tr("Rate"));
  rate_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  rate_->setAlignment(Qt::AlignRight);
  rate_->setKeyboardTracking(false);
  speed_ = new QComboBox(this);
  speed_->setObjectName(QStringLiteral("speed"));
  speed_->setAccessibleName(tr("Speed"));
  speed_->setToolTip(tr("Slow motion: how fast time passes (S)"));
  for (const double speed : kPlaybackSpeeds)
    speed_->addItem(speed == 1 ? tr("1x") : tr("1/%1x").arg(formatNumber(1 / speed, 0)), speed);
  for (QWidget* widget : std::initializer_list<QWidget*>{rateSlider_, rate_, speed_})
    layout()->addWidget(widget);
  connect(rate_, QOverload<int>::of(&QSpinBox::valueChanged), this, [this](int perMinute) {
    const QSignalBlocker quiet(rateSlider_);
    rateSlider_->setValue(perMinute);
    playback_.setRate(perMinute);
  });
  connect(rateSlider_, &QSlider::valueChanged, rate_, &QSpinBox::setValue);
  connect(speed_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int index) { playback_.setSpeed(speed_->itemData(index).toDouble()); });
}

void TimelineBar::sync() {
  const sequences::Sequence* sequence = playback_.sequence();
  for (QAction* action : transport_)
    action->setEnabled(sequence || ofStudy());
  setEnabled(sequence || ofStudy());
  scrubber_->setCourse(sequence ? sequence->course() : std::vector<sequences::NamedPlace>());
  speed_->setCurrentIndex(speed_->findData(playback_.player().speed()));
  if (sequence)
    syncSequence(*sequence);
  else
    clearSequence();
  if (ofStudy())
    syncStudy();
}

void TimelineBar::syncSequence(const sequences::Sequence& sequence) {
  const live::Player& player = playback_.player();
  const QSignalBlocker quietSlider(rateSlider_);
  rate_->setSuffix(QLatin1Char(' ') + tr("/ min"));
  showRate(*rate_, sequence, player.ratePerMinute());
  rateSlider_->setRange(rate_->minimum(), rate_->maximum());
  rateSlider_->setEnabled(rate_->minimum() < rate_->maximum());
  if (const Text remark = sequence.rateRemark(player.ratePerMinute()); !remark.empty())
    rate_->setToolTip(rate_->toolTip() + QLatin1Char('\n') + inWords(remark));
  rateSlider_->setToolTip(rate_->toolTip());
  rateSlider_->setValue(rate_->value());
  play_->setIcon(icon(player.playing() ? "pause" : "play"));
  loop_->setChecked(player.loop());
  loopAction_->setChecked(player.loop());
  const std::vector<sequences::Phase> phases = sequence.phases(player.ratePerMinute());
  int widest = 0;
  for (const sequences::Phase& phase : phases)
    widest =
        std::max(widest, phase_->fontMetrics().horizontalAdvance(phaseText(phase, player.periodSeconds())));
  phase_->setMinimumWidth(widest + 4);
  leaveOut();
  scrubber_->setPhases(phases, player.periodSeconds());
  const heart::BeatingHeart* heart = sequence.heart();
  signs_->setBeat(heart ? heart->textbookBeat(player.ratePerMinute()) : std::nullopt);
  syncSigns();
  syncInstant();
}

/// Shows a hint where sequences are chosen, without a rate or an instant.
void TimelineBar::clearSequence() {
  const QString line = tr("No motion yet: choose a sequence in Play (5)");
  const QSignalBlocker quietRate(rate_), quietSlider(rateSlider_);
  rate_->setSpecialValueText(QStringLiteral("-"));
  rate_->setValue(rate_->minimum());
  rate_->setToolTip(line);
  rateSlider_->setValue(rateSlider_->minimum());
  rateSlider_->setToolTip(line);
  scrubber_->setPhases({{line.toStdString(), 0, 1}}, 0);
  play_->setIcon(icon("play"));
  signs_->setBeat(std::nullopt);
  syncSigns();
  scrubber_->setFraction(0);
  phase_->clear();
  phase_->setToolTip({});
}

/// The study has no rate of its own to choose: its cycle is that of the patient.
void TimelineBar::syncStudy() {
  const QString line = study_->ofScan() ? tr("The phases of the scan: there is no motion yet")
                                        : tr("The images of the cine study: there is no motion yet");
  for (QWidget* widget : std::initializer_list<QWidget*>{rate_, rateSlider_}) {
    widget->setEnabled(false);
    widget->setToolTip(line);
  }
  scrubber_->setPhases({{(study_->ofScan() ? tr("Scan") : tr("Cine study")).toStdString(), 0, 1}},
                       study_->periodSeconds());
  scrubber_->setFraction(study_->fraction());
  play_->setIcon(icon(study_->playing() ? "pause" : "play"));
  loop_->setChecked(study_->loop());
  loopAction_->setChecked(study_->loop());
  phase_->setText(tr("%1 s").arg(formatNumber(study_->fraction() * study_->periodSeconds(), 2)));
}

void TimelineBar::toggle() {
  ofStudy() ? study_->toggle() : playback_.toggle();
}

void TimelineBar::seek(double fraction) {
  ofStudy() ? study_->seek(fraction) : playback_.seek(fraction);
}

/// A picture of the study is its finest step.
void TimelineBar::step(int frames, bool finely) {
  if (ofStudy())
    return study_->step(frames);
  finely ? playback_.stepFinely(frames) : playback_.step(frames);
}

void TimelineBar::setLooping(bool looping) {
  if (study_)
    study_->setLooping(looping);
  playback_.setLooping(looping);
}

void TimelineBar::follow(const ViewModel& view, StudyPlayer& study, const VolumeMonitor& volumes) {
  study_ = &study;
  connect(&study, &StudyPlayer::stateChanged, this, &TimelineBar::sync);
  const auto markEnds = [this, &view, &volumes] {
    const auto line = volumes.measuredLine();
    scrubber_->setEnds(line ? volumes.ends(*line, view.state().cycleEnds) : std::nullopt);
  };
  connect(&view, &ViewModel::changed, this, [this, &view, markEnds] {
    setSignsShown(view.state().beatSigns);
    if (ofStudy())
      syncStudy();
    markEnds();
  });
  for (const auto signal :
       {&VolumeMonitor::updated, &VolumeMonitor::linesChanged, &VolumeMonitor::chosenChanged})
    connect(&volumes, signal, this, markEnds);
  sync();
}

void TimelineBar::syncInstant() {
  const live::Player& player = playback_.player();
  if (const sequences::Sequence* sequence = playback_.sequence())
    scrubber_->setMarks(sequence->travelling(player.secondsInCycle(), player.ratePerMinute()));
  else
    scrubber_->setMarks({});
  scrubber_->setFraction(player.fraction());
  signs_->setFraction(player.fraction());
  phase_->setText(playback_.showing() ? scrubber_->phaseText() : playback_.stillPose());
  phase_->setToolTip(tr("%1 s into the cycle").arg(formatNumber(player.secondsInCycle(), 2)));
}

QSize TimelineBar::minimumSizeHint() const {
  return {widthWith(kNarrowestStrip, false, false), QWidget::minimumSizeHint().height()};
}

void TimelineBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  leaveOut();
}

/// What the bar takes when the strip is that wide, with or without these two.
int TimelineBar::widthWith(int strip, bool slider, bool phase) const {
  const QMargins around = layout()->contentsMargins();
  int wide = around.left() + around.right() + strip;
  for (int i = 0; i < layout()->count(); ++i) {
    QLayoutItem* item = layout()->itemAt(i);
    const QWidget* widget = item->widget();
    if ((widget == rateSlider_ && !slider) || (widget == phase_ && !phase))
      continue;
    wide += layout()->spacing();
    if (widget)
      wide += std::max(widget->sizeHint().width(), widget->minimumWidth());
    else if (item->spacerItem())
      wide += item->sizeHint().width();
  }
  return wide;
}

void TimelineBar::leaveOut() {
  phase_->setVisible(width() >= widthWith(kStripBesidePhase, true, true));
  rateSlider_->setVisible(width() >= widthWith(kStripBesideSlider, true, false));
}

void TimelineBar::setSignsShown(bool shown) {
  if (std::exchange(signsShown_, shown) != shown) // A study that plays changes the view with every frame.
    syncSigns();
}

/// Only the textbook's beat has them; a circulation draws its own. What is shown has the whole window laid
/// out at once, at the chart's expense: without its layout the bar asks for its height later, and the panels
/// keep theirs (`WindowLayout`).
void TimelineBar::syncSigns() {
  layout()->setEnabled(false);
  signs_->setVisible(signsShown_ && signs_->hasBeat());
  layout()->setEnabled(true);
}

} // namespace viscera::app
