#include "viscera/scene/legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

#include <vtkCellData.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include "viscera/scene/organ_view.h"

#include "before_render.h"
#include "flat_shape.h"
#include "view_furniture.h"

namespace viscera::scene {
namespace {

/// Logical pixels.
constexpr double kBarWidth = 14;
constexpr double kBarHeight = 240;
constexpr double kRight = 76; ///< From the bar's left edge to the window's right edge.
constexpr double kLegendTick = 5;
constexpr double kLegendGap = 6;
constexpr double kTitleGap = 14;
constexpr double kTitleRight = 18;
constexpr double kMarkGap = 26; ///< From the bar down to the mark's swatch.
/// Distances in a narrow view from its upper edge down to the foot of each.
constexpr double kLevelTitle = 24, kLevelBar = 36, kLevelMark = 76;
constexpr double kLevelBarHeight = 8;
constexpr double kLevelSide = 24; ///< On either side of the bar: half a number.
constexpr double kLevelGap = 2;
constexpr double kLevelSwatch = 10;
constexpr double kBesideBar = 8; ///< Between an organ and an upright bar.
constexpr double kDigit = 7.5;   ///< A character of a number is no wider.
constexpr int kLegendFontSize = 12;
constexpr int kTitleFontSize = 13;
constexpr double kLeastTitleSize = 8;
/// The bar takes at most this part of the view's height.
constexpr double kMostOfView = 0.5;
constexpr int kMostLegendTicks = 6;
constexpr double kGroundOpacity = 0.7;
/// Beyond these, labels may be written with an exponent.
constexpr double kLargestPlain = 1e5;
constexpr double kSmallestPlain = 1e-4;

/// Writes on a ground of its own, so that it can be read over organs and rings.
void setLook(vtkTextActor* actor, double size, const Theme& theme) {
  auto* letters = actor->GetTextProperty();
  letters->SetColor(theme.text.x(), theme.text.y(), theme.text.z());
  letters->SetBackgroundColor(theme.panel.x(), theme.panel.y(), theme.panel.z());
  letters->SetBackgroundOpacity(kGroundOpacity);
  setTextSize(actor, size, theme);
}

} // namespace

namespace {

constexpr std::size_t kFewestOfDecades = 3;
constexpr double kSlack = 1e-9;

/// `multiples` of every `step`-th power of ten inside the range.
std::vector<double> decadeTicks(ValueRange range, const std::vector<double>& multiples, int step) {
  std::vector<double> ticks;
  for (int power = static_cast<int>(std::floor(std::log10(range.low) / step)) * step;
       std::pow(10, power) <= range.high * (1 + kSlack); power += step)
    for (const double multiple : multiples)
      if (const double tick = multiple * std::pow(10, power);
          tick >= range.low * (1 - kSlack) && tick <= range.high * (1 + kSlack))
        ticks.push_back(tick);
  return ticks;
}

/// A part of the bar's length. A range of a single value is drawn as its only tick: 0 at the lower end, else
/// in the middle.
double placeOnBar(ValueRange range, double value) {
  if (!(range.high > range.low))
    return value == 0 ? 0 : 0.5;
  return std::clamp(partOf(range, value), 0.0, 1.0);
}

std::vector<double> logarithmicTicks(ValueRange range, int most) {
  std::vector<double> ticks;
  for (const std::vector<double>& multiples : {std::vector<double>{1, 2, 5}, {1, 3}, {1}})
    if (ticks = decadeTicks(range, multiples, 1); ticks.size() <= static_cast<std::size_t>(most))
      break;
  for (int step = 2; ticks.size() > static_cast<std::size_t>(most); ++step)
    ticks = decadeTicks(range, {1}, step);
  return ticks.size() < kFewestOfDecades ? niceTicks({range.low, range.high}, most) : ticks;
}

} // namespace

std::vector<double> niceTicks(ValueRange range, int most) {
  if (range.logarithmic && range.low > 0 && range.high > range.low && std::isfinite(range.high))
    return logarithmicTicks(range, most);
  const double span = range.high - range.low;
  if (!(span > 0) || !std::isfinite(span))
    return {range.low};
  const double slack = 1e-9 * span; // An end that is a round number up to rounding counts.
  double power = std::pow(10, std::floor(std::log10(span / most)));
  for (;; power *= 10)
    for (const double step : {power, 2 * power, 5 * power}) {
      const double first = std::ceil((range.low - slack) / step),
                   last = std::floor((range.high + slack) / step);
      if (last - first + 1 > most)
        continue;
      std::vector<double> ticks;
      for (double k = first; k <= last; ++k)
        ticks.push_back(k == 0 ? 0.0 : k * step);
      return ticks;
    }
}

std::string withDecimalMark(std::string number, char decimalMark) {
  std::replace(number.begin(), number.end(), '.', decimalMark);
  return number;
}

std::string tickLabel(double value, double spacing, char decimalMark) {
  char label[32];
  const double largest = std::max(std::abs(value), std::abs(spacing));
  if (largest >= kLargestPlain || spacing < kSmallestPlain) {
    const int digits = spacing > 0 ? static_cast<int>(std::ceil(std::log10(largest / spacing))) + 2 : 3;
    std::snprintf(label, sizeof label, "%.*g", std::max(3, digits), value);
    return withDecimalMark(label, decimalMark);
  }
  // The small push keeps a spacing such as 0.1 from asking for a digit too many.
  const int decimals =
      spacing > 0 ? std::max(0, -static_cast<int>(std::floor(std::log10(spacing) + 1e-9))) : 2;
  std::snprintf(label, sizeof label, "%.*f", decimals, value);
  return withDecimalMark(label, decimalMark);
}

std::vector<std::string> tickLabels(const std::vector<double>& ticks, char decimalMark) {
  const double spacing = ticks.size() > 1 ? ticks[1] - ticks[0] : 0;
  bool even = true;
  for (std::size_t i = 2; i < ticks.size(); ++i)
    even = even && std::abs(ticks[i] - ticks[i - 1] - spacing) < 1e-6 * spacing;
  std::vector<std::string> labels;
  for (const double tick : ticks)
    labels.push_back(
        tickLabel(tick, even ? spacing : std::pow(10, std::floor(std::log10(tick) + kSlack)), decimalMark));
  return labels;
}

namespace {

/// Where the bar of colours lies, device pixels.
struct BarPlace {
  bool level = false; ///< From left to right; else upwards.
  double left = 0;
  double bottom = 0;
  double length = 0; ///< Along its colours.
  double width = 0;

