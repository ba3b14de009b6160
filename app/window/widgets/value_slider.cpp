#include "window/widgets/value_slider.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>

#include <algorithm>
#include <cmath>

#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

constexpr int kMarkHeight = 5;
constexpr int kThickness = 3;
constexpr double kNarrowestMark = 3;

} // namespace

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

RangeMark::RangeMark(const QSlider& slider, QWidget* parent) : QWidget(parent), slider_(slider) {
  setFixedHeight(kMarkHeight);
}

void RangeMark::setPart(double from, double to) {
  from_ = std::clamp(from, 0.0, 1.0);
  to_ = std::clamp(to, from_, 1.0);
  update();
}

/// The slider's grip keeps half its length from both ends.
void RangeMark::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const double inset = 0.5 * style()->pixelMetric(QStyle::PM_SliderLength, nullptr, &slider_);
  const double length = width() - 2 * inset;
  const QRectF part(inset + from_ * length, 0, std::max(kNarrowestMark, (to_ - from_) * length), kThickness);
  painter.fillRect(part, palette().color(QPalette::Highlight));
}

ValueSlider::ValueSlider(const QString& name, const Range& range, QWidget* parent)
    : QWidget(parent), range_(range), slider_(new QSlider(Qt::Horizontal, this)),
      field_(new QDoubleSpinBox(this)) {
  auto* grid = makeLayout<QGridLayout>(this);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  auto* label = new QLabel(name, this);
  label->setBuddy(field_);
  field_->setDecimals(range.decimals);
  field_->setSuffix(range.unit);
  field_->setSingleStep(range.step);
  field_->setAlignment(Qt::AlignRight);
  field_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  field_->setKeyboardTracking(false);
  field_->setAccessibleName(name);
  slider_->setAccessibleName(name);
  grid->addWidget(label, 0, 0);
  grid->addWidget(field_, 0, 1, Qt::AlignRight);
  grid->addWidget(slider_, 1, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  setRange(range.minimum, range.maximum);
  connect(slider_, &QSlider::valueChanged, this, [this](int position) {
    const QSignalBlocker quiet(field_);
    field_->setValue(range_.minimum + position * range_.step);
    Q_EMIT valueChanged(field_->value());
    if (!slider_->isSliderDown())
      Q_EMIT valueChosen(field_->value());
  });
  connect(slider_, &QSlider::sliderReleased, this, [this] { Q_EMIT valueChosen(field_->value()); });
  connect(field_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(sliderPosition(value));
    Q_EMIT valueChanged(value);
    Q_EMIT valueChosen(value);
  });
}

double ValueSlider::value() const {
  return field_->value();
}

void ValueSlider::setValue(double value) {
  if (slider_->isSliderDown())
    return;
  const QSignalBlocker quietField(field_);
  const QSignalBlocker quietSlider(slider_);
  field_->setValue(value);
  slider_->setValue(sliderPosition(value));
}

void ValueSlider::setRange(double minimum, double maximum) {
  const QSignalBlocker quietField(field_);
  const QSignalBlocker quietSlider(slider_);
  range_.minimum = minimum;
  range_.maximum = maximum;
  field_->setRange(minimum, maximum);
  slider_->setRange(0, sliderPosition(maximum));
  const int steps = slider_->maximum();
  slider_->setPageStep(std::max(1, steps / 10));
}

void ValueSlider::setRange(const Range& range) {
  const auto same = [this](const Range& other) {
    return other.minimum == range_.minimum && other.maximum == range_.maximum && other.step == range_.step;
  };
  if (slider_->isSliderDown() || same(range))
    return;
  const double present = value();
  range_ = range;
  const QSignalBlocker quietField(field_);
  field_->setDecimals(range.decimals);
  field_->setSuffix(range.unit);
  field_->setSingleStep(range.step);
  setRange(range.minimum, range.maximum);
  setValue(present);
}

void ValueSlider::setNormal(double low, double high) {
  if (!mark_) {
    mark_ = new RangeMark(*slider_, this);
    static_cast<QGridLayout*>(layout())->addWidget(mark_, 2, 0, 1, 2);
  }
  const double length = range_.maximum - range_.minimum;
  mark_->setPart((low - range_.minimum) / length, (high - range_.minimum) / length);
}

int ValueSlider::sliderPosition(double value) const {
  return static_cast<int>(std::lround((value - range_.minimum) / range_.step));
}

} // namespace viscera::app
