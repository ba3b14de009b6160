#include "charts.h"

#include <algorithm>
#include <cmath>

#include "viscera/core/text.h"

namespace viscera::reproduction {
namespace {

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

} // namespace viscera::reproduction
