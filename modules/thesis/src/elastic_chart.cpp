#include "viscera/thesis/elastic_chart.h"

#include <algorithm>
#include <cmath>

#include "svg_canvas.h"
#include "viscera/core/text.h"

namespace viscera::thesis {
namespace {

constexpr double kNamesWide = 210, kPanelWide = 290, kBetweenPanels = 40, kRowHigh = 22, kFirstRow = 64,
                 kBelowRows = 46;
constexpr auto kBarInk = "#9ec5e8", kMarkInk = "#1f4e79", kTickInk = "#dddddd", kNoteInk = "#777777";

double shareOf(const std::vector<double>& sorted, double part) {
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

std::vector<double> sortedNumbers(std::vector<double> numbers) {
  std::erase_if(numbers, [](double number) { return !std::isfinite(number); });
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// Where numbers from `low` to `high` are on the canvas.
struct ElasticPanel {
  std::string title;
  double left, low, high, step;

  double at(double number) const {
    return left + kPanelWide * std::clamp((number - low) / (high - low), 0.0, 1.0);
  }
};

void drawTicks(SvgCanvas& canvas, const ElasticPanel& panel, double bottom, int digits) {
  canvas.text({panel.left + kPanelWide / 2, kFirstRow - 14}, panel.title, 12, Anchor::middle);
  for (int tick = 0; panel.low + tick * panel.step <= panel.high + 1e-9; ++tick) {
    const double number = panel.low + tick * panel.step, x = panel.at(number);
    canvas.line({x, kFirstRow}, {x, bottom}, {kTickInk, 1, {}, 1});
    canvas.text({x, bottom + 16}, fixed(number, digits), 11, Anchor::middle);
  }
}

void drawNumbers(SvgCanvas& canvas, const ElasticPanel& panel, const std::vector<double>& sorted, double y) {
  if (sorted.empty())
    return;
  canvas.line({panel.at(shareOf(sorted, 0.05)), y}, {panel.at(shareOf(sorted, 0.95)), y},
              {kMarkInk, 1.2, {}, 1});
  const double from = panel.at(shareOf(sorted, 0.25)), to = panel.at(shareOf(sorted, 0.75));
  canvas.rectangle({from, y - 5}, to - from, 10, kBarInk);
  canvas.circle({panel.at(shareOf(sorted, 0.5)), y}, 4, kMarkInk);
}

double orderOf(const ElasticRow& row) {
  const auto sorted = sortedNumbers(row.relative);
  return sorted.empty() ? INFINITY : shareOf(sorted, 0.5);
}

} // namespace

std::string elasticChart(const std::vector<ElasticRow>& rows, const std::string& title) {
  std::vector<ElasticRow> ordered = rows;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const ElasticRow& a, const ElasticRow& b) { return orderOf(a) < orderOf(b); });
  double largest = 100;
  for (const ElasticRow& row : ordered)
    if (const auto sorted = sortedNumbers(row.relative); !sorted.empty())
      largest = std::max(largest, shareOf(sorted, 0.95));
  largest = 25 * std::ceil(largest / 25);
  const double bottom = kFirstRow + kRowHigh * static_cast<double>(ordered.size());
  SvgCanvas canvas(kNamesWide + 2 * kPanelWide + 2 * kBetweenPanels, bottom + kBelowRows);
  canvas.text({canvas.width() / 2, 24}, title, 14, Anchor::middle);
  const ElasticPanel difference{"difference, % of the elastic displacement", kNamesWide, 0, largest, 25};
  const ElasticPanel stress{"rank correlation of the stress", kNamesWide + kPanelWide + kBetweenPanels, -0.5,
                            1, 0.25};
  drawTicks(canvas, difference, bottom, 0);
  drawTicks(canvas, stress, bottom, 2);
  double y = kFirstRow + kRowHigh / 2;
  for (const ElasticRow& row : ordered) {
    canvas.text({kNamesWide - 12, y + 4}, row.name, 11, Anchor::end);
    const auto numbers = sortedNumbers(row.relative);
    if (numbers.empty())
      canvas.text({kNamesWide + 8, y + 4}, "cannot pose these organs", 11, Anchor::start, kNoteInk);
    drawNumbers(canvas, difference, numbers, y);
    drawNumbers(canvas, stress, sortedNumbers(row.spearman), y);
    y += kRowHigh;
  }
  canvas.text({kNamesWide, bottom + 36}, "dot: median of the drags; bar: middle half; line: 5 % to 95 %", 10,
              Anchor::start, kNoteInk);
  return canvas.svg(title);
}

} // namespace viscera::thesis
