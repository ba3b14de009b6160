#include "window/lecture/lecture_signs.h"

#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/heart/beating_heart.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {
/// Pixels below which nothing of the charts can be read.
constexpr int kLeastCharts = 140;
constexpr int kSignsMargin = 16;
} // namespace

LectureSigns::LectureSigns(const Parts& parts, QWidget* parent)
    : QWidget(parent), parts_(parts), strip_(new BeatStrip(this)) {
  setObjectName(QStringLiteral("lectureSigns"));
  makeLayout<QVBoxLayout>(this, 0, {kSignsMargin, 0, kSignsMargin, 4})->addWidget(strip_);
  hide();
  connect(&parts.circulation, &CirculationModel::changed, this, &LectureSigns::sync);
  connect(&parts.view, &ViewModel::changed, this, &LectureSigns::sync);
  connect(&parts.playback, &Playback::stateChanged, this, &LectureSigns::sync);
  connect(&parts.playback, &Playback::advanced, this, &LectureSigns::showInstant);
}

void LectureSigns::setOn(bool on) {
  on_ = on;
  sync();
}

void LectureSigns::setTheme(const Theme& theme) {
  theme_ = theme;
  if (charts_)
    charts_->setTheme(theme);
}

LectureSigns::Drawn LectureSigns::wanted() const {
  const presentation::HeartSigns& signs = parts_.view.state().heartSigns;
  if (!on_)
    return Drawn::nothing;
  if (parts_.circulation.on() && parts_.circulation.present())
    return signs.anyOfCirculation() ? Drawn::circulation : Drawn::nothing;
  return strip_->hasBeat() && signs.anyOfTextbook() ? Drawn::textbook : Drawn::nothing;
}

void LectureSigns::makeCharts() {
  charts_ = new CirculationCharts(parts_.circulation, parts_.playback, parts_.volumes, this);
  charts_->setTheme(theme_);
  layout()->addWidget(charts_);
}

void LectureSigns::sync() {
  const presentation::HeartSigns& signs = parts_.view.state().heartSigns;
  if (on_) {
    const sequences::Sequence* sequence = parts_.playback.sequence();
    const heart::BeatingHeart* heart = sequence ? sequence->heart() : nullptr;
    strip_->setBeat(heart ? heart->textbookBeat(parts_.playback.player().ratePerMinute()) : std::nullopt);
    strip_->setSigns(signs);
  }
  drawn_ = wanted();
  if (drawn_ == Drawn::circulation && !charts_)
    makeCharts();
  strip_->setVisible(drawn_ == Drawn::textbook);
  if (charts_) {
    charts_->setSigns(signs);
    charts_->setVisible(drawn_ == Drawn::circulation);
  }
  showInstant();
  if (std::exchange(toldDrawn_, drawn_) != drawn_ || std::exchange(toldSigns_, signs) != signs)
    Q_EMIT wantedChanged();
}

void LectureSigns::showInstant() {
  if (drawn_ == Drawn::textbook)
    strip_->setFraction(parts_.playback.player().fraction());
}

void LectureSigns::fitInto(int screenHeight, int room) {
  int height = 0;
  if (drawn_ == Drawn::circulation) {
    const int part = static_cast<int>(std::lround(presentation::kCirculationSignsPart * screenHeight));
    height = std::min(part, room);
    if (height < kLeastCharts)
      height = 0;
  } else if (drawn_ == Drawn::textbook) {
    const double usual = strip_->drawing().height(1);
    const double most = std::min(presentation::kMostBeatSignsPart * screenHeight, double(room)) - 4;
    const double scale = std::min(scene::kLectureTypeScale, most / usual);
    strip_->setScale(std::max(scale, 1.0));
    height = scale < 1 ? 0 : strip_->sizeHint().height() + 4;
  }
  setVisible(height > 0);
  if (height > 0)
    setFixedHeight(height);
}

} // namespace viscera::app
