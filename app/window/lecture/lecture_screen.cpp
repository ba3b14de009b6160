#include "window/lecture/lecture_screen.h"

#include <QAction>
#include <QFrame>
#include <QLabel>
#include <QVBoxLayout>

#include "window/language.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

/// How much larger than the window's type the caption and the numbers are.
constexpr double kCaptionFactor = 2.4;
constexpr double kNumbersFactor = 1.8;
constexpr std::size_t kMostVolumes = 5; ///< A heart and its chambers.
/// Logical pixels beside and below the card, where the view has its orientation cube and its scale bar.
constexpr int kCorner = static_cast<int>(scene::kLectureTypeScale * 104);
constexpr int kScaleBar = static_cast<int>(scene::kLectureTypeScale * 36);

} // namespace

LectureScreen::LectureScreen(const Parts& parts, Actions& actions, QObject* parent)
    : QObject(parent), parts_(parts), card_(new QFrame(&parts.area)), caption_(new QLabel(card_)),
      numbers_(new QLabel(card_)), dark_(new QWidget(&parts.area)) {
  card_->setObjectName(QStringLiteral("lectureCard"));
  card_->setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* column = makeLayout<QVBoxLayout>(card_, 2, {24, 12, 24, 12});
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
  auto* room = new QWidget(&parts_.area);
  room->setAttribute(Qt::WA_TransparentForMouseEvents);
  // However wide its margins are, the view and the panels beside it keep their sizes.
  room->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  makeLayout<QVBoxLayout>(room, 0, {kCorner, 0, kCorner, kScaleBar})->addWidget(card_);
  parts_.area.addCard(room, Qt::AlignBottom | Qt::AlignHCenter);
  room->hide();
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
  QAction* dark =
      actions.add("lecture.dark", {tr("&Darken the screen"), nullptr, {QKeySequence(Qt::Key_B)}, {}}, [this] {
        dark_->setGeometry(parts_.area.rect());
        dark_->setVisible(dark_->isHidden());
        dark_->raise();
      });
  actions.enableWhile({"lecture.dark"}, [this] { return on(); });
  dark->setEnabled(false);
  connect(this, &QObject::destroyed, dark_, &QObject::deleteLater);
  connect(&parts_.slides, &Slides::changed, this, &LectureScreen::sync);
  connect(&parts_.volumes, &VolumeMonitor::shown, this, &LectureScreen::sync);
  connect(&parts_.playback, &Playback::stateChanged, this, &LectureScreen::sync);
  connect(shown_, &QAction::toggled, &actions, &Actions::sync);
}

void LectureScreen::begin() {
  parts_.layout.setBare(true);
  shown_->setChecked(true);
  card_->parentWidget()->show();
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
  shown_->setChecked(false);
  card_->parentWidget()->hide();
  dark_->hide();
  parts_.slides.leave();
  return true;
}

QString LectureScreen::numbers() const {
  QStringList parts;
  const motion::Player& player = parts_.playback.player();
  if (player.showing())
    parts << inWords(player.phase());
  const auto& lines = parts_.volumes.lines();
  for (std::size_t i = 0; i < std::min(lines.size(), kMostVolumes); ++i)
    parts
        << tr("%1 %2 ml").arg(lines[i].name).arg(formatNumber(lines[i].nowMl, lines[i].nowMl < 1000 ? 1 : 0));
  parts.removeAll(QString());
  for (QString& part : parts) // A line breaks between them only.
    part.replace(QLatin1Char(' '), QChar::Nbsp);
  return parts.join(QStringLiteral("   "));
}

void LectureScreen::sync() {
  if (!on())
    return;
  const int slide = parts_.slides.current();
  const auto& slides = parts_.slides.all();
  caption_->setText(slide < 0 ? QString()
                              : QString::fromStdString(slides[static_cast<std::size_t>(slide)].caption));
  caption_->setVisible(!caption_->text().isEmpty());
  numbers_->setText(numbers());
  numbers_->setVisible(!numbers_->text().isEmpty());
}

} // namespace viscera::app
