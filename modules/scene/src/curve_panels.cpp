#include "viscera/scene/curve_panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPlot.h>
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
#include "text_guard.h"

namespace viscera::scene {
namespace {

constexpr int kPanelFontSize = 12;
constexpr int kTitleSize = 14;
constexpr double kPanelRoom = 0.06; ///< Above and below the curves, as a part of their range.
constexpr double kGrid = 0.22;
constexpr double kMarkOpacity = 0.8;
constexpr double kBandOpacity = 0.14;

vtkSmartPointer<vtkTable> tableOf(const std::string& name, const std::vector<double>& x,
                                  const std::vector<double>& y) {
  auto table = vtkSmartPointer<vtkTable>::New();
  const auto add = [&table](const std::string& title, const std::vector<double>& values) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(title.c_str());
    column->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), column->GetPointer(0));
    table->AddColumn(column);
  };
  add("x", x);
  add(name, y);
  return table;
}

ValueRange rangeOf(const CurvePanel& panel, std::vector<double> PanelCurve::*values, double room) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const PanelCurve& curve : panel.curves)
    for (const double value : curve.*values)
      if (std::isfinite(value)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
  if (low > high)
    return {0, 1};
  const double more = high > low ? room * (high - low) : 1;
  return {low - more, high + more};
}

/// One panel with what VTK draws it from.
struct Panel {
  CurvePanel wanted;
  vtkSmartPointer<vtkChartXY> chart;
};

void setAxis(vtkAxis* axis, const ValueRange& range, const std::string& title, bool labels, int mostTicks,
             char decimalMark) {
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(range.low, range.high);
  axis->SetTitle(title);
  const auto ticks = niceTicks(range, mostTicks);
  const double spacing = ticks.size() > 1 ? ticks[1] - ticks[0] : 0;
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> names;
  for (const double tick : ticks) {
    positions->InsertNextValue(tick);
    names->InsertNextValue(labels ? tickLabel(tick, spacing, decimalMark) : std::string());
  }
  axis->SetCustomTickPositions(positions, names);
  axis->SetLabelsVisible(labels);
}

