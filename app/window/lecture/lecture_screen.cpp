#include "window/lecture/lecture_screen.h"

#include <QAction>
#include <QEvent>
#include <QFontMetrics>
#include <QFrame>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

#include "window/style/language.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

/// How much larger than the window's type the caption and the numbers are.
constexpr double kCaptionFactor = 2.4;
constexpr double kNumbersFactor = 1.8;
/// Rows of numbers that would break are smaller, to so much of that.
constexpr double kLeastNumbers = 0.67;
/// Letters of another size are not wider or narrower by quite the same part.
constexpr double kTypeSlack = 0.98;
constexpr int kCardMargin = 24;
constexpr int kMostVolumes = 5; ///< Of a view: a heart and its chambers.
/// However long a caption is, the view has so much of the screen.
constexpr double kLeastView = 0.5;

} // namespace

LectureScreen::LectureScreen(const Parts& parts, Actions& actions, QObject* parent)
    : QObject(parent), parts_(parts), actions_(actions), strip_(new QWidget(&parts.area)),
      card_(new QFrame(strip_)), caption_(new QLabel(card_)), numbers_(new QLabel(card_)),
      signs_(new LectureSigns({parts.circulation, parts.playback, parts.volumes, parts.view}, strip_)),
      dark_(new QWidget(&parts.area)) {
  makeCard();
  dark_->setObjectName(QStringLiteral("lectureDark"));
  dark_->setAttribute(Qt::WA_StyledBackground);
  dark_->hide();
  shown_ = actions.addToggle(
      "view.lecture",
      {tr("&Lecture"),
       "view",
       {QKeySequence(Qt::Key_F5)},
       tr("The view alone on the whole screen, in large letters; Page Down shows the next slide, "
          "Escape ends it")},
      false, [this](bool on) { on ? begin() : void(end()); });
  darken_ =
      actions.add("lecture.dark", {tr("&Darken the screen"), nullptr, {QKeySequence(Qt::Key_B)}, {}}, [this] {
        dark_->setGeometry(parts_.area.rect());
        dark_->setVisible(dark_->isHidden());
        dark_->raise();
      });
  actions.enableWhile({"lecture.dark"}, [this] { return on(); });
  darken_->setEnabled(false);
  connect(this, &QObject::destroyed, dark_, &QObject::deleteLater);
  connect(&parts_.slides, &Slides::changed, this, &LectureScreen::sync);
  connect(&parts_.volumes, &VolumeMonitor::shown, this, &LectureScreen::sync);
  connect(&parts_.volumes, &VolumeMonitor::linesChanged, this, [this] {
    numbersPart_ = 1;
    sync();
  });
  connect(&parts_.playback, &Playback::stateChanged, this, &LectureScreen::sync);
  connect(signs_, &LectureSigns::wantedChanged, this, [this] {
    height_ = 0;
    sync();
  });
  addSwitches();
  connect(shown_, &QAction::toggled, &actions, &Actions::sync);
}

/// What is shown in the lecture, and in movies as well.
void LectureScreen::addSwitches() {
  using presentation::HeartSigns;
  const auto add = [this](const char* id, const QString& name, bool HeartSigns::*sign) {
    parts_.view.addToggle(actions_, id, {name, nullptr, {}, {}},
                          [sign](presentation::ViewState& state) -> bool& { return state.heartSigns.*sign; });
  };
  add("signs.pressures", tr("&Pressures and volume"), &HeartSigns::pressures);
  add("signs.loops", tr("Pressure-volume &loops"), &HeartSigns::loops);
  add("signs.ecg", tr("&Electrocardiogram"), &HeartSigns::ecg);
  add("signs.valves", tr("Open &valves"), &HeartSigns::valves);
  add("signs.sounds", tr("Heart &sounds"), &HeartSigns::sounds);
}

void LectureScreen::makeCard() {
  card_->setObjectName(QStringLiteral("lectureCard"));
  card_->setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* column = makeLayout<QVBoxLayout>(card_, 2, {kCardMargin, 12, kCardMargin, 12});
  for (QLabel* label : {caption_, numbers_}) {
    label->setAlignment(Qt::AlignCenter);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    column->addWidget(label);
  }
  caption_->setObjectName(QStringLiteral("lectureCaption"));
  numbers_->setObjectName(QStringLiteral("lectureNumbers"));
  embolden(caption_, kCaptionFactor);
  embolden(numbers_, kNumbersFactor);
  numbersPointSize_ = numbers_->font().pointSizeF();
  strip_->setObjectName(QStringLiteral("lectureStrip"));
  strip_->setAttribute(Qt::WA_StyledBackground);
  strip_->setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* rows = makeLayout<QVBoxLayout>(strip_, 0);
  rows->addWidget(card_);
  rows->addWidget(signs_);
  strip_->hide();
  parts_.area.installEventFilter(this);
}

void LectureScreen::takeFullStop(bool taken) {
  const QKeySequence fullStop(Qt::Key_Period), b(Qt::Key_B);
  actions_["play.forward"]->setShortcuts(taken ? QList<QKeySequence>{} : QList<QKeySequence>{fullStop});
  darken_->setShortcuts(taken ? QList<QKeySequence>{b, fullStop} : QList<QKeySequence>{b});
}

void LectureScreen::begin() {
  parts_.layout.setBare(true);
  takeFullStop(true);
  shown_->setChecked(true);
  strip_->show();
  parts_.area.messages()->setHeldBack(true);
  signs_->setOn(true);
  if (parts_.slides.current() < 0)
    parts_.slides.show(0);
  else
    parts_.slides.resume();
  sync();
}

