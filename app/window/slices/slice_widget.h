#pragma once

#include <QVTKOpenGLNativeWidget.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "viscera/scene/slice_view.h"
#include "window/style/theme.h"

class QLabel;

namespace viscera::app {

/// A widget that shows one slice of a scan. It reports mouse gestures as signals, in pixels of the slice's
/// picture, and changes nothing itself. Renders at most once for all that changed since the event loop last
/// came round.
class SliceWidget final : public QVTKOpenGLNativeWidget {
  Q_OBJECT

public:
  explicit SliceWidget(QWidget* parent = nullptr);
  ~SliceWidget() override;

  /// Takes the picture that is shown from the next frame on.
  void setPicture(const scene::SlicePicture& picture);
  void setTheme(const Theme& theme);
  /// What is written beside the lower edge: value, place and organ under the cursor.
  void setReading(const QString& text);
  QString reading() const;

  /// Asks at every press of the left button whether somebody takes hold of what is there: its moves are then
  /// told as `gripDragged`, and its end as `gripReleased`.
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
  /// The crosshair is to come here: a click, or a drag that began on it.
  void crossWanted(const Eigen::Vector2d& pixel);
  /// So many logical pixels further to the right and upwards, with the left button.
  void windowDragged(const QPointF& by);
  /// The same with the middle button, or with Shift.
  void panDragged(const QPointF& by);
  /// The same with the right button, from where it went down; the wheel with Ctrl.
  void zoomWanted(double factor, const Eigen::Vector2d& around);
  /// Turns of the wheel.
  void scrolled(double steps);
  void gripDragged(const Eigen::Vector2d& pixel);
  void gripReleased(const Eigen::Vector2d& pixel, bool moved);
  void doubleClicked();
  /// The right button was pressed and released at one place, on the screen.
  void menuWanted(const QPoint& place);
  /// The mouse is at a pixel with no button down; it has left when there is none.
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
  std::optional<Eigen::Vector2d> cross_;
  QLabel* reading_;
  std::function<bool(const Eigen::Vector2d&, Qt::KeyboardModifiers)> grips_;
  Drag drag_ = Drag::none;
  QPointF pressed_, last_;
  bool moved_ = false;
  bool renderScheduled_ = false;
};

} // namespace viscera::app