  std::array<double, 2> at(double along, double across) const {
    return level ? std::array<double, 2>{left + along, bottom + across}
                 : std::array<double, 2>{left + across, bottom + along};
  }
};

} // namespace

struct Legend::Parts {
  ColorMap map = viridis();
  ValueRange range;
  bool shown = false;
  Theme theme = darkTheme();
  char decimalMark = '.';

  FlatShape bar;
  FlatShape lines;
  FlatShape mark;
  bool marked = false;
  bool wasMarked = false; ///< Since it is shown.
  const vtkSmartPointer<vtkTextActor> markLabel = newText(kLegendFontSize);
  const vtkSmartPointer<vtkTextActor> title = newText(kTitleFontSize);
  std::vector<double> ticks;
  std::vector<vtkSmartPointer<vtkTextActor>> labels;
  BeforeRender beforeRender{[this] { layOut(); }};

  std::vector<vtkActor2D*> actors() const;
  void layOut();
  void layOutUpright(const int* size, double ratio);
  void layOutLevel(const int* size, double ratio);
  void layOutBar(const BarPlace& place);
  void layOutTicks(const BarPlace& place, double ratio);
  void layOutLabel(std::size_t tick, const std::array<double, 2>& at, bool level);
  void layOutMark(double left, double bottom, double width, double ratio);
  void setShown(bool on);
  void applyTheme();
};

std::vector<vtkActor2D*> Legend::Parts::actors() const {
  std::vector<vtkActor2D*> all = {bar.actor.Get(), lines.actor.Get(), title.Get(), mark.actor.Get(),
                                  markLabel.Get()};
  for (const auto& label : labels)
    all.push_back(label);
  return all;
}

void Legend::Parts::layOut() {
  if (!shown)
    return;
  auto* renderer = beforeRender.renderer();
  const double ratio = theme.typeScale * pixelRatioOf(renderer->GetRenderWindow());
  const int* size = renderer->GetSize();
  setTextSize(title, kTitleFontSize, theme);
  if (isNarrow(renderer, theme.typeScale))
    layOutLevel(size, ratio);
  else
    layOutUpright(size, ratio);
}

void Legend::Parts::layOutUpright(const int* size, double ratio) {
  const double height = std::min(ratio * kBarHeight, kMostOfView * size[1]);
  const double left = size[0] - ratio * kRight, bottom = std::floor(0.5 * (size[1] - height));
  const BarPlace place{false, left, bottom, height, ratio * kBarWidth};
  layOutBar(place);
  layOutTicks(place, ratio);
  layOutMark(left, bottom - ratio * kMarkGap, ratio * kBarWidth, ratio);
  title->GetTextProperty()->SetJustificationToRight();
  title->SetPosition(size[0] - ratio * kTitleRight, bottom + height + ratio * kTitleGap);
}

/// Along the upper edge, where it leaves the width to the organ. A long title is written smaller.
void Legend::Parts::layOutLevel(const int* size, double ratio) {
  const double left = ratio * kLevelSide, top = size[1];
  const double length = std::max(1.0, size[0] - 2 * left);
  const BarPlace place{true, left, top - ratio * kLevelBar, length, ratio * kLevelBarHeight};
  layOutBar(place);
  layOutTicks(place, ratio);
  layOutMark(left, top - ratio * kLevelMark, ratio * kLevelSwatch, ratio);
  std::array<double, 2> written{0, 0};
  title->GetSize(beforeRender.renderer(), written.data());
  if (written[0] > length)
    setTextSize(title, std::max(kLeastTitleSize, std::floor(kTitleFontSize * length / written[0])), theme);
  title->GetTextProperty()->SetJustificationToCentered();
  title->SetPosition(0.5 * size[0], top - ratio * kLevelTitle);
}

void Legend::Parts::layOutBar(const BarPlace& place) {
  const Eigen::Index count = map.colors.rows();
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  bar.begin();
  for (Eigen::Index i = 0; i <= count; ++i) {
    const double along = place.length * double(i) / double(count);
    for (const double across : {0.0, place.width}) {
      const auto at = place.at(along, across);
      bar.add(at[0], at[1]);
    }
    if (i == count)
      break;
    quads->InsertNextCell({2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2});
    colors->InsertNextTypedTuple(map.colors.row(i).data());
  }
  bar.end();
  bar.data->SetPolys(quads);
  bar.data->GetCellData()->SetScalars(colors);
}

/// Ticks and numbers are to the right of an upright bar and below a level one. Of numbers that would meet the
/// first is written.
void Legend::Parts::layOutTicks(const BarPlace& place, double ratio) {
  vtkNew<vtkCellArray> cells;
  lines.begin();
  const double edge = place.level ? 0 : place.width;
  const double tick = place.level ? -ratio * kLegendTick : ratio * kLegendTick;
  const double gap = place.level ? -ratio * kLevelGap : ratio * kLegendGap;
  double written = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const double along = place.length * placeOnBar(range, ticks[i]);
    const auto from = place.at(along, edge), to = place.at(along, edge + tick);
    cells->InsertNextCell({lines.add(from[0], from[1]), lines.add(to[0], to[1])});
    layOutLabel(i, place.at(along, edge + tick + gap), place.level);
    const double half = 0.5 * ratio * kDigit * static_cast<double>(std::strlen(labels[i]->GetInput()));
    const bool fits = !place.level || along - half > written;
    labels[i]->SetVisibility(fits);
    if (fits)
      written = along + half;
  }
  lines.end();
  lines.data->SetLines(cells);
  lines.actor->GetProperty()->SetLineWidth(static_cast<float>(ratio));
}

