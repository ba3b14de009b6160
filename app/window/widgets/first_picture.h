#pragma once

#include <QPixmap>
#include <QWidget>

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

} // namespace viscera::app
