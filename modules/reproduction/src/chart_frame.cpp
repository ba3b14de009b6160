#include "chart_frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/core/text.h"

namespace viscera::reproduction {
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

} // namespace

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

Axis axisAround(std::string label, double low, double high) {
  if (!(high > low))
    high = low + 1;
  const double step = roundStep((high - low) / 5);
  return {std::move(label), std::floor(low / step + 1e-9) * step, std::ceil(high / step - 1e-9) * step,
          false};
}

ChartFrame::ChartFrame(SvgCanvas& canvas, Place corner, double width, double height, Axis x, Axis y)
    : canvas_(canvas), corner_(corner), width_(width), height_(height), x_(std::move(x)), y_(std::move(y)) {}

Place ChartFrame::at(double x, double y) const {
  return {corner_.x + width_ * share(x_, x), corner_.y + height_ * (1 - share(y_, y))};
}

void ChartFrame::draw(bool xNumbers) {
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

const std::vector<std::string>& palette() {
  static const std::vector<std::string> colors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#56b4e9", "#e69f00", "#000000"};
  return colors;
}

Pen penFor(std::size_t index) {
  const char* dashes[] = {"", "7 3", "2 3", "9 3 2 3"};
  const std::size_t colors = palette().size();
  return {palette()[index % colors], 1.8, dashes[index / colors % 4], 1};
}

} // namespace viscera::reproduction
