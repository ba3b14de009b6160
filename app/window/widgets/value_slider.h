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
  /// Sets the number without telling anybody.
  void setValue(double value);
  void setRange(double minimum, double maximum);
  /// Another range with its own step and digits; the number stays when it is in the range. Nothing happens
  /// while the slider is held.
  void setRange(const Range& range);

  /// Marks the part of the range that is normal, under the slider.
  void setNormal(double low, double high);

Q_SIGNALS:
  /// The user is choosing: at every move of the slider and every number typed.
  void valueChanged(double value);
  /// The user has chosen: the slider was let go or the typing ended.
  void valueChosen(double value);

private:
  int sliderPosition(double value) const;

  Range range_;
  QSlider* slider_;
  QDoubleSpinBox* field_;
  RangeMark* mark_ = nullptr;
};

} // namespace viscera::app
