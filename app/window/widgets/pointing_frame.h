#pragma once

#include <QPointer>
#include <QWidget>

namespace viscera::app {

/// A coloured frame that draws attention to a widget, as during the tour. It moves with the widget, is hidden
/// while the widget is, and ignores clicks.
class PointingFrame final : public QWidget {
  Q_OBJECT

public:
  /// The target may be destroyed first.
  explicit PointingFrame(QWidget& target);
  ~PointingFrame() override;

  QWidget* target() const { return target_; }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  void follow();

  QPointer<QWidget> target_;
};

} // namespace viscera::app
