#include "window/view/view_widget.h"

#include <QCoreApplication>
#include <QDragEnterEvent>
#include <QElapsedTimer>
#include <QMimeData>
#include <QMouseEvent>
#include <QUrl>

#include <algorithm>
#include <cmath>
#include <utility>

#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include "window/style/language.h"
#include "window/widgets/click_distance.h"

namespace viscera::app {
namespace {

/// Logical pixels around the cursor in which a surface is looked for.
constexpr double kNearDistances[] = {0, 6, 12};
/// The priority of an observer that comes before those of the view.
constexpr float kBeforeOthers = 1;
/// ms without a new frame, until the quick one is replaced by a smooth one.
constexpr int kPause = 120;

QStringList localFiles(const QMimeData* data) {
  QStringList files;
  for (const QUrl& url : data->urls())
    if (url.isLocalFile())
      files.push_back(url.toLocalFile());
  return files;
}

} // namespace

ViewWidget::ViewWidget(QWidget* parent)
    : QVTKOpenGLNativeWidget(parent), view_(std::make_unique<scene::OrganView>()) {
  view_->setDecimalMark(decimalMark());
  setObjectName(QStringLiteral("view3d"));
  setAcceptDrops(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(160, 120);
  // VTK grabs them and does nothing with them; a tap that is held when its view closes has no target left.
  for (const Qt::GestureType gesture : {Qt::TapGesture, Qt::TapAndHoldGesture, Qt::SwipeGesture})
    ungrabGesture(gesture);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  setRenderWindow(window);
  view_->setWindow(window);
  view_->setInteractor(interactor());
  // VTK's interaction asks to render within a press and within a release: it, too, gets the next frame.
  interactor()->EnableRenderOff();
  renderWanted_->SetClientData(this);
  renderWanted_->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<ViewWidget*>(self)->onRenderWanted(); });
  interactor()->AddObserver(vtkCommand::RenderEvent, renderWanted_);
  // Also where a picture of the window is saved.
  frameBegins_->SetClientData(this);
  frameBegins_->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<ViewWidget*>(self)->bringUpToDate(); });
  window->AddObserver(vtkCommand::StartEvent, frameBegins_, kBeforeOthers);
  smoothFrame_.setSingleShot(true);
  connect(&smoothFrame_, &QTimer::timeout, this, [this] {
    if (isVisible() && !view_->moving()) // Code that ends a motion schedules the next frame.
      draw(false);
  });
}

ViewWidget::~ViewWidget() {
  interactor()->RemoveObserver(renderWanted_);
  renderWindow()->RemoveObserver(frameBegins_);
  view_->setInteractor(nullptr);
  view_->setWindow(nullptr);
}

scene::OrganView& ViewWidget::view() {
  bringUpToDate();
  return *view_;
}

void ViewWidget::bringUpToDate() {
  if (contents_)
    contents_();
}

/// VTK's widgets pick what is under the mouse.
bool ViewWidget::event(QEvent* event) {
  switch (event->type()) {
  case QEvent::MouseButtonPress:
  case QEvent::MouseButtonRelease:
  case QEvent::MouseButtonDblClick:
  case QEvent::MouseMove:
  case QEvent::Wheel:
  case QEvent::KeyPress:
    bringUpToDate();
    break;
  default:
    break;
  }
  return QVTKOpenGLNativeWidget::event(event);
}

void ViewWidget::setTheme(const Theme& theme) {
  view_->setTheme(viewThemeOf(theme));
  scheduleRender();
  Q_EMIT themeChanged();
}

std::optional<scene::SurfacePick> ViewWidget::pickNear(const QPointF& place) {
  const double ratio = devicePixelRatioF();
  constexpr int kDirections = 8;
  for (const double distance : kNearDistances) {
    for (int i = 0; i < (distance > 0 ? kDirections : 1); ++i) {
      const double angle = 2 * M_PI * i / kDirections;
      const QPointF there = place + distance * QPointF(std::cos(angle), std::sin(angle));
      if (auto pick = view().pick(ratio * there.x(), ratio * (height() - 1 - there.y())))
        return pick;
    }
  }
  return std::nullopt;
}

void ViewWidget::scheduleRender() {
  if (renderScheduled_)
    return;
  renderScheduled_ = true;
  QTimer::singleShot(0, this, &ViewWidget::renderPending);
}

void ViewWidget::renderPending() {
  if (!renderScheduled_)
    return;
  bringUpToDate();
  renderScheduled_ = false;
  if (isVisible())
    draw(view_->isSlow());
}