bool LectureScreen::end() {
  if (!on())
    return false;
  parts_.layout.setBare(false);
  takeFullStop(false);
  shown_->setChecked(false);
  strip_->hide();
  signs_->setOn(false);
  parts_.area.reserveBelow(0);
  dark_->hide();
  parts_.area.messages()->setHeldBack(false);
  parts_.slides.leave();
  return true;
}

QString LectureScreen::numbers() const {
  QStringList rows = {numbersOf(0)};
  if (parts_.volumes.hasSecond())
    rows << numbersOf(1);
  rows.removeAll(QString());
  return rows.join(QLatin1Char('\n'));
}

/// None for a second view without a volume.
const Playback* LectureScreen::playbackOf(int side) const {
  const auto& lines = parts_.volumes.lines();
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].side == side)
      return &parts_.volumes.playbackOf(i);
  return side == 0 ? &parts_.playback : nullptr;
}

QString LectureScreen::numbersOf(int side) const {
  const Playback* playback = playbackOf(side);
  return rowOf(side,
               playback && playback->player().showing() ? inWords(playback->player().phase()) : QString());
}

/// The phase and the volumes of one view; of two views with the number that its header has.
QString LectureScreen::rowOf(int side, const QString& phase) const {
  QStringList parts = {phase};
  const auto& lines = parts_.volumes.lines();
  for (const VolumeMonitor::Line& line : lines) {
    if (line.side != side || parts.size() > kMostVolumes)
      continue;
    parts << tr("%1 %2 ml").arg(line.name).arg(formatNumber(line.nowMl, line.nowMl < 1000 ? 1 : 0));
  }
  parts.removeAll(QString());
  if (parts.isEmpty())
    return {};
  if (parts_.volumes.hasSecond())
    parts.front() = VolumeMonitor::tr("%1: %2").arg(side + 1).arg(parts.front());
  constexpr QChar kHyphenThatHolds(0x2011);
  for (QString& part : parts) // A line breaks between them only.
    part.replace(QLatin1Char(' '), QChar::Nbsp).replace(QLatin1Char('-'), kHyphenThatHolds);
  return parts.join(QStringLiteral("   "));
}

/// The row of the phase with the longest name, in pixels of that type.
int LectureScreen::widestRow(int side, const QFontMetrics& type) const {
  const Playback* playback = playbackOf(side);
  if (!playback || !playback->player().showing())
    return type.horizontalAdvance(numbersOf(side));
  QString longest;
  for (const sequences::Phase& phase : playback->sequence()->phases(playback->player().ratePerMinute())) {
    const QString name = inWords(phase.name);
    if (type.horizontalAdvance(name) > type.horizontalAdvance(longest))
      longest = name;
  }
  return type.horizontalAdvance(rowOf(side, longest));
}

/// A row that breaks is hard to read, and a type that changes from phase to phase as well.
void LectureScreen::fitNumbers() {
  QFont type = numbers_->font();
  type.setPointSizeF(numbersPointSize_);
  const QFontMetrics metrics(type, numbers_);
  const int room = parts_.area.width() - 2 * kCardMargin;
  const int widest = std::max(widestRow(0, metrics), parts_.volumes.hasSecond() ? widestRow(1, metrics) : 0);
  if (widest > room)
    numbersPart_ = std::clamp(kTypeSlack * room / widest, kLeastNumbers, numbersPart_);
  type.setPointSizeF(numbersPart_ * numbersPointSize_);
  if (type != numbers_->font())
    numbers_->setFont(type);
}

void LectureScreen::sync() {
  if (!on())
    return;
  const int slide = parts_.slides.current();
  const auto& slides = parts_.slides.all();
  const QString caption =
      slide < 0 ? QString() : QString::fromStdString(slides[static_cast<std::size_t>(slide)].caption);
  if (caption != caption_->text())
    height_ = 0;
  caption_->setText(caption);
  caption_->setVisible(!caption_->text().isEmpty());
  numbers_->setText(numbers());
  numbers_->setVisible(!numbers_->text().isEmpty());
  fitNumbers();
  placeCard();
}

bool LectureScreen::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &parts_.area && event->type() == QEvent::Resize && on()) {
    height_ = 0;
    numbersPart_ = 1;
    fitNumbers();
    placeCard();
  }
  return QObject::eventFilter(watched, event);
}

/// Where numbers need fewer lines than those before, the strip stays: the view would tremble with them.
void LectureScreen::placeCard() {
  const QSize area = parts_.area.size();
  card_->setVisible(!caption_->text().isEmpty() || !numbers_->text().isEmpty());
  card_->layout()->invalidate();
  card_->updateGeometry(); // The labels' news would get there with the next events.
  const int most = static_cast<int>((1 - kLeastView) * area.height());
  const int words = card_->isHidden() ? 0
                    : card_->layout()->hasHeightForWidth()
                        ? card_->layout()->totalHeightForWidth(area.width())
                        : card_->layout()->totalSizeHint().height();
  signs_->fitInto(area.height(), most - words);
  QLayout& column = *strip_->layout();
  const int needed =
      column.hasHeightForWidth() ? column.totalHeightForWidth(area.width()) : column.totalSizeHint().height();
  height_ = std::min(std::max(height_, needed), most);
  strip_->setGeometry(0, area.height() - height_, area.width(), height_);
  parts_.area.reserveBelow(height_);
}

} // namespace viscera::app
