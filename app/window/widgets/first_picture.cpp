#include "window/widgets/first_picture.h"

#include <QApplication>
#include <QPainter>

namespace viscera::app {
namespace {

/// Part of the view's height: as the camera frames an organ.
constexpr double kPictureOfView = 0.8;
constexpr int kStartMargin = 28, kStartLine = 24; ///< px around the picture at the start, and for the name.

QPixmap pictureOf(const QString& sample) {
  return QPixmap(QStringLiteral(":/viscera/pictures/sample_%1.png").arg(sample));
}

} // namespace

FirstPicture::FirstPicture(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("firstPicture"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  hide();
}

void FirstPicture::showSample(const QString& name) {
  picture_ = pictureOf(name);
  setVisible(!picture_.isNull());
}

void FirstPicture::paintEvent(QPaintEvent*) {
  const QSize room(width(), static_cast<int>(kPictureOfView * height()));
  const QSize size = picture_.size().scaled(room, Qt::KeepAspectRatio);
  QRect place(QPoint(0, 0), size);
  place.moveCenter(rect().center());
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawPixmap(place, picture_);
}

std::unique_ptr<QSplashScreen> showStartPicture(const QString& sample, const Theme& theme) {
  const QPixmap organ = pictureOf(sample);
  if (organ.isNull())
    return nullptr;
  QPixmap picture(organ.size() + QSize(2 * kStartMargin, 2 * kStartMargin + kStartLine));
  picture.fill(theme.background);
  QPainter painter(&picture);
  painter.drawPixmap(kStartMargin, kStartMargin, organ);
  painter.setPen(theme.text);
  painter.drawText(picture.rect().adjusted(0, 0, 0, -kStartMargin / 2), Qt::AlignHCenter | Qt::AlignBottom,
                   QApplication::applicationDisplayName());
  painter.end();
  auto screen = std::make_unique<QSplashScreen>(picture);
  screen->show();
  QApplication::processEvents(); // What follows keeps the thread busy.
  return screen;
}

} // namespace viscera::app