void Legend::Parts::layOutLabel(std::size_t tick, const std::array<double, 2>& at, bool level) {
  auto* letters = labels[tick]->GetTextProperty();
  letters->SetJustification(level ? VTK_TEXT_CENTERED : VTK_TEXT_LEFT);
  letters->SetVerticalJustification(level ? VTK_TEXT_TOP : VTK_TEXT_CENTERED);
  labels[tick]->SetPosition(at[0], at[1]);
}

void Legend::Parts::layOutMark(double left, double bottom, double width, double ratio) {
  vtkNew<vtkCellArray> quad;
  mark.begin();
  mark.addBox(left, bottom, left + width, bottom + width, quad);
  mark.end();
  mark.data->SetPolys(quad);
  markLabel->SetPosition(left + width + ratio * kLegendGap, bottom + 0.5 * width);
}

void Legend::Parts::setShown(bool on) {
  shown = on;
  for (auto* actor : actors())
    actor->SetVisibility(on);
  mark.actor->SetVisibility(on && marked);
  markLabel->SetVisibility(on && marked);
}

void Legend::Parts::applyTheme() {
  const Vec3& text = theme.text;
  lines.actor->GetProperty()->SetColor(text.x(), text.y(), text.z());
  setLook(title, kTitleFontSize, theme);
  setLook(markLabel, kLegendFontSize, theme);
  for (const auto& label : labels)
    setLook(label, kLegendFontSize, theme);
}

