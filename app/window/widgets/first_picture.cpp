#include "window/widgets/first_picture.h"

#include <QPainter>

namespace viscera::app {
namespace {

/// Of the view's height: as the camera frames an organ.
constexpr double kPictureOfView = 0.8;

} // namespace

FirstPicture::FirstPicture(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("firstPicture"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  hide();
}

void FirstPicture::showSample(const QString& name) {
  picture_ = QPixmap(QStringLiteral(":/viscera/pictures/sample_%1.png").arg(name));
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

} // namespace viscera::app