void addCurve(vtkChartXY* chart, const PanelCurve& curve) {
  if (curve.x.size() < 2)
    return; // A single point is no line, and VTK draws garbage for an empty table.
  vtkPlot* plot = chart->AddPlot(vtkChart::LINE);
  plot->SetInputData(tableOf(curve.name, curve.x, curve.y), 0, 1);
  plot->SetLabel(curve.name);
  plot->SetLegendVisibility(!curve.name.empty());
  setPen(plot->GetPen(), curve.color, 1);
  plot->GetPen()->SetLineType(curve.dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
}

vtkSmartPointer<vtkChartXY> chartOf(const CurvePanel& panel) {
  auto chart = vtkSmartPointer<vtkChartXY>::New();
  chart->SetAutoSize(false);
  chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
  chart->SetRenderEmpty(true);
  chart->SetTitle(panel.title);
  chart->SetShowLegend(panel.legend);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  chart->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  chart->GetLegend()->GetPen()->SetLineType(vtkPen::NO_PEN);
  chart->GetBackgroundBrush()->SetOpacity(0);
  for (const PanelCurve& curve : panel.curves)
    addCurve(chart, curve);
  return chart;
}

/// The size of type, in points, at the theme's scale.
int scaledType(const Theme& theme, int size) {
  return static_cast<int>(std::lround(theme.typeScale * size));
}

void applyTheme(vtkChartXY* chart, const Theme& theme) {
  const Vec3& text = theme.text;
  for (const int which : {vtkAxis::BOTTOM, vtkAxis::LEFT}) {
    auto* axis = chart->GetAxis(which);
    for (vtkTextProperty* property : {axis->GetLabelProperties(), axis->GetTitleProperties()}) {
      property->SetColor(text.x(), text.y(), text.z());
      property->SetFontSize(scaledType(theme, kPanelFontSize));
      property->BoldOff();
    }
    setPen(axis->GetPen(), theme.muted, 1);
    setPen(axis->GetGridPen(), theme.muted, kGrid);
  }
  chart->GetTitleProperties()->SetColor(text.x(), text.y(), text.z());
  chart->GetTitleProperties()->SetFontSize(scaledType(theme, kTitleSize));
  chart->GetLegend()->SetLabelSize(scaledType(theme, kPanelFontSize));
  chart->GetLegend()->GetLabelProperties()->SetColor(text.x(), text.y(), text.z());
  const Vec3& back = theme.panel;
  chart->GetLegend()->GetBrush()->SetColor(byteOf(back.x()), byteOf(back.y()), byteOf(back.z()), 190);
}

/// Draws the marks and the bands of all panels over their charts.
class PanelMarks final : public vtkContextItem {
public:
  vtkTypeMacro(PanelMarks, vtkContextItem) static PanelMarks* New();

  struct Line {
    float x = 0, low = 0, high = 0; ///< Pixels.
    std::string text;
  };
  struct Band {
    float x = 0, y = 0, width = 0, height = 0; ///< Pixels.
    Vec3 color = Vec3::Zero();
  };
  void set(std::vector<Line> lines, std::vector<Band> bands, const Theme& theme, float ratio) {
    lines_ = std::move(lines);
    bands_ = std::move(bands);
    theme_ = theme;
    ratio_ = ratio;
  }
  bool Paint(vtkContext2D* painter) override {
    const Vec3& ink = theme_.text;
    painter->GetPen()->SetLineType(vtkPen::NO_PEN);
    for (const Band& band : bands_) {
      painter->GetBrush()->SetColor(byteOf(band.color.x()), byteOf(band.color.y()), byteOf(band.color.z()));
      painter->GetBrush()->SetOpacityF(kBandOpacity);
      painter->DrawRect(band.x, band.y, band.width, band.height);
    }
    setPen(painter->GetPen(), theme_.muted, kMarkOpacity);
    painter->GetPen()->SetWidth(ratio_);
    painter->GetPen()->SetLineType(vtkPen::DASH_LINE);
    painter->GetTextProp()->SetColor(ink.x(), ink.y(), ink.z());
    painter->GetTextProp()->SetFontSize(scaledType(theme_, kPanelFontSize));
    painter->GetTextProp()->SetJustificationToLeft();
    painter->GetTextProp()->SetVerticalJustificationToTop();
    for (const Line& line : lines_) {
      painter->DrawLine(line.x, line.low, line.x, line.high);
      if (!line.text.empty())
        painter->DrawString(line.x + 3 * ratio_, line.high, line.text);
    }
    return true;
  }

private:
  std::vector<Line> lines_;
  std::vector<Band> bands_;
  Theme theme_ = lightTheme();
  float ratio_ = 1;
};
vtkStandardNewMacro(PanelMarks);

} // namespace

struct CurvePanels::Parts {
  char decimalMark = '.';
  vtkNew<vtkRenderer> renderer;
  vtkNew<ChartActor> actor;
  vtkWeakPointer<vtkRenderWindow> window;
  Theme theme = lightTheme();
  std::vector<Panel> panels;
  vtkNew<PanelMarks> marks;

  void show(const Panel& panel);
  void showMarks();
};

void CurvePanels::Parts::show(const Panel& panel) {
  const int* size = window->GetSize();
  const auto ratio = static_cast<float>(pixelRatioOf(window));
  const CurvePanel& p = panel.wanted;
  panel.chart->SetSize(vtkRectf(static_cast<float>(p.left * size[0]), static_cast<float>(p.bottom * size[1]),
                                static_cast<float>((p.right - p.left) * size[0]),
                                static_cast<float>((p.top - p.bottom) * size[1])));
  int plot = 0;
  for (const PanelCurve& curve : p.curves)
    if (curve.x.size() >= 2)
      panel.chart->GetPlot(plot++)->SetWidth(ratio * static_cast<float>(theme.typeScale) * curve.width);
  applyTheme(panel.chart, theme);
  panel.chart->RecalculateBounds();
}

