#include "charts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/core/text.h"

namespace viscera::thesis {
namespace {

constexpr auto kGrid = "#e3e3e3";
constexpr auto kFrame = "#555555";
constexpr double kTickText = 11;
constexpr double kLabelText = 12;

double roundStep(double rough) {
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (rough <= factor * power * (1 + 1e-9))
      return factor * power;
  return 10 * power;
}

std::string tickText(double value, double step) {
  if (std::abs(value) < 1e-9 * step)
    return "0";
  std::string text = significant(value, 4);
  if (text.front() == '-')
    text.replace(0, 1, "\xE2\x88\x92"); // A minus, not a hyphen.
  return text;
}

double share(const Axis& axis, double value) {
  if (!axis.logarithmic)
    return (value - axis.low) / (axis.high - axis.low);
  return std::log(std::max(value, axis.low) / axis.low) / std::log(axis.high / axis.low);
}

/// Round numbers within the axis, about `wanted` of them; on a logarithmic one powers of ten.
std::vector<double> ticksOf(const Axis& axis, int wanted) {
  std::vector<double> ticks;
  if (axis.logarithmic) {
    for (double tick = std::pow(10, std::ceil(std::log10(axis.low) - 1e-9)); tick <= axis.high * (1 + 1e-9);
         tick *= 10)
      ticks.push_back(tick);
    return ticks;
  }
  const double step = roundStep((axis.high - axis.low) / wanted);
  for (double number = std::ceil(axis.low / step - 1e-9); number * step <= axis.high + 1e-9 * step; ++number)
    ticks.push_back(number * step);
  return ticks;
}

/// The part of a picture inside the axes: turns numbers into places, and draws grid, ticks and labels.
class ChartFrame {
public:
  ChartFrame(SvgCanvas& canvas, Place corner, double width, double height, Axis x, Axis y)
      : canvas_(canvas), corner_(corner), width_(width), height_(height), x_(std::move(x)), y_(std::move(y)) {
  }

  Place at(double x, double y) const {
    return {corner_.x + width_ * share(x_, x), corner_.y + height_ * (1 - share(y_, y))};
  }

  /// Grid, frame, ticks with numbers and both labels. `xNumbers` is false where bars are named instead.
  void draw(bool xNumbers = true) {
    const double bottom = corner_.y + height_, right = corner_.x + width_;
    const auto yTicks = ticksOf(y_, 6);
    double widest = 0;
    for (const double tick : yTicks) {
      const Place place = at(x_.low, tick);
      const std::string text = tickText(tick, yTicks.size() > 1 ? yTicks[1] - yTicks[0] : 1);
      widest = std::max(widest, widthOf(text, kTickText));
      canvas_.line(place, {right, place.y}, {kGrid, 1, {}, 1});
      canvas_.text({corner_.x - 6, place.y + 4}, text, kTickText, Anchor::end, kFrame);
    }
    const auto xTicks = xNumbers ? ticksOf(x_, 6) : std::vector<double>{};
    for (const double tick : xTicks) {
      const Place place = at(tick, y_.low);
      canvas_.line({place.x, corner_.y}, {place.x, bottom}, {kGrid, 1, {}, 1});
      canvas_.text({place.x, bottom + 16}, tickText(tick, xTicks[1] - xTicks[0]), kTickText, Anchor::middle,
                   kFrame);
    }
    if (!y_.logarithmic && y_.low < 0 && y_.high > 0)
      canvas_.line(at(x_.low, 0), at(x_.high, 0), {kFrame, 1, {}, 1});
    canvas_.line({corner_.x, corner_.y}, {corner_.x, bottom}, {kFrame, 1, {}, 1});
    canvas_.line({corner_.x, bottom}, {right, bottom}, {kFrame, 1, {}, 1});
    canvas_.text({corner_.x + width_ / 2, bottom + 36}, x_.label, kLabelText, Anchor::middle);
    canvas_.text({corner_.x - widest - 18, corner_.y + height_ / 2}, y_.label, kLabelText, Anchor::middle,
                 "#222222", -90);
  }

private:
  SvgCanvas& canvas_;
  Place corner_;
  double width_;
  double height_;
  Axis x_;
  Axis y_;
};

/// The colours of Okabe and Ito, which people with any colour vision tell apart; without its yellow, which is
/// too light for lines.
const std::vector<std::string>& palette() {
  static const std::vector<std::string> colors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#56b4e9", "#e69f00", "#000000"};
  return colors;
}

constexpr double kLeft = 72, kTop = 34, kBottom = 50, kRight = 14;
constexpr double kPlotWidth = 520, kPlotHeight = 300;
constexpr double kTitleText = 13;
constexpr double kLegendText = 11, kLegendRow = 16, kSample = 26;
constexpr double kGroupText = 10.5;

/// The legend's width, its samples included; 0 for no names.
double legendWidth(const std::vector<std::string>& names) {
  double widest = 0;
  for (const std::string& name : names)
    widest = std::max(widest, widthOf(name, kLegendText));
  return widest > 0 ? widest + kSample + 24 : 0;
}

/// Two digits, but no powers of ten for large numbers.
std::string barText(double value) {
  return value >= 100 ? fixed(value, 0) : significant(value, 2);
}

/// A curve may be interrupted: each stretch of numbers by itself.
void drawCurve(SvgCanvas& canvas, const ChartFrame& frame, const Curve& curve) {
  std::vector<Place> stretch;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (std::isfinite(curve.y[i])) {
      stretch.push_back(frame.at(curve.x[i], curve.y[i]));
      continue;
    }
    canvas.polyline(stretch, curve.pen);
    stretch.clear();
  }
  canvas.polyline(stretch, curve.pen);
}

} // namespace

