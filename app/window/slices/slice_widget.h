#pragma once

#include <QVTKOpenGLNativeWidget.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "viscera/scene/slice_view.h"
#include "viscera/tracking/fit_quality.h"
#include "window/style/theme.h"

class QLabel;

namespace viscera::app {

/// What is said of a slice beside its title, and how far it can be relied upon.
struct SliceVerdict {
  QString words; ///< Empty: nothing.
  tracking::FitLight light = tracking::FitLight::good;
};

/// A widget that shows one slice of a scan. It reports mouse gestures as signals, in pixels of the slice's
/// picture, and changes nothing itself. Renders at most once for all changes within one pass of the event
/// loop, and brings what it shows up to date before that.
class SliceWidget final : public QVTKOpenGLNativeWidget {
  Q_OBJECT

public:
  explicit SliceWidget(QWidget* parent = nullptr);
  ~SliceWidget() override;

  /// Takes the picture that is shown from the next frame on.
  void setPicture(const scene::SlicePicture& picture);
  void setTheme(const Theme& theme);
  /// Sets a function that brings the picture up to date with the document, called before each frame; null:
  /// none.
  void setContents(std::function<void()> bringUpToDate) { contents_ = std::move(bringUpToDate); }
  /// Sets the text at the lower edge: value, place and organ under the cursor.
  void setReading(const QString& text);
  QString reading() const;
  /// Sets the text under the title, amber or red by its light.
  void setVerdict(const SliceVerdict& verdict);
  QString verdict() const;

  /// Sets a function that is called at every press of the left button. If it returns true, the drag is
  /// reported by `gripDragged` and `gripReleased`.
  void setGripper(std::function<bool(const Eigen::Vector2d& pixel, Qt::KeyboardModifiers modifiers)> grips) {
    grips_ = std::move(grips);
  }

  /// Device pixels of the picture, at least 1.
  int pixelWidth() const;
  int pixelHeight() const;
  /// A place in the widget as a pixel of the picture, and back.
  Eigen::Vector2d pixelAt(const QPointF& place) const;
  QPointF placeOf(const Eigen::Vector2d& pixel) const;

public Q_SLOTS:
  void scheduleRender();

Q_SIGNALS:
  void resized();
  /// The user moves the crosshair to this pixel, by a click or by a drag that began on it.
  void crossWanted(const Eigen::Vector2d& pixel);
  /// The user drags with the left button by so many logical pixels to the right and upwards.
  void windowDragged(const QPointF& by);
  /// The same with the middle button, or with Shift.
  void panDragged(const QPointF& by);
  /// The same with the right button, around the place where it was pressed, or the wheel with Ctrl.
  void zoomWanted(double factor, const Eigen::Vector2d& around);
  /// Turns of the wheel.
  void scrolled(double steps);
  void gripDragged(const Eigen::Vector2d& pixel);
  void gripReleased(const Eigen::Vector2d& pixel, bool moved);
  void doubleClicked();
  /// The right button was pressed and released at one place, on the screen.
  void menuWanted(const QPoint& place);
  /// The mouse moves with no button down; `pixel` is empty when it has left.
  void hovered(const std::optional<Eigen::Vector2d>& pixel);

protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  /// What a drag does, until the button is up.
  enum class Drag { none, grip, cross, window, pan, zoom };

  void render();
  void press(QMouseEvent& event);
  void move(QMouseEvent& event);
  void release(QMouseEvent& event);
  void wheel(QWheelEvent& event);
  bool onCross(const QPointF& place) const;
  void placeReading();

  std::unique_ptr<scene::SliceView> view_;
  std::function<void()> contents_;
  std::optional<Eigen::Vector2d> cross_;
  QLabel* reading_;
  QLabel* verdict_;
  std::function<bool(const Eigen::Vector2d&, Qt::KeyboardModifiers)> grips_;
  Drag drag_ = Drag::none;
  QPointF pressed_, last_;
  bool moved_ = false;
  bool renderScheduled_ = false;
};

} // namespace viscera::app