/// Renders at once within a paint event, for example at a new size; otherwise after the pending events.
void ViewWidget::onRenderWanted() {
  if (painting_)
    draw(view_->isSlow());
  else
    scheduleRender();
}

void ViewWidget::paintGL() {
  painting_ = true;
  QVTKOpenGLNativeWidget::paintGL();
  painting_ = false;
}

void ViewWidget::draw(bool quick) {
  QElapsedTimer timer;
  timer.start();
  renderScheduled_ = false;
  view_->setFastDrawing(quick);
  renderWindow()->Render();
  view_->setFastDrawing(false);
  frameSeconds_ = 1e-9 * static_cast<double>(timer.nsecsElapsed());
  if (quick)
    smoothFrame_.start(kPause);
  else
    smoothFrame_.stop();
}

std::optional<scene::StandardView> ViewWidget::orientationSideAt(const QPointF& place) const {
  const double ratio = devicePixelRatioF();
  return view_->orientationSideAt(ratio * place.x(), ratio * (height() - 1 - place.y()));
}

void ViewWidget::pointAtCube(const std::optional<QPointF>& place) {
  const auto side = place ? orientationSideAt(*place) : std::nullopt;
  if (!view_->highlightOrientationSide(side))
    return;
  side ? setCursor(Qt::PointingHandCursor) : unsetCursor();
  scheduleRender();
}

bool ViewWidget::pressCube(const QMouseEvent& event) {
  if (event.button() == Qt::LeftButton)
    pressedSide_ = orientationSideAt(event.localPos());
  return pressedSide_.has_value();
}

bool ViewWidget::releaseCube(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || !pressedSide_)
    return false;
  const auto pressed = std::exchange(pressedSide_, std::nullopt);
  if (orientationSideAt(event.localPos()) == pressed) {
    view_->lookFrom(*pressed);
    scheduleRender();
  }
  return true;
}

void ViewWidget::mousePressEvent(QMouseEvent* event) {
  if (pressCube(*event))
    return;
  pressing_ = event->button();
  pressed_ = event->localPos();
  Q_EMIT hovered(std::nullopt);
  QVTKOpenGLNativeWidget::mousePressEvent(event);
}

void ViewWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (releaseCube(*event))
    return;
  QVTKOpenGLNativeWidget::mouseReleaseEvent(event);
  if (std::exchange(pressing_, Qt::NoButton) != event->button())
    return;
  const QPointF moved = event->localPos() - pressed_;
  if (std::hypot(moved.x(), moved.y()) > kClickDistance)
    return;
  if (event->button() == Qt::LeftButton)
    Q_EMIT clicked(event->localPos(), event->modifiers());
  else if (event->button() == Qt::RightButton)
    Q_EMIT menuWanted(event->localPos());
}

bool ViewWidget::hasClickHandler() const {
  return std::any_of(clickTakers_.begin(), clickTakers_.end(), [](const auto& takes) { return takes(); });
}

/// A double click on the orientation cube, where the first press has moved the camera, or while a function of
/// `addClickTaker` returns true, is handled as a second press, also by the event filters of
/// this widget.
void ViewWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !orientationSideAt(event->localPos()) && !hasClickHandler()) {
    QVTKOpenGLNativeWidget::mouseDoubleClickEvent(event);
    Q_EMIT doubleClicked(event->localPos());
    return;
  }
  QMouseEvent press(QEvent::MouseButtonPress, event->localPos(), event->windowPos(), event->screenPos(),
                    event->button(), event->buttons(), event->modifiers(), event->source());
  QCoreApplication::sendEvent(this, &press);
}

void ViewWidget::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton)
    pointAtCube(event->localPos());
  QVTKOpenGLNativeWidget::mouseMoveEvent(event);
  if (event->buttons() == Qt::NoButton)
    Q_EMIT hovered(event->localPos());
}

void ViewWidget::leaveEvent(QEvent* event) {
  pointAtCube(std::nullopt);
  QVTKOpenGLNativeWidget::leaveEvent(event);
  Q_EMIT hovered(std::nullopt);
}

void ViewWidget::dragEnterEvent(QDragEnterEvent* event) {
  if (!localFiles(event->mimeData()).isEmpty())
    event->acceptProposedAction();
}

void ViewWidget::dropEvent(QDropEvent* event) {
  const QStringList files = localFiles(event->mimeData());
  if (files.isEmpty())
    return;
  event->acceptProposedAction();
  Q_EMIT filesDropped(files);
}

} // namespace viscera::app
