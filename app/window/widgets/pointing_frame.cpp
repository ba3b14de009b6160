#include "window/widgets/pointing_frame.h"

#include <QEvent>
#include <QPainter>
#include <QTimer>

namespace viscera::app {
namespace {
constexpr int kFrameWidth = 3; ///< Logical pixels.
} // namespace

PointingFrame::PointingFrame(QWidget& target) : QWidget(target.window()), target_(&target) {
  setObjectName(QStringLiteral("pointingFrame"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  target.installEventFilter(this);
  parentWidget()->installEventFilter(this);
  follow();
}

PointingFrame::~PointingFrame() = default;

bool PointingFrame::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
  case QEvent::Move:
  case QEvent::Resize:
  case QEvent::Show:
  case QEvent::Hide:
  case QEvent::LayoutRequest:
    QTimer::singleShot(0, this, &PointingFrame::follow); // Once layouts have done what they do now.
    break;
  default:
    break;
  }
  return QWidget::eventFilter(watched, event);
}

void PointingFrame::follow() {
  if (!target_ || !target_->isVisible() || target_->window() != parentWidget()) {
    hide();
    return;
  }
  const QRect around(target_->mapTo(parentWidget(), QPoint(0, 0)), target_->size());
  setGeometry(around.intersected(parentWidget()->rect()));
  // The framed widget stays visible and is drawn as before.
  setMask(QRegion(rect()) - QRegion(rect().adjusted(kFrameWidth, kFrameWidth, -kFrameWidth, -kFrameWidth)));
  show();
  raise();
}

void PointingFrame::paintEvent(QPaintEvent* /*event*/) {
  QPainter(this).fillRect(rect(), palette().color(QPalette::Highlight));
}

} // namespace viscera::app
