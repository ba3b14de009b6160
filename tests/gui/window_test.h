#pragma once

#include <gtest/gtest.h>

#include <QPoint>
#include <QSize>
#include <QTemporaryDir>

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "coarse_samples.h"
#include "viscera/geometry/triangle_mesh.h"
#include "window/main_window.h"
#include "window/view/view_area.h"

namespace viscera::tests {

/// A real window of 1280 x 800 on the display, its picture smaller, with settings of its own and a clock that
/// the test turns.
class WindowTest : public testing::Test {
protected:
  void SetUp() override;
  void TearDown() override;

  /// The coordinate systems that the window offers.
  virtual coordinates::Registry registry() const { return coordinates::builtInRegistry(); }

  /// The size of the view; empty for tests of its size. It is small because the time of the software renderer
  /// depends on the number of pixels, and few tests check the picture.
  virtual std::optional<QSize> viewSize() const { return QSize(480, 360); }

  /// Whether the sample organs have as few triangles as at low resolution, as where no test of the fixture
  /// depends on how fine they are.
  virtual bool coarseSamples() const { return false; }

  app::MainWindow& window() { return *window_; }
  const document::Document& document() { return window_->workspace().document(); }
  app::ViewWidget& view();
  /// Closes the window and makes another one with the same settings.
  void reopenWindow();
  /// Ends the window as it is, without closing it; the test has none any more.
  void endWindow() { window_.reset(); }

  QString path(const QString& name) const { return folder_.filePath(name); }
  /// Writes a sphere of 60 mm radius as a file and returns its name.
  QString sphereFile(const QString& name = QStringLiteral("ball.stl"), double radius = 60);
  /// Opens a file as a user does and waits until its organs are bound.
  void open(const QString& file);

  /// Handles the window's events until `done` or two minutes have passed; says whether it is done.
  bool waitUntil(const std::function<bool()>& done);
  /// Handles events until nothing is being loaded, bound or waiting to be drawn.
  void settle();
  /// Handles what is due now, as a frame does.
  void handleEvents();

  /// The widget of that name; without one the test ends with an exception that names it.
  template <class Widget>
  Widget& find(const char* name) {
    auto* widget = window().findChild<Widget*>(QLatin1String(name));
    if (!widget)
      throw std::runtime_error(std::string("There is no widget ") + name);
    return *widget;
  }
  /// Clicks the picture of a sequence on the page of Play.
  void chooseSequence(const char* id);

  /// Where a point in mm is on the 3D view.
  QPoint onScreen(const Vec3& point);
  Vec3 handleInView(int handle);
  /// Presses the left button, moves in small steps, releases.
  void drag(const QPoint& from, const QPoint& to);
  void click(const QPoint& place);
  /// Presses and releases the left button at both places, so soon after each other that Qt takes the second
  /// press for a double click.
  void clickTwice(const QPoint& first, const QPoint& second);
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
  QString message();

  /// A handle that the mouse can grab now: the one nearest to the middle of the view, or -1.
  int reachableHandle();

  double now_ = 0; ///< The sequences' clock, s.

private:
  QTemporaryDir folder_;
  std::optional<CoarseSamples> coarse_;
  std::unique_ptr<app::Settings> settings_;
  std::unique_ptr<app::MainWindow> window_;
};

} // namespace viscera::tests
