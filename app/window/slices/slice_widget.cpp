#include "window/slices/slice_widget.h"

#include <QLabel>
#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

#include "window/style/language.h"
#include "window/widgets/click_distance.h"

namespace viscera::app {
namespace {

/// The largest distance from a line of the crosshair at which a press grabs it.
constexpr double kCrossReach = 6;
constexpr double kZoomPerPixel = 1.01;
constexpr double kZoomPerStep = 1.15;
constexpr double kWheelStep = 120; ///< Qt: eighths of a degree.
constexpr int kReadingLeft = 8;
/// Above the level and width that stand in the picture.
constexpr int kReadingAbove = 26;
/// The verdict stands under the picture's title, which gives way downward to the letter of its upper edge.
constexpr int kVerdictBelow = 44, kVerdictBelowInLectures = 66;

} // namespace

SliceWidget::SliceWidget(QWidget* parent)
    : QVTKOpenGLNativeWidget(parent), view_(std::make_unique<scene::SliceView>()), reading_(new QLabel(this)),
      verdict_(new QLabel(this)) {
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(120, 90);
  setMouseTracking(true);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  setRenderWindow(window);
  interactor()->SetInteractorStyle(nullptr);
  view_->setWindow(window);
  view_->setDecimalMark(decimalMark());
  reading_->setObjectName(QStringLiteral("sliceReading"));
  reading_->setAttribute(Qt::WA_TransparentForMouseEvents);
  reading_->setStyleSheet(QStringLiteral("background: transparent; color: #e6e8ea;"));
  reading_->hide();
  verdict_->setObjectName(QStringLiteral("sliceVerdict"));
  verdict_->setAttribute(Qt::WA_TransparentForMouseEvents);
  verdict_->move(kReadingLeft, kVerdictBelow);
  verdict_->hide();
}

SliceWidget::~SliceWidget() {
  view_->setWindow(nullptr);
}

void SliceWidget::setPicture(const scene::SlicePicture& picture) {
  cross_ = picture.cross;
  view_->show(picture);
  scheduleRender();
}

void SliceWidget::setTheme(const Theme& theme) {
  view_->setTheme(viewThemeOf(theme));
  verdict_->move(kReadingLeft,
                 theme.lecture ? kVerdictBelowInLectures : kVerdictBelow); // Its title is larger.
  scheduleRender();
}

void SliceWidget::setReading(const QString& text) {
  if (text == reading_->text() && reading_->isVisible() == !text.isEmpty())
    return;
  reading_->setText(text);
  reading_->setVisible(!text.isEmpty());
  placeReading();
}

QString SliceWidget::reading() const {
  return reading_->text();
}

/// Slices are black in every theme, and so have the colours of the dark one.
void SliceWidget::setVerdict(const SliceVerdict& verdict) {
  const bool good = verdict.light == tracking::FitLight::good, red = verdict.light == tracking::FitLight::red;
  // A sign beside the colour, for colour-blind users.
  const QString words = good || verdict.words.isEmpty() ? verdict.words
                        : red                           ? QString::fromUtf8("\u2715 ") + verdict.words
                                                        : QStringLiteral("! ") + verdict.words;
  if (words == verdict_->text())
    return;
  const Theme dark = themeOf(ThemeKind::dark);
  verdict_->setStyleSheet(QStringLiteral("background: transparent; color: %1;")
                              .arg((good  ? QColor("#e6e8ea")
                                    : red ? dark.error
                                          : dark.warning)
                                       .name()));
  verdict_->setText(words);
  verdict_->adjustSize();
  verdict_->setVisible(!words.isEmpty());
}

QString SliceWidget::verdict() const {
  return verdict_->text();
}

void SliceWidget::placeReading() {
  reading_->adjustSize();
  reading_->move(kReadingLeft, height() - kReadingAbove - reading_->height());
}

int SliceWidget::pixelWidth() const {
  return std::max(1, static_cast<int>(std::lround(width() * devicePixelRatioF())));
}

int SliceWidget::pixelHeight() const {
  return std::max(1, static_cast<int>(std::lround(height() * devicePixelRatioF())));
}

Eigen::Vector2d SliceWidget::pixelAt(const QPointF& place) const {
  const double ratio = devicePixelRatioF();
  return {ratio * place.x() - 0.5, pixelHeight() - ratio * place.y() - 0.5};
}

QPointF SliceWidget::placeOf(const Eigen::Vector2d& pixel) const {
  const double ratio = devicePixelRatioF();
  return {(pixel.x() + 0.5) / ratio, (pixelHeight() - pixel.y() - 0.5) / ratio};
}

void SliceWidget::scheduleRender() {
  if (renderScheduled_)
    return;
  renderScheduled_ = true;
  QTimer::singleShot(0, this, &SliceWidget::render);
}

void SliceWidget::render() {
  if (contents_)
    contents_();
  renderScheduled_ = false;
  if (isVisible())
    renderWindow()->Render();
}

void SliceWidget::resizeEvent(QResizeEvent* event) {
  QVTKOpenGLNativeWidget::resizeEvent(event);
  placeReading();
  Q_EMIT resized();
}

/// Mouse and key events are handled here and not passed to VTK.
bool SliceWidget::event(QEvent* event) {
  switch (event->type()) {
  case QEvent::MouseButtonPress:
    press(static_cast<QMouseEvent&>(*event));
    return true;
  case QEvent::MouseMove:
    move(static_cast<QMouseEvent&>(*event));
    return true;
  case QEvent::MouseButtonRelease:
    release(static_cast<QMouseEvent&>(*event));
    return true;
  case QEvent::MouseButtonDblClick:
    press(static_cast<QMouseEvent&>(*event));
    if (drag_ == Drag::grip) // Two quick presses on it.
      return true;
    drag_ = Drag::none;
    if (static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton)
      Q_EMIT doubleClicked();
    return true;
  case QEvent::Wheel:
    wheel(static_cast<QWheelEvent&>(*event));
    return true;
  case QEvent::Leave:
    Q_EMIT hovered(std::nullopt);
    return QWidget::event(event);
  case QEvent::KeyPress:
  case QEvent::KeyRelease:
  case QEvent::Enter:
    return QWidget::event(event);
  default:
    return QVTKOpenGLNativeWidget::event(event);
  }
}

bool SliceWidget::onCross(const QPointF& place) const {
  if (!cross_)
    return false;
  const QPointF from = place - placeOf(*cross_);
  return std::min(std::abs(from.x()), std::abs(from.y())) <= kCrossReach;
}

void SliceWidget::press(QMouseEvent& event) {
  if (drag_ == Drag::grip)
    return; // Another button was pressed during a drag.
  pressed_ = last_ = event.localPos();
  moved_ = false;
  const bool left = event.button() == Qt::LeftButton;
  if (left && grips_ && grips_(pixelAt(pressed_), event.modifiers()))
    drag_ = Drag::grip;
  else if (event.button() == Qt::MiddleButton || (left && event.modifiers().testFlag(Qt::ShiftModifier)))
    drag_ = Drag::pan;
  else if (event.button() == Qt::RightButton)
    drag_ = Drag::zoom;
  else if (left)
    drag_ = onCross(pressed_) ? Drag::cross : Drag::window;
}

void SliceWidget::move(QMouseEvent& event) {
  const QPointF place = event.localPos();
  if (drag_ == Drag::none) {
    Q_EMIT hovered(pixelAt(place));
    return;
  }
  const QPointF all = place - pressed_;
  if (!moved_ && std::hypot(all.x(), all.y()) <= kClickDistance)
    return;
  moved_ = true;
  const QPointF by(place.x() - last_.x(), last_.y() - place.y());
  last_ = place;
  if (drag_ == Drag::grip)
    Q_EMIT gripDragged(pixelAt(place));
  else if (drag_ == Drag::cross)
    Q_EMIT crossWanted(pixelAt(place));
  else if (drag_ == Drag::window)
    Q_EMIT windowDragged(by);
  else if (drag_ == Drag::pan)
    Q_EMIT panDragged(by);
  else
    Q_EMIT zoomWanted(std::pow(kZoomPerPixel, by.y()), pixelAt(pressed_));
}

void SliceWidget::release(QMouseEvent& event) {
  if (drag_ == Drag::grip) {
    if (event.button() != Qt::LeftButton)
      return;
    drag_ = Drag::none;
    Q_EMIT gripReleased(pixelAt(event.localPos()), moved_);
    return;
  }
  const Drag done = std::exchange(drag_, Drag::none);
  if (moved_ || done == Drag::none)
    return;
  if (event.button() == Qt::LeftButton && done != Drag::pan)
    Q_EMIT crossWanted(pixelAt(event.localPos()));
  else if (event.button() == Qt::RightButton)
    Q_EMIT menuWanted(event.globalPos());
}

void SliceWidget::wheel(QWheelEvent& event) {
  const QPoint turned = event.angleDelta();
  const double steps = (turned.y() != 0 ? turned.y() : turned.x()) / kWheelStep;
  if (event.modifiers().testFlag(Qt::ControlModifier))
    Q_EMIT zoomWanted(std::pow(kZoomPerStep, steps), pixelAt(event.position()));
  else
    Q_EMIT scrolled(steps);
}

} // namespace viscera::app
