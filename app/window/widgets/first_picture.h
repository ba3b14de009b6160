#pragma once

#include <QPixmap>
#include <QSplashScreen>
#include <QWidget>

#include <memory>

#include "window/style/theme.h"

namespace viscera::app {

/// A picture of an organ over the view while a worker makes the organ, so that a window is never empty. It
/// takes no clicks, and is as large as the organ will be.
class FirstPicture final : public QWidget {
  Q_OBJECT

public:
  explicit FirstPicture(QWidget* parent);

  /// The picture of a sample organ; hides it where there is none of it.
  void showSample(const QString& name);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  QPixmap picture_;
};

/// Puts the picture of a sample organ on the screen, since making a window takes longer than half a second.
/// It goes when the caller lets it go. Null for a sample without a picture.
std::unique_ptr<QSplashScreen> showStartPicture(const QString& sample, const Theme& theme);

} // namespace viscera::app
