#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QSlider;

namespace viscera::app {

class RangeMark;

/// A control for a named number: a slider to try values and a field to type one.
class ValueSlider final : public QWidget {
  Q_OBJECT

public:
  struct Range {
    double minimum = 0;
    double maximum = 1;
    double step = 0.01;
    int decimals = 2;
    QString unit; ///< Behind the number, with its space: " mm".
  };

  ValueSlider(const QString& name, const Range& range, QWidget* parent = nullptr);

  double value() const;
  /// Sets the number without emitting a signal.
  void setValue(double value);
  void setRange(double minimum, double maximum);
  /// Sets the range with its step and digits; the number stays if it is in the range. Nothing happens while
  /// the slider is dragged.
  void setRange(const Range& range);

  /// Marks the part of the range that is normal, under the slider.
  void setNormal(double low, double high);

Q_SIGNALS:
  /// The user changes the value; emitted at every move of the slider and every typed number.
  void valueChanged(double value);
  /// The user has finished changing the value: the slider was released or the typing ended.
  void valueChosen(double value);

private:
  int sliderPosition(double value) const;

  Range range_;
  QSlider* slider_;
  QDoubleSpinBox* field_;
  RangeMark* mark_ = nullptr;
};

} // namespace viscera::app