void CurvePanels::Parts::showMarks() {
  const int* size = window->GetSize();
  std::vector<PanelMarks::Line> lines;
  std::vector<PanelMarks::Band> bands;
  for (const Panel& panel : panels) {
    const CurvePanel& p = panel.wanted;
    const ValueRange x = p.xRange.value_or(rangeOf(p, &PanelCurve::x, 0));
    for (const PanelMark& mark : p.marks) {
      const double part = (mark.x - x.low) / (x.high - x.low);
      if (part >= 0 && part <= 1)
        lines.push_back({static_cast<float>((p.left + part * (p.right - p.left)) * size[0]),
                         static_cast<float>(p.bottom * size[1]), static_cast<float>(p.top * size[1]),
                         mark.text});
    }
    const ValueRange y = p.yRange.value_or(rangeOf(p, &PanelCurve::y, kPanelRoom));
    for (const PanelBand& band : p.bands) {
      const auto heightOf = [&](double value) {
        return (p.bottom + std::clamp((value - y.low) / (y.high - y.low), 0.0, 1.0) * (p.top - p.bottom)) *
               size[1];
      };
      const double low = heightOf(band.y.low), high = heightOf(band.y.high);
      bands.push_back({static_cast<float>(p.left * size[0]), static_cast<float>(low),
                       static_cast<float>((p.right - p.left) * size[0]), static_cast<float>(high - low),
                       band.color});
    }
  }
  marks->set(std::move(lines), std::move(bands), theme, static_cast<float>(pixelRatioOf(window)));
}

CurvePanels::CurvePanels() : parts_((guardText(), std::make_unique<Parts>())) {
  parts_->actor->GetScene()->SetRenderer(parts_->renderer);
  parts_->renderer->AddViewProp(parts_->actor);
  setTheme(parts_->theme);
}

CurvePanels::~CurvePanels() {
  setWindow(nullptr);
}

void CurvePanels::setWindow(vtkRenderWindow* window) {
  auto& p = *parts_;
  if (p.window)
    p.window->RemoveRenderer(p.renderer);
  p.window = window;
  if (!window)
    return;
  window->SetMultiSamples(0); // Charts smooth their lines themselves.
  window->AddRenderer(p.renderer);
}

void CurvePanels::setDecimalMark(char mark) {
  parts_->decimalMark = mark;
}

void CurvePanels::setTheme(const Theme& theme) {
  parts_->theme = theme;
  parts_->renderer->SetBackground(theme.panel.data());
}

void CurvePanels::setPanels(std::vector<CurvePanel> panels) {
  auto& p = *parts_;
  for (const CurvePanel& panel : panels)
    for (const PanelCurve& curve : panel.curves)
      if (curve.x.size() != curve.y.size())
        throw UsageError(misuse("a curve needs one y for each x"), curve.name);
  p.actor->GetScene()->ClearItems();
  p.panels.clear();
  for (CurvePanel& wanted : panels) {
    Panel panel{std::move(wanted), nullptr};
    panel.chart = chartOf(panel.wanted);
    const ValueRange y = panel.wanted.yRange.value_or(rangeOf(panel.wanted, &PanelCurve::y, kPanelRoom));
    const ValueRange x = panel.wanted.xRange.value_or(rangeOf(panel.wanted, &PanelCurve::x, 0));
    setAxis(panel.chart->GetAxis(vtkAxis::BOTTOM), x, panel.wanted.xTitle, panel.wanted.xLabels,
            panel.wanted.mostXTicks, p.decimalMark);
    setAxis(panel.chart->GetAxis(vtkAxis::LEFT), y, panel.wanted.yTitle, panel.wanted.yLabels,
            panel.wanted.mostYTicks, p.decimalMark);
    p.actor->GetScene()->AddItem(panel.chart);
    p.panels.push_back(std::move(panel));
  }
  p.actor->GetScene()->AddItem(p.marks);
}

void CurvePanels::update() {
  auto& p = *parts_;
  if (!p.window)
    return;
  for (const Panel& panel : p.panels)
    p.show(panel);
  p.showMarks();
  p.actor->GetScene()->SetDirty(true);
}

} // namespace viscera::scene
