#include "viscera/scene/volume_chart.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkPlotPoints.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkWeakPointer.h>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/scene/legend.h"
#include "viscera/scene/organ_view.h"

#include "chart_pen.h"
#include "labelled_chart.h"
#include "text_guard.h"

namespace viscera::scene {
namespace {

constexpr double kDefaultSpan = 10;
constexpr float kCurveWidth = 2;
constexpr float kChartCursorWidth = 1.5;
constexpr float kChartDotSize = 7; ///< Across, pixels.
constexpr unsigned char kBandAlpha = 36;
/// Bands may make the axis so many times as long as the curves do, but always as long as from zero.
constexpr double kBandsStretch = 1.5;
constexpr int kChartFontSize = 12;
/// Room above and below the curves, as a part of their range.
constexpr double kChartRoom = 0.08;
/// Curves that vary by less of their value are drawn flat: what is left of a locked volume is rounding.
constexpr double kFlat = 1e-3;
constexpr int kMostChartTicks = 6;
/// A chart that is lower, in logical pixels, has no title below it and fewer numbers beside it: the curves
/// need the room.
constexpr double kLowChart = 170;
constexpr int kMostTicksOfALowChart = 4;
/// VTK's numbers for the pair of axes that a plot is drawn against.
constexpr int kBottomLeft = 0, kBottomRight = 1;
constexpr std::array kAxes = {vtkAxis::BOTTOM, vtkAxis::LEFT, vtkAxis::RIGHT};

/// Takes out numbers that stand alone between gaps: a single point is no line, and VTK warns about it on
/// every picture. Whether two neighbours are left.
bool leaveLinesOnly(double* values, std::size_t count) {
  bool any = false, before = false; // Whether the value before is a number.
  for (std::size_t i = 0; i < count; ++i) {
    const bool here = std::isfinite(values[i]), after = i + 1 < count && std::isfinite(values[i + 1]);
    any = any || (here && after);
    if (here && !before && !after)
      values[i] = std::numeric_limits<double>::quiet_NaN();
    before = here;
  }
  return any;
}

void addColumn(vtkTable* table, const std::string& name) {
  vtkNew<vtkDoubleArray> column;
  column->SetName(name.c_str());
  table->AddColumn(column);
}

/// Both ends of a plot that has two points.
void setRow(vtkTable* table, vtkIdType row, std::initializer_list<double> values) {
  vtkIdType column = 0;
  for (const double value : values)
    vtkDoubleArray::SafeDownCast(table->GetColumn(column++))->SetValue(row, value);
}

/// A horizontal band across a chart: what is normal. (vtkPlotArea draws nothing for two points.)
class NormalBand : public vtkPlot {
public:
  static NormalBand* New();
  vtkTypeMacro(NormalBand, vtkPlot)

      /// Where it is, in the units of the axes.
      void setExtent(ValueRange x, ValueRange y);
  bool Paint(vtkContext2D* painter) override;
  void GetBounds(double bounds[4]) override;

private:
  ValueRange x_;
  ValueRange y_;
};

vtkStandardNewMacro(NormalBand);

void NormalBand::setExtent(ValueRange x, ValueRange y) {
  x_ = x;
  y_ = y;
  Modified();
}

bool NormalBand::Paint(vtkContext2D* painter) {
  if (!GetVisible())
    return false;
  const vtkRectd shiftScale = GetShiftScale();
  const double left = (x_.low + shiftScale.GetX()) * shiftScale.GetWidth();
  const double bottom = (y_.low + shiftScale.GetY()) * shiftScale.GetHeight();
  painter->ApplyPen(Pen);
  painter->ApplyBrush(Brush);
  painter->DrawRect(static_cast<float>(left), static_cast<float>(bottom),
                    static_cast<float>((x_.high - x_.low) * shiftScale.GetWidth()),
                    static_cast<float>((y_.high - y_.low) * shiftScale.GetHeight()));
  return true;
}

void NormalBand::GetBounds(double bounds[4]) {
  bounds[0] = x_.low;
  bounds[1] = x_.high;
  bounds[2] = y_.low;
  bounds[3] = y_.high;
}

/// One curve, its band, and the tables that VTK draws them from.
struct Curve {
  ChartLine line;
  std::vector<double> values;
  std::optional<std::vector<double>> ownTimes; ///< Else those that all curves have in common.
  vtkPlot* plot = nullptr;
  std::vector<vtkSmartPointer<NormalBand>> bands;
  vtkNew<vtkTable> table;
};

int cornerOf(const Curve& curve) {
  return curve.line.rightAxis ? kBottomRight : kBottomLeft;
}

} // namespace

struct VolumeChart::Parts {
  char decimalMark = '.';
  std::string xTitle, xUnit;
  vtkNew<vtkRenderer> renderer;
  vtkNew<ChartActor> actor;
  vtkNew<LabelledChart> chart;
  vtkWeakPointer<vtkRenderWindow> window;
  Theme theme = lightTheme();
  std::vector<std::unique_ptr<Curve>> curves;
  std::vector<double> times;
  double span = kDefaultSpan;
  std::optional<ValueRange> fixedRange;
  std::optional<double> cursor;
  vtkNew<vtkTable> cursorTable;
  vtkPlot* cursorPlot = nullptr;

