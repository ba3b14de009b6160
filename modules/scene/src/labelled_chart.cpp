#include "labelled_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <vtkAxis.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>

#include "chart_pen.h"

namespace viscera::scene {
namespace {

/// Logical pixels.
constexpr double kSample = 16; ///< The piece of line before a name.
constexpr double kCaptionGap = 4;
constexpr double kCaptionStep = 12; ///< From one place of a caption that is tried to the next.
constexpr double kClear = 3;        ///< Beside a caption.
constexpr double kAbove = 1;        ///< Above and below it.
constexpr double kSampleWidth = 2;
/// Names take at most this part of the chart's width.
constexpr double kMostOfWidth = 0.3;
constexpr double kCaptionOpacity = 0.65;
/// How much of the theme's letters is mixed into a curve's colour.
constexpr double kTowardsText = 0.35;

/// The height of the segment's part between two x, lowest and highest; nothing when it is elsewhere.
std::optional<ValueRange> between(const vtkVector2d& a, const vtkVector2d& b, double left, double right) {
  if (!std::isfinite(a.GetY()) || !std::isfinite(b.GetY()) || b.GetX() < left || a.GetX() > right)
    return std::nullopt;
  const double width = b.GetX() - a.GetX();
  const auto at = [&](double x) {
    return width > 0 ? a.GetY() + (b.GetY() - a.GetY()) * (x - a.GetX()) / width : a.GetY();
  };
  const double first = at(std::max(left, a.GetX()));
  const double last = width > 0 ? at(std::min(right, b.GetX())) : b.GetY();
  return ValueRange{std::min(first, last), std::max(first, last)};
}

} // namespace

vtkStandardNewMacro(LabelledChart);

bool LabelledChart::Box::overlaps(const Box& other) const {
  return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
}

void LabelledChart::setLook(const Theme& theme, int fontSize, double ratio) {
  theme_ = theme;
  ratio_ = ratio;
  text_->SetFontSize(fontSize);
  text_->SetJustificationToLeft();
  text_->SetVerticalJustificationToCentered();
}

Vec3 LabelledChart::letters(const Vec3& color, const Theme& theme) {
  return (1 - kTowardsText) * color + kTowardsText * theme.text;
}

vtkVector2d LabelledChart::sizeOf(vtkContext2D* painter, const std::string& text) const {
  float box[4] = {0, 0, 0, 0};
  painter->ApplyTextProp(text_);
  painter->ComputeStringBounds(text, box);
  return {box[2], box[3]};
}

double LabelledChart::mostText() {
  return kMostOfWidth * GetScene()->GetSceneWidth();
}

/// The text with its end left out where it would be too long.
std::string LabelledChart::cut(vtkContext2D* painter, const std::string& text, double most) const {
  if (sizeOf(painter, text).GetX() <= most)
    return text;
  std::string part = text;
  while (!part.empty() && sizeOf(painter, part + "...").GetX() > most) {
    while (!part.empty() && (part.back() & 0xC0) == 0x80) // Whole letters of UTF-8 only.
      part.pop_back();
    if (!part.empty())
      part.pop_back();
  }
  return part + "...";
}

/// The base class asks how much room a legend takes beside each axis; names stand where it would.
int LabelledChart::GetLegendBorder(vtkContext2D* painter, int axisPosition) {
  if (axisPosition != vtkAxis::RIGHT)
    return 0;
  double widest = 0;
  for (const Line& line : lines_)
    widest = std::max(widest, sizeOf(painter, line.name).GetX());
  if (widest == 0)
    return 0;
  return static_cast<int>(std::ceil(std::min(widest, mostText()) + ratio_ * (kSample + 3 * kCaptionGap)));
}

double LabelledChart::pixelOf(double value, int axis) {
  auto* of = GetAxis(axis);
  const double part = (value - of->GetMinimum()) / (of->GetMaximum() - of->GetMinimum());
  const int along = axis == vtkAxis::BOTTOM ? 0 : 1;
  return Point1[along] + part * (Point2[along] - Point1[along]);
}

LabelledChart::Curve LabelledChart::inPixels(const Line& line) {
  const auto* x = vtkDoubleArray::SafeDownCast(line.table->GetColumn(0));
  const auto* y = vtkDoubleArray::SafeDownCast(line.table->GetColumn(1));
  Curve curve;
  for (vtkIdType i = 0; i < line.table->GetNumberOfRows(); ++i)
    curve.emplace_back(pixelOf(x->GetValue(i), vtkAxis::BOTTOM),
                       pixelOf(y->GetValue(i), line.rightAxis ? vtkAxis::RIGHT : vtkAxis::LEFT));
  return curve;
}

bool LabelledChart::Paint(vtkContext2D* painter) {
  const bool painted = Superclass::Paint(painter);
  curves_.clear();
  for (const Line& line : lines_)
    curves_.push_back(inPixels(line));
  drawCaptions(painter);
  drawLabels(painter);
  return painted;
}

/// Puts, from the top down, each label as near to its curve's end as those above leave room for, then up
/// again from the bottom.
void LabelledChart::spread(std::vector<Label>& labels, double height) const {
  std::stable_sort(labels.begin(), labels.end(),
                   [](const Label& a, const Label& b) { return a.end > b.end; });
  const double top = Point2[1] - 0.5 * height, bottom = Point1[1] + 0.5 * height;
  double free = top;
  for (Label& label : labels) {
    label.place = std::min(free, label.end);
    free = label.place - height;
  }
  free = bottom;
  for (auto label = labels.rbegin(); label != labels.rend(); ++label) {
    label->place = std::max(free, label->place);
    free = label->place + height;
  }
}

void LabelledChart::drawLabels(vtkContext2D* painter) {
  std::vector<Label> labels;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto last = std::find_if(curves_[i].rbegin(), curves_[i].rend(),
                                   [](const vtkVector2d& at) { return std::isfinite(at.GetY()); });
    if (last != curves_[i].rend() && !lines_[i].name.empty())
      labels.push_back({&lines_[i], last->GetY(), 0});
  }
  if (labels.empty())
    return;
  const double height = sizeOf(painter, "Ag").GetY() + ratio_;
  // More than there is room for would lie over each other.
  const auto most = static_cast<std::size_t>(std::max(1.0, std::floor((Point2[1] - Point1[1]) / height)));
  labels.resize(std::min(labels.size(), most));
  spread(labels, height);
  const double left =
      GetScene()->GetSceneWidth() - GetLegendBorder(painter, vtkAxis::RIGHT) + ratio_ * kCaptionGap;
  for (const Label& label : labels) {
    drawSample(painter, label, left);
    const Vec3 color = letters(label.line->color, theme_);
    text_->SetColor(color.x(), color.y(), color.z());
    text_->SetOpacity(1);
    painter->ApplyTextProp(text_);
    painter->DrawString(static_cast<float>(left + ratio_ * (kSample + kCaptionGap)),
                        static_cast<float>(label.place), cut(painter, label.line->name, mostText()));
  }
}

