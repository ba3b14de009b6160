#pragma once

#include <QWidget>

class QSlider;

namespace viscera::app {

/// A thin line under a slider that marks the normal part of its range.
class RangeMark final : public QWidget {
public:
  explicit RangeMark(const QSlider& slider, QWidget* parent = nullptr);

  /// Parts of the slider's range, 0 to 1.
  void setPart(double from, double to);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  const QSlider& slider_;
  double from_ = 0;
  double to_ = 0;
};

} // namespace viscera::app