Axis axisAround(std::string label, double low, double high) {
  if (!(high > low))
    high = low + 1;
  const double step = roundStep((high - low) / 5);
  return {std::move(label), std::floor(low / step + 1e-9) * step, std::ceil(high / step - 1e-9) * step,
          false};
}

Pen penFor(std::size_t index) {
  const char* dashes[] = {"", "7 3", "2 3", "9 3 2 3"};
  const std::size_t colors = palette().size();
  return {palette()[index % colors], 1.8, dashes[index / colors % 4], 1};
}

std::string CurveChart::svg() const {
  std::vector<std::string> names;
  for (const Curve& curve : curves)
    if (!curve.name.empty())
      names.push_back(curve.name);
  const double rows = static_cast<double>(names.size()) * kLegendRow;
  const double plotHeight = std::max(kPlotHeight, rows);
  SvgCanvas canvas(kLeft + kPlotWidth + kRight + legendWidth(names), kTop + plotHeight + kBottom);
  canvas.text({kLeft, 20}, title, kTitleText);
  ChartFrame frame(canvas, {kLeft, kTop}, kPlotWidth, plotHeight, x, y);
  frame.draw();
  for (const Curve& curve : curves)
    drawCurve(canvas, frame, curve);
  Place entry{kLeft + kPlotWidth + 18, kTop + 8};
  for (const Curve& curve : curves) {
    if (curve.name.empty())
      continue;
    canvas.line(entry, {entry.x + kSample, entry.y}, curve.pen);
    canvas.text({entry.x + kSample + 6, entry.y + 4}, curve.name, kLegendText);
    entry.y += kLegendRow;
  }
  return canvas.svg(title);
}

std::string BarChart::svg() const {
  double groupWidth = 90;
  std::size_t lines = 1;
  for (const Group& group : groups) {
    lines = std::max(lines, group.name.size());
    for (const std::string& line : group.name)
      groupWidth = std::max(groupWidth, widthOf(line, kGroupText) + 12);
  }
  const double plotWidth = std::max(240.0, groupWidth * static_cast<double>(groups.size()));
  const double named = static_cast<double>(lines) * 14 + 6;
  SvgCanvas canvas(kLeft + plotWidth + kRight + (series.size() > 1 ? legendWidth(series) : 0),
                   kTop + kPlotHeight + named + 14);
  canvas.text({kLeft, 20}, title, kTitleText);
  ChartFrame frame(canvas, {kLeft, kTop}, plotWidth, kPlotHeight,
                   {"", 0, static_cast<double>(groups.size()), false}, y);
  frame.draw(false);
  const double each = plotWidth / static_cast<double>(groups.size());
  const double bar = std::min(34.0, 0.8 * each / static_cast<double>(series.size()));
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const double middle = kLeft + each * (static_cast<double>(g) + 0.5);
    for (std::size_t s = 0; s < groups[g].values.size(); ++s) {
      const double value = groups[g].values[s];
      if (!std::isfinite(value))
        continue;
      const double left = middle + bar * (static_cast<double>(s) - static_cast<double>(series.size()) / 2);
      const double top = frame.at(0, value).y, bottom = kTop + kPlotHeight;
      canvas.rectangle({left + 1, top}, bar - 2, std::max(0.0, bottom - top),
                       palette()[s % palette().size()]);
      canvas.text({left + bar / 2, top - 4}, barText(value), 9, Anchor::middle, "#555555");
    }
    for (std::size_t line = 0; line < groups[g].name.size(); ++line)
      canvas.text({middle, kTop + kPlotHeight + 16 + 14 * static_cast<double>(line)}, groups[g].name[line],
                  kGroupText, Anchor::middle);
  }
  Place entry{kLeft + plotWidth + 18, kTop + 4};
  for (std::size_t s = 0; series.size() > 1 && s < series.size(); ++s, entry.y += kLegendRow) {
    canvas.rectangle(entry, 12, 10, palette()[s % palette().size()]);
    canvas.text({entry.x + 18, entry.y + 9}, series[s], kLegendText);
  }
  return canvas.svg(title);
}

} // namespace viscera::thesis
