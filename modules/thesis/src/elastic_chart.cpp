#include "viscera/thesis/elastic_chart.h"

#include <algorithm>
#include <cmath>

#include "svg_canvas.h"
#include "viscera/core/text.h"

namespace viscera::thesis {
namespace {

constexpr double kNames = 210, kPanel = 290, kBetween = 40, kRow = 22, kTop = 64, kBelow = 46;
constexpr auto kBar = "#9ec5e8", kInk = "#1f4e79", kGrid = "#dddddd", kNote = "#777777";

double partOf(const std::vector<double>& sorted, double part) {
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

std::vector<double> sortedNumbers(std::vector<double> numbers) {
  std::erase_if(numbers, [](double number) { return !std::isfinite(number); });
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// Where numbers from `low` to `high` are on the canvas.
struct Panel {
  std::string title;
  double left, low, high, step;

  double at(double number) const {
    return left + kPanel * std::clamp((number - low) / (high - low), 0.0, 1.0);
  }
};

void drawFrame(SvgCanvas& canvas, const Panel& panel, double bottom, int digits) {
  canvas.text({panel.left + kPanel / 2, kTop - 14}, panel.title, 12, Anchor::middle);
  for (int tick = 0; panel.low + tick * panel.step <= panel.high + 1e-9; ++tick) {
    const double number = panel.low + tick * panel.step, x = panel.at(number);
    canvas.line({x, kTop}, {x, bottom}, {kGrid, 1, {}, 1});
    canvas.text({x, bottom + 16}, fixed(number, digits), 11, Anchor::middle);
  }
}

void drawNumbers(SvgCanvas& canvas, const Panel& panel, const std::vector<double>& sorted, double y) {
  if (sorted.empty())
    return;
  canvas.line({panel.at(partOf(sorted, 0.05)), y}, {panel.at(partOf(sorted, 0.95)), y}, {kInk, 1.2, {}, 1});
  const double from = panel.at(partOf(sorted, 0.25)), to = panel.at(partOf(sorted, 0.75));
  canvas.rectangle({from, y - 5}, to - from, 10, kBar);
  canvas.circle({panel.at(partOf(sorted, 0.5)), y}, 4, kInk);
}

double orderOf(const ElasticRow& row) {
  const auto sorted = sortedNumbers(row.relative);
  return sorted.empty() ? INFINITY : partOf(sorted, 0.5);
}

} // namespace

std::string elasticChart(const std::vector<ElasticRow>& rows, const std::string& title) {
  std::vector<ElasticRow> ordered = rows;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const ElasticRow& a, const ElasticRow& b) { return orderOf(a) < orderOf(b); });
  double largest = 100;
  for (const ElasticRow& row : ordered)
    if (const auto sorted = sortedNumbers(row.relative); !sorted.empty())
      largest = std::max(largest, partOf(sorted, 0.95));
  largest = 25 * std::ceil(largest / 25);
  const double bottom = kTop + kRow * static_cast<double>(ordered.size());
  SvgCanvas canvas(kNames + 2 * kPanel + 2 * kBetween, bottom + kBelow);
  canvas.text({canvas.width() / 2, 24}, title, 14, Anchor::middle);
  const Panel difference{"difference, % of the elastic displacement", kNames, 0, largest, 25};
  const Panel stress{"rank correlation of the stress", kNames + kPanel + kBetween, -0.5, 1, 0.25};
  drawFrame(canvas, difference, bottom, 0);
  drawFrame(canvas, stress, bottom, 2);
  double y = kTop + kRow / 2;
  for (const ElasticRow& row : ordered) {
    canvas.text({kNames - 12, y + 4}, row.name, 11, Anchor::end);
    const auto numbers = sortedNumbers(row.relative);
    if (numbers.empty())
      canvas.text({kNames + 8, y + 4}, "cannot pose these organs", 11, Anchor::start, kNote);
    drawNumbers(canvas, difference, numbers, y);
    drawNumbers(canvas, stress, sortedNumbers(row.spearman), y);
    y += kRow;
  }
  canvas.text({kNames, bottom + 36}, "dot: median of the drags; bar: middle half; line: 5 % to 95 %", 10,
              Anchor::start, kNote);
  return canvas.svg(title);
}

} // namespace viscera::thesis
