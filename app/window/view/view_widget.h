#pragma once

#include <QPointF>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <vtkCallbackCommand.h>
#include <vtkNew.h>

#include "viscera/scene/organ_view.h"
#include "window/style/theme.h"

namespace viscera::app {

/// The widget that shows the 3D view. Renders at most once for all that changed since the event loop last
/// came round, whoever asked for it, and tells a click from a drag. Where a whole, smooth frame takes long
/// (`scene::OrganView::isSlow`), what happens is answered by a quick frame, and the smooth one follows when
/// nothing else has happened for a moment. A click on a side of the orientation cube looks from that side.
class ViewWidget final : public QVTKOpenGLNativeWidget {
  Q_OBJECT

public:
  explicit ViewWidget(QWidget* parent = nullptr);
  ~ViewWidget() override;

  scene::OrganView& view() { return *view_; }
  void setTheme(const Theme& theme);

  /// The surface under a place in the widget, or the nearest one within a few pixels.
  std::optional<scene::SurfacePick> pickNear(const QPointF& place) const;

  /// Adds somebody who is asked at a double click whether each click counts on its own now, as a point or an
  /// answer; two quick ones are two clicks then. Has to be there as long as the view is used.
  void addClickTaker(std::function<bool()> takesClicks) { clickTakers_.push_back(std::move(takesClicks)); }
  /// Whether one of them says so.
  bool clicksAreTaken() const;

  /// How long the last frame took to draw, s.
  double frameSeconds() const { return frameSeconds_; }
  /// Whether what is seen will stay: nothing waits to be drawn, and the last frame was a whole one.
  bool atRest() const { return !renderScheduled_ && !smoothFrame_.isActive(); }

public Q_SLOTS:
  /// Renders soon, once.
  void scheduleRender();
  /// Renders now, if anything is waiting to be rendered.
  void renderPending();

Q_SIGNALS:
  /// The left button was pressed and released at one place.
  void clicked(const QPointF& place, Qt::KeyboardModifiers modifiers);
  /// The left button was pressed twice at one place, where nobody takes clicks (`addClickTaker`).
  void doubleClicked(const QPointF& place);
  /// The right button was pressed and released at one place.
  void menuWanted(const QPointF& place);
  /// The mouse rests or moves at a place with no button down; it has left when there is none.
  void hovered(const std::optional<QPointF>& place);
  void filesDropped(const QStringList& files);
  void themeChanged();

protected:
  void paintGL() override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void onRenderWanted();
  std::optional<scene::StandardView> orientationSideAt(const QPointF& place) const;
  /// Highlights the side of the orientation cube under the mouse, if any.
  void pointAtCube(const std::optional<QPointF>& place);
  /// Presses and releases on the orientation cube are its own; says whether this one is.
  bool pressCube(const QMouseEvent& event);
  bool releaseCube(const QMouseEvent& event);
  void draw(bool quick);

  std::unique_ptr<scene::OrganView> view_;
  std::vector<std::function<bool()>> clickTakers_;
  QPointF pressed_;
  Qt::MouseButton pressing_ = Qt::NoButton;        ///< Until it is released, or has moved away.
  std::optional<scene::StandardView> pressedSide_; ///< Of the orientation cube.
  bool renderScheduled_ = false;
  bool painting_ = false;
  QTimer smoothFrame_; ///< Runs from a quick frame to the whole one.
  double frameSeconds_ = 0;
  vtkNew<vtkCallbackCommand> renderWanted_;
};

} // namespace viscera::app