/// The curve's own line leads from its end to the name, or stands before it where an axis is between them.
void LabelledChart::drawSample(vtkContext2D* painter, const Label& label, double left) {
  const bool axisBetween = GetAxis(vtkAxis::RIGHT)->GetVisible();
  const Vec3& color = label.line->color;
  const std::array<double, 2> x = {axisBetween ? left : double(Point2[0]), left + ratio_ * kSample};
  const std::array<double, 2> y = {axisBetween ? label.place : label.end, label.place};
  vtkNew<vtkPen> pen;
  pen->SetColor(byteOf(color.x()), byteOf(color.y()), byteOf(color.z()));
  pen->SetWidth(static_cast<float>(ratio_ * (label.line->dots ? 3 * kSampleWidth : kSampleWidth)));
  pen->SetLineType(label.line->dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
  painter->ApplyPen(pen);
  if (label.line->dots)
    painter->DrawPoint(static_cast<float>(0.5 * (x[0] + x[1])), static_cast<float>(y[1]));
  else
    painter->DrawLine(static_cast<float>(x[0]), static_cast<float>(y[0]), static_cast<float>(x[1]),
                      static_cast<float>(y[1]));
}

bool LabelledChart::place(const Caption& caption, const vtkVector2d& size, const std::vector<Box>& taken,
                          Box& box) {
  const int axis = caption.rightAxis ? vtkAxis::RIGHT : vtkAxis::LEFT;
  const double clear = ratio_ * kClear;
  const double low = std::max(double(Point1[1]), pixelOf(caption.range.low, axis));
  const double high = std::min(double(Point2[1]), pixelOf(caption.range.high, axis));
  if (high - low < size.GetY() + 2 * kAbove * ratio_)
    return false;
  const auto isFree = [&](const Box& tried) {
    for (const Curve& curve : curves_)
      for (std::size_t i = 1; i < curve.size(); ++i)
        if (const auto passes = between(curve[i - 1], curve[i], tried.left, tried.right);
            passes && passes->low < tried.top && passes->high > tried.bottom)
          return false;
    return std::none_of(taken.begin(), taken.end(), [&](const Box& other) { return other.overlaps(tried); });
  };
  const auto boxAt = [&](double left, double middle) {
    const double half = 0.5 * size.GetY() + kAbove * ratio_;
    return Box{left - clear, middle - half, left + size.GetX() + clear, middle + half};
  };
  if (const auto was = was_.find(caption.text); was != was_.end()) {
    box = was->second;
    if (box.bottom >= low && box.top <= high && box.right <= Point2[0] && isFree(box))
      return true;
  }
  const double inset = 0.5 * size.GetY() + kAbove * ratio_;
  for (double left = Point1[0] + 2 * clear; left + size.GetX() <= Point2[0] - clear;
       left += ratio_ * kCaptionStep)
    for (const double middle : {0.5 * (low + high), high - inset, low + inset})
      if (box = boxAt(left, middle); isFree(box))
        return true;
  return false;
}

void LabelledChart::drawCaptions(vtkContext2D* painter) {
  std::vector<Box> taken;
  std::map<std::string, Box> stand;
  for (const Caption& caption : captions_) {
    if (caption.text.empty())
      continue;
    Box box;
    if (!place(caption, sizeOf(painter, caption.text), taken, box))
      continue;
    taken.push_back(box);
    stand[caption.text] = box;
    text_->SetColor(theme_.text.x(), theme_.text.y(), theme_.text.z());
    text_->SetOpacity(kCaptionOpacity);
    painter->ApplyTextProp(text_);
    painter->DrawString(static_cast<float>(box.left + ratio_ * kClear),
                        static_cast<float>(0.5 * (box.bottom + box.top)), caption.text);
  }
  was_ = std::move(stand);
}

} // namespace viscera::scene
