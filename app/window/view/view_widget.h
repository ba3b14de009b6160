#pragma once

#include <QPointF>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <vtkCallbackCommand.h>
#include <vtkNew.h>

#include "viscera/scene/organ_view.h"
#include "window/style/theme.h"

namespace viscera::app {

/// The widget that shows the 3D view. Renders at most once for all changes within one pass of the event loop,
/// brings what it shows up to date before that (`setContents`), and distinguishes clicks from drags. If a
/// full, smooth frame takes long (`scene::OrganView::isSlow`), a change is first drawn as a quick frame, and
/// the smooth frame follows when nothing has changed for a moment. A click on a side of the orientation cube
/// moves the camera to that side.
class ViewWidget final : public QVTKOpenGLNativeWidget {
  Q_OBJECT

public:
  explicit ViewWidget(QWidget* parent = nullptr);
  ~ViewWidget() override;

  /// The view, up to date.
  scene::OrganView& view();
  /// Sets a function that brings the view up to date with the document; null: none. It is called before each
  /// frame, before each event of mouse or keyboard, and by `view`: neither a reader of the view nor the mouse
  /// meets anything that is out of date.
  void setContents(std::function<void()> bringUpToDate) { contents_ = std::move(bringUpToDate); }
  void setTheme(const Theme& theme);

  /// The surface under a place in the widget, or the nearest one within a few pixels.
  std::optional<scene::SurfacePick> pickNear(const QPointF& place);

  /// Adds a function that is called at a double click. If it returns true, as while the user sets points or
  /// answers a quiz, the double click counts as two clicks. It has to be callable as long as the view is
  /// used.
  void addClickTaker(std::function<bool()> takesClicks) { clickTakers_.push_back(std::move(takesClicks)); }
  /// Whether one of these functions returns true.
  bool hasClickHandler() const;

  /// How long the last frame took to draw, s.
  double frameSeconds() const { return frameSeconds_; }
  /// Whether the picture is final: nothing waits to be drawn, and the last frame was a full one.
  bool atRest() const { return !renderScheduled_ && !smoothFrame_.isActive(); }

public Q_SLOTS:
  /// Brings the view up to date and renders it soon, once.
  void scheduleRender();
  /// Does so now, if anything is waiting to be rendered. A view that is hidden is only brought up to date.
  void renderPending();

Q_SIGNALS:
  /// The left button was pressed and released at one place.
  void clicked(const QPointF& place, Qt::KeyboardModifiers modifiers);
  /// The left button was pressed twice at one place, and no function of `addClickTaker` returned true.
  void doubleClicked(const QPointF& place);
  /// The right button was pressed and released at one place.
  void menuWanted(const QPointF& place);
  /// The mouse is at a place with no button down; `place` is empty when it has left.
  void hovered(const std::optional<QPointF>& place);
  void filesDropped(const QStringList& files);
  void themeChanged();

protected:
  bool event(QEvent* event) override;
  void paintGL() override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void bringUpToDate();
  void onRenderWanted();
  std::optional<scene::StandardView> orientationSideAt(const QPointF& place) const;
  /// Highlights the side of the orientation cube under the mouse, if any.
  void pointAtCube(const std::optional<QPointF>& place);
  /// Handles presses and releases on the orientation cube; returns whether this was one.
  bool pressCube(const QMouseEvent& event);
  bool releaseCube(const QMouseEvent& event);
  void draw(bool quick);

  std::unique_ptr<scene::OrganView> view_;
  std::function<void()> contents_;
  std::vector<std::function<bool()>> clickTakers_;
  QPointF pressed_;
  Qt::MouseButton pressing_ = Qt::NoButton;        ///< The pressed button, until it is released or the mouse
                                                   ///< has moved away.
  std::optional<scene::StandardView> pressedSide_; ///< The pressed side of the orientation cube.
  bool renderScheduled_ = false;
  bool painting_ = false;
  QTimer smoothFrame_; ///< Runs from a quick frame to the full one.
  double frameSeconds_ = 0;
  vtkNew<vtkCallbackCommand> renderWanted_;
  vtkNew<vtkCallbackCommand> frameBegins_;
};

} // namespace viscera::app
