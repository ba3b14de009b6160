#include "window/timeline/timeline_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

#include <cmath>

#include "window/style/icon.h"

namespace viscera::app {
namespace {
constexpr double kSpeeds[] = {1, 0.5, 0.25, 0.1};
}

TimelineBar::TimelineBar(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("panel"));
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 12, 4);
  row->setSpacing(4);
  start_ = addButton("to_start", tr("To the start of the cycle (Home)"));
  back_ = addButton("step_back", tr("One frame back (,)"));
  play_ = addButton("play", tr("Play or pause (Space)"));
  play_->setIconSize(QSize(24, 24));
  play_->setObjectName(QStringLiteral("playButton"));
  forward_ = addButton("step_forward", tr("One frame forward (.)"));
  loop_ = addButton("loop", tr("Repeat the cycle (L)"));
  loop_->setCheckable(true);
  row->addSpacing(8);
  rateSlider_ = new QSlider(Qt::Horizontal, this);
  rateSlider_->setFixedWidth(96);
  rateSlider_->setAccessibleName(tr("Rate"));
  rate_ = new QSpinBox(this);
  rate_->setObjectName(QStringLiteral("rate"));
  rate_->setAccessibleName(tr("Rate"));
  rate_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  rate_->setAlignment(Qt::AlignRight);
  rate_->setKeyboardTracking(false);
  row->addWidget(rateSlider_);
  row->addWidget(rate_);
  speed_ = new QComboBox(this);
  speed_->setObjectName(QStringLiteral("speed"));
  speed_->setAccessibleName(tr("Speed"));
  speed_->setToolTip(tr("Slow motion: how fast time passes (S)"));
  for (const double speed : kSpeeds)
    speed_->addItem(speed == 1 ? tr("1x") : tr("1/%1x").arg(1 / speed, 0, 'f', 0), speed);
  row->addWidget(speed_);
  row->addSpacing(8);
  scrubber_ = new PhaseScrubber(this);
  row->addWidget(scrubber_, 1);
  phase_ = new QLabel(this);
  phase_->setObjectName(QStringLiteral("phase"));
  row->addWidget(phase_);
  connect(start_, &QToolButton::clicked, this, &TimelineBar::startRequested);
  connect(back_, &QToolButton::clicked, this, [this] { Q_EMIT stepRequested(-1); });
  connect(play_, &QToolButton::clicked, this, &TimelineBar::playToggled);
  connect(forward_, &QToolButton::clicked, this, [this] { Q_EMIT stepRequested(1); });
  connect(loop_, &QToolButton::clicked, this, &TimelineBar::loopToggled);
  connect(scrubber_, &PhaseScrubber::scrubbed, this, &TimelineBar::scrubbed);
  connect(rate_, QOverload<int>::of(&QSpinBox::valueChanged), this, [this](int perMinute) {
    const QSignalBlocker quiet(rateSlider_);
    rateSlider_->setValue(perMinute);
    Q_EMIT rateChosen(perMinute);
  });
  connect(rateSlider_, &QSlider::valueChanged, rate_, &QSpinBox::setValue);
  connect(speed_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int index) { Q_EMIT speedChosen(speed_->itemData(index).toDouble()); });
  clearSequence();
}

QToolButton* TimelineBar::addButton(const char* iconName, const QString& tip) {
  auto* button = new QToolButton(this);
  button->setIcon(icon(iconName));
  button->setIconSize(QSize(20, 20));
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  layout()->addWidget(button);
  return button;
}

void TimelineBar::setSequence(const QString& name, const QString& rateUnit, double lowest, double highest) {
  const QSignalBlocker quietRate(rate_);
  const QSignalBlocker quietSlider(rateSlider_);
  setEnabled(true);
  rate_->setSuffix(QLatin1Char(' ') + rateUnit);
  rate_->setRange(static_cast<int>(std::ceil(lowest)), static_cast<int>(std::floor(highest)));
  rateSlider_->setRange(rate_->minimum(), rate_->maximum());
  rate_->setToolTip(
      tr("%1: %2 to %3 %4").arg(name).arg(rate_->minimum()).arg(rate_->maximum()).arg(rateUnit));
  rateSlider_->setToolTip(rate_->toolTip());
}

void TimelineBar::clearSequence() {
  setEnabled(false);
  scrubber_->setPhases({{tr("No motion here: sample organs bring their own (Organ > Sample organs)"), 0, 1}});
  scrubber_->setCourse({});
  scrubber_->setFraction(0);
  phase_->clear();
}

void TimelineBar::setPhases(std::vector<PhaseBand> phases) {
  int widest = 0;
  for (const PhaseBand& phase : phases)
    widest = std::max(widest, phase_->fontMetrics().horizontalAdvance(phase.name));
  phase_->setMinimumWidth(widest + 4);
  scrubber_->setPhases(std::move(phases));
}

void TimelineBar::setCourse(std::vector<CoursePlace> course) {
  scrubber_->setCourse(std::move(course));
}

void TimelineBar::setMarks(std::vector<CourseMark> marks) {
  scrubber_->setMarks(std::move(marks));
}

void TimelineBar::setSpeed(double speed) {
  speed_->setCurrentIndex(speed_->findData(speed));
}

void TimelineBar::setRate(double perMinute) {
  const QSignalBlocker quietRate(rate_);
  const QSignalBlocker quietSlider(rateSlider_);
  rate_->setValue(static_cast<int>(std::lround(perMinute)));
  rateSlider_->setValue(rate_->value());
}

void TimelineBar::setPlaying(bool playing) {
  play_->setIcon(icon(playing ? "pause" : "play"));
}

void TimelineBar::setLooping(bool looping) {
  loop_->setChecked(looping);
}

void TimelineBar::setInstant(double fraction, double seconds) {
  scrubber_->setFraction(fraction);
  phase_->setText(scrubber_->phaseName());
  phase_->setToolTip(tr("%1 s into the cycle").arg(seconds, 0, 'f', 2));
}

} // namespace viscera::app