  void build();
  void applyTheme();
  void makePlots();
  void forgetBefore(double seconds);
  ValueRange timeRange() const;
  /// Range of the curves at the left axis, or at the right one.
  ValueRange valueRange(bool right) const;
  /// Range of the curves with as much of their bands as does not flatten them.
  ValueRange withBands(ValueRange curves, bool right) const;
  void fillCurve(Curve& curve, ValueRange range);
  void fillCursor(ValueRange values);
  /// Whether the chart is too low for a title below it.
  bool isLow() const;
  void fillAxis(int which, ValueRange range);
  /// Has the chart write the names of the curves that are seen, and the captions of their bands.
  void nameCurves(double ratio);
};

bool VolumeChart::Parts::isLow() const {
  return window && window->GetSize()[1] < kLowChart * pixelRatioOf(window);
}

/// The last number at the bottom of a low chart has the unit, which the title has otherwise.
void VolumeChart::Parts::fillAxis(int which, ValueRange range) {
  const bool low = isLow(), bottom = which == vtkAxis::BOTTOM;
  auto* axis = chart->GetAxis(which);
  axis->SetRange(range.low, range.high);
  const auto ticks = niceTicks(range, low && !bottom ? kMostTicksOfALowChart : kMostChartTicks);
  const double spacing = ticks.size() > 1 ? ticks[1] - ticks[0] : 0;
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (const double tick : ticks) {
    const bool last = tick == ticks.back();
    positions->InsertNextValue(tick);
    labels->InsertNextValue(tickLabel(tick, spacing, decimalMark) +
                            (low && bottom && last && !xUnit.empty() ? " " + xUnit : std::string()));
  }
  axis->SetCustomTickPositions(positions, labels);
}

void VolumeChart::Parts::build() {
  chart->SetAutoSize(true);
  chart->SetShowLegend(false); // Names stand at the curves.
  chart->SetRenderEmpty(true);
  for (const int which : kAxes) {
    auto* axis = chart->GetAxis(which);
    axis->SetBehavior(vtkAxis::FIXED);
    axis->GetLabelProperties()->SetFontSize(kChartFontSize);
    axis->GetTitleProperties()->SetFontSize(kChartFontSize);
    axis->GetTitleProperties()->BoldOff();
  }
  chart->GetAxis(vtkAxis::RIGHT)->SetTitle("");
  actor->GetScene()->AddItem(chart);
  actor->GetScene()->SetRenderer(renderer);
  renderer->AddViewProp(actor);
  for (const char* name : {"time", "cursor"})
    addColumn(cursorTable, name);
  cursorTable->SetNumberOfRows(2);
}

void VolumeChart::Parts::applyTheme() {
  const Vec3& text = theme.text;
  renderer->SetBackground(theme.panel.data());
  for (const int which : kAxes) {
    auto* axis = chart->GetAxis(which);
    axis->GetLabelProperties()->SetColor(text.x(), text.y(), text.z());
    axis->GetTitleProperties()->SetColor(text.x(), text.y(), text.z());
    setPen(axis->GetPen(), theme.muted, 1);
    setPen(axis->GetGridPen(), theme.muted, which == vtkAxis::RIGHT ? 0 : 0.22);
  }
  chart->GetBackgroundBrush()->SetOpacity(0);
  // The second axis has the colour of its curve, to show which curve it belongs to.
  const auto second =
      std::find_if(curves.begin(), curves.end(), [](const auto& curve) { return curve->line.rightAxis; });
  if (second != curves.end()) {
    auto* axis = chart->GetAxis(vtkAxis::RIGHT);
    const Vec3 color = LabelledChart::letters((*second)->line.color, theme);
    axis->GetLabelProperties()->SetColor(color.x(), color.y(), color.z());
    setPen(axis->GetPen(), (*second)->line.color, 1);
  }
  if (cursorPlot)
    setPen(cursorPlot->GetPen(), theme.text, 0.8);
}

/// Bands first, so that every curve is in front of all of them.
void VolumeChart::Parts::makePlots() {
  chart->ClearPlots();
  for (auto& curve : curves) {
    curve->bands.clear();
    for (std::size_t i = 0; i < curve->line.bands.size(); ++i) {
      const Vec3& c = curve->line.color;
      auto band = vtkSmartPointer<NormalBand>::New();
      band->GetBrush()->SetColor(byteOf(c.x()), byteOf(c.y()), byteOf(c.z()), kBandAlpha);
      band->GetPen()->SetLineType(vtkPen::NO_PEN);
      band->SetLegendVisibility(false);
      band->SetSelectable(false);
      chart->AddPlot(band);
      chart->SetPlotCorner(band, cornerOf(*curve));
      curve->bands.push_back(std::move(band));
    }
  }
  for (auto& curve : curves) {
    if (curve->table->GetNumberOfColumns() == 0) {
      addColumn(curve->table, "time");
      addColumn(curve->table, curve->line.name);
    }
    curve->plot = chart->AddPlot(curve->line.dots ? vtkChart::POINTS : vtkChart::LINE);
    if (auto* dots = vtkPlotPoints::SafeDownCast(curve->plot); dots && curve->line.dots)
      dots->SetMarkerStyle(vtkPlotPoints::CIRCLE);
    curve->plot->SetInputData(curve->table, 0, 1);
    curve->plot->SetWidth(kCurveWidth);
    setPen(curve->plot->GetPen(), curve->line.color, 1);
    curve->plot->GetPen()->SetLineType(curve->line.dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
    chart->SetPlotCorner(curve->plot, cornerOf(*curve));
  }
  cursorPlot = chart->AddPlot(vtkChart::LINE);
  cursorPlot->SetInputData(cursorTable, 0, 1);
  cursorPlot->SetLegendVisibility(false);
  cursorPlot->SetWidth(kChartCursorWidth);
  cursorPlot->SetVisible(cursor.has_value());
  applyTheme();
}

void VolumeChart::Parts::forgetBefore(double seconds) {
  const auto keep = std::lower_bound(times.begin(), times.end(), seconds) - times.begin();
  times.erase(times.begin(), times.begin() + keep);
  for (auto& curve : curves)
    if (!curve->ownTimes)
      curve->values.erase(curve->values.begin(), curve->values.begin() + keep);
}

ValueRange VolumeChart::Parts::timeRange() const {
  if (fixedRange)
    return *fixedRange;
  const double last = times.empty() ? 0 : times.back();
  return last <= span ? ValueRange{0, span} : ValueRange{last - span, last};
}

ValueRange VolumeChart::Parts::valueRange(bool right) const {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto include = [&](double value) {
    if (!std::isfinite(value))
      return;
    low = std::min(low, value);
    high = std::max(high, value);
  };
  for (const auto& curve : curves) {
    if (curve->line.rightAxis != right)
      continue;
    std::for_each(curve->values.begin(), curve->values.end(), include);
  }
  const ValueRange seen = withBands({low, high}, right);
  low = seen.low;
  high = seen.high;
  if (low > high)
    return {0, 1};
  const bool flat = high - low <= kFlat * std::max(std::abs(low), std::abs(high));
  const double room = flat ? std::max(1.0, 0.05 * std::abs(high)) : kChartRoom * (high - low);
  return {low >= 0 ? std::max(0.0, low - room) : low - room, high + room};
}

ValueRange VolumeChart::Parts::withBands(ValueRange of, bool right) const {
  const bool empty = of.low > of.high;
  const double most =
      empty ? std::numeric_limits<double>::infinity()
            : std::max(kBandsStretch * (of.high - of.low), std::max(std::abs(of.low), std::abs(of.high)));
  ValueRange whole = of;
  for (const auto& curve : curves)
    for (const ChartBand& band : curve->line.bands)
      if (curve->line.rightAxis == right)
        whole = {std::min(whole.low, band.range.low), std::max(whole.high, band.range.high)};
  if (empty || whole.high - whole.low <= most)
    return whole;
  // Longer bands run out of the picture, where they reach into it.
  const double reach = 0.5 * (most - (of.high - of.low));
  const ValueRange within = {of.low - reach, of.high + reach};
  ValueRange seen = of;
  for (const auto& curve : curves)
    for (const ChartBand& band : curve->line.bands)
      if (curve->line.rightAxis == right && band.range.low < within.high && band.range.high > within.low)
        seen = {std::min(seen.low, std::max(within.low, band.range.low)),
                std::max(seen.high, std::min(within.high, band.range.high))};
  return seen;
}

void VolumeChart::Parts::fillCurve(Curve& curve, ValueRange range) {
  const std::vector<double>& drawn = curve.ownTimes ? *curve.ownTimes : times;
  const auto count = static_cast<vtkIdType>(drawn.size());
  curve.table->SetNumberOfRows(count);
  std::copy(drawn.begin(), drawn.end(),
            vtkDoubleArray::SafeDownCast(curve.table->GetColumn(0))->GetPointer(0));
  double* values = vtkDoubleArray::SafeDownCast(curve.table->GetColumn(1))->GetPointer(0);
  std::copy(curve.values.begin(), curve.values.end(), values);
  const bool anyLine = curve.line.dots
                           ? std::any_of(values, values + count, [](double v) { return std::isfinite(v); })
                           : leaveLinesOnly(values, drawn.size());
  curve.table->Modified();
  // VTK draws garbage for an empty table.
  curve.plot->SetVisible(anyLine);
  for (std::size_t i = 0; i < curve.bands.size(); ++i)
    curve.bands[i]->setExtent(range, curve.line.bands[i].range);
}

void VolumeChart::Parts::fillCursor(ValueRange values) {
  if (!cursorPlot)
    return;
  cursorPlot->SetVisible(cursor.has_value());
  setRow(cursorTable, 0, {cursor.value_or(0), values.low});
  setRow(cursorTable, 1, {cursor.value_or(0), values.high});
  cursorTable->Modified();
}

void VolumeChart::Parts::nameCurves(double ratio) {
  std::vector<LabelledChart::Line> lines;
  std::vector<LabelledChart::Caption> captions;
  for (const auto& curve : curves) {
    const ChartLine& line = curve->line;
    for (const ChartBand& band : line.bands)
      captions.push_back({band.label, band.range, line.rightAxis});
    if (curve->plot->GetVisible())
      lines.push_back(
          {line.name, line.color, line.dashed, line.dots, line.rightAxis, curve->table.GetPointer()});
  }
  chart->setLook(theme, kChartFontSize, ratio);
  chart->setLines(std::move(lines));
  chart->setCaptions(std::move(captions));
}

VolumeChart::VolumeChart() : parts_((guardText(), std::make_unique<Parts>())) {
  parts_->build();
  parts_->makePlots();
  setAxes("Time", "s", "Volume", "ml");
  update();
}

VolumeChart::~VolumeChart() {
  setWindow(nullptr);
}

void VolumeChart::setWindow(vtkRenderWindow* window) {
  auto& p = *parts_;
  if (p.window)
    p.window->RemoveRenderer(p.renderer);
  p.window = window;
  if (!window)
    return;
  window->SetMultiSamples(0); // The chart smooths its lines itself.
  window->AddRenderer(p.renderer);
}

void VolumeChart::setTheme(const Theme& theme) {
  parts_->theme = theme;
  parts_->applyTheme();
}

void VolumeChart::setDecimalMark(char mark) {
  parts_->decimalMark = mark;
  update();
}

void VolumeChart::setAxes(const std::string& xTitle, const std::string& xUnit, const std::string& yTitle,
                          const std::string& yUnit) {
  const auto joined = [](const std::string& title, const std::string& unit) {
    return unit.empty() ? title : title + " (" + unit + ")";
  };
  parts_->xTitle = joined(xTitle, xUnit);
  parts_->xUnit = xUnit;
  parts_->chart->GetAxis(vtkAxis::BOTTOM)->SetTitle(parts_->xTitle);
  parts_->chart->GetAxis(vtkAxis::LEFT)->SetTitle(joined(yTitle, yUnit));
}

void VolumeChart::setLines(const std::vector<ChartLine>& lines) {
  auto& p = *parts_;
  p.times.clear();
  p.curves.clear();
  for (const auto& line : lines) {
    p.curves.push_back(std::make_unique<Curve>());
    p.curves.back()->line = line;
  }
  p.makePlots();
  update();
}

void VolumeChart::setBands(int line, std::vector<ChartBand> bands) {
  parts_->curves.at(std::size_t(line))->line.bands = std::move(bands);
  parts_->makePlots();
  update(); // New plots of empty curves must not be painted.
}

int VolumeChart::lineCount() const {
  return static_cast<int>(parts_->curves.size());
}

void VolumeChart::append(double seconds, const Values& values) {
  auto& p = *parts_;
  assert(values.size() == lineCount());
  const auto keep = std::lower_bound(p.times.begin(), p.times.end(), seconds) - p.times.begin();
  p.times.resize(std::size_t(keep));
  p.times.push_back(seconds);
  for (std::size_t i = 0; i < p.curves.size(); ++i) {
    Curve& curve = *p.curves[i];
    if (std::exchange(curve.ownTimes, std::nullopt))
      curve.values.clear();
    curve.values.resize(std::size_t(keep), std::numeric_limits<double>::quiet_NaN());
    curve.values.push_back(values[Eigen::Index(i)]);
  }
  // Throwing away half as much again as is shown at a time keeps the cost per point constant.
  if (!p.fixedRange && p.times.front() < seconds - 1.5 * p.span)
    p.forgetBefore(seconds - p.span);
}

void VolumeChart::clear() {
  parts_->times.clear();
  for (auto& curve : parts_->curves) {
    curve->values.clear();
    curve->ownTimes.reset();
  }
}

void VolumeChart::setCurve(int line, std::vector<double> times, std::vector<double> values) {
  if (times.size() != values.size())
    throw UsageError(misuse("a curve needs one number for each time"));
  Curve& curve = *parts_->curves.at(std::size_t(line));
  curve.ownTimes = std::move(times);
  curve.values = std::move(values);
}

int VolumeChart::pointCount() const {
  return static_cast<int>(parts_->times.size());
}

void VolumeChart::setTimeSpan(double seconds) {
  assert(seconds > 0);
  parts_->span = seconds;
  parts_->fixedRange.reset();
}

void VolumeChart::setTimeRange(ValueRange seconds) {
  parts_->fixedRange = seconds;
}

void VolumeChart::setCursor(double seconds) {
  parts_->cursor = seconds;
}

void VolumeChart::hideCursor() {
  parts_->cursor.reset();
}

std::optional<VolumeChart::Upright> VolumeChart::placeOf(double seconds) const {
  const auto& p = *parts_;
  const int* low = p.chart->GetPoint1();
  const int* high = p.chart->GetPoint2();
  const int* size = p.window ? p.window->GetSize() : nullptr;
  auto* axis = p.chart->GetAxis(vtkAxis::BOTTOM);
  const double begin = axis->GetMinimum(), length = axis->GetMaximum() - begin;
  if (!size || high[0] <= low[0] || high[0] > size[0] || high[1] > size[1] || !(length > 0))
    return std::nullopt;
  const double part = (seconds - begin) / length;
  if (!(part >= 0 && part <= 1))
    return std::nullopt;
  return Upright{(low[0] + part * (high[0] - low[0])) / size[0], static_cast<double>(low[1]) / size[1],
                 static_cast<double>(high[1]) / size[1]};
}

void VolumeChart::update() {
  auto& p = *parts_;
  const ValueRange times = p.timeRange(), values = p.valueRange(false), right = p.valueRange(true);
  const auto ratio = static_cast<float>(pixelRatioOf(p.window));
  for (auto& curve : p.curves)
    if (auto* dots = vtkPlotPoints::SafeDownCast(curve->plot); dots && curve->line.dots)
      dots->SetMarkerSize(ratio * kChartDotSize);
    else
      curve->plot->SetWidth(ratio * kCurveWidth);
  p.cursorPlot->SetWidth(ratio * kChartCursorWidth);
  for (auto& curve : p.curves)
    p.fillCurve(*curve, times);
  p.fillCursor(values);
  p.fillAxis(vtkAxis::BOTTOM, times);
  p.fillAxis(vtkAxis::LEFT, values);
  p.fillAxis(vtkAxis::RIGHT, right);
  p.chart->GetAxis(vtkAxis::BOTTOM)->SetTitle(p.isLow() ? std::string() : p.xTitle);
  p.nameCurves(ratio);
  const auto atRight = [](const auto& curve) { return curve->line.rightAxis; };
  p.chart->GetAxis(vtkAxis::RIGHT)->SetVisible(std::any_of(p.curves.begin(), p.curves.end(), atRight));
  p.chart->RecalculateBounds();
  p.actor->GetScene()->SetDirty(true);
}

} // namespace viscera::scene