Legend::Legend() : parts_(std::make_unique<Parts>()) {
  parts_->title->GetTextProperty()->SetVerticalJustificationToBottom();
  parts_->markLabel->GetTextProperty()->SetVerticalJustificationToCentered();
  hide();
}

Legend::~Legend() {
  setRenderer(nullptr);
}

void Legend::setRenderer(vtkRenderer* renderer) {
  parts_->beforeRender.setRenderer(renderer, parts_->actors());
}

void Legend::setTheme(const Theme& theme) {
  parts_->theme = theme;
  parts_->applyTheme();
}

void Legend::setDecimalMark(char mark) {
  parts_->decimalMark = mark;
}

void Legend::show(const std::string& title, const std::string& unit, const ColorMap& map, ValueRange range) {
  auto& p = *parts_;
  auto* renderer = p.beforeRender.renderer();
  setRenderer(nullptr);
  p.map = map;
  p.range = range;
  p.title->SetInput((unit.empty() ? title : title + " (" + unit + ")").c_str());
  p.ticks = niceTicks(range, kMostLegendTicks);
  p.labels.clear();
  for (const std::string& written : tickLabels(p.ticks, p.decimalMark)) {
    auto label = newText(kLegendFontSize);
    label->SetInput(written.c_str());
    p.labels.push_back(label);
  }
  p.setShown(true);
  p.applyTheme();
  setRenderer(renderer);
}

void Legend::hide() {
  parts_->marked = parts_->wasMarked = false;
  parts_->setShown(false);
}

void Legend::setMark(const std::string& label, const Vec3& color) {
  auto& p = *parts_;
  p.marked = !label.empty();
  p.wasMarked = p.shown && (p.wasMarked || p.marked);
  p.markLabel->SetInput(label.c_str());
  p.mark.actor->GetProperty()->SetColor(color.x(), color.y(), color.z());
  p.setShown(p.shown);
}

bool Legend::visible() const {
  return parts_->shown;
}

LegendRoom Legend::room() const {
  return parts_->shown ? roomWhenShown() : LegendRoom();
}

LegendRoom Legend::roomWhenShown() const {
  auto* renderer = parts_->beforeRender.renderer();
  if (!renderer)
    return {};
  const double ratio = parts_->theme.typeScale * pixelRatioOf(renderer->GetRenderWindow());
  if (!isNarrow(renderer, parts_->theme.typeScale))
    return {0, ratio * (kRight + kBesideBar)};
  return {ratio * (parts_->wasMarked ? kLevelMarkedLegend : kLevelLegend), 0};
}

} // namespace viscera::scene
