#include "viscera/presentation/circulation_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "viscera/circulation/curves.h"
#include "viscera/circulation/signs.h"
#include "viscera/circulation/valve_state.h"
#include "viscera/core/text.h"
#include "viscera/heart/cardiac_times.h"

namespace viscera::presentation {
namespace {

using circulation::Compartment;
using circulation::Valve;
using scene::CurvePanel;
using scene::PanelCurve;

// Safe for people who do not tell red from green (Okabe and Ito).
const Vec3 kVentricle = {0.84, 0.37, 0.0};
const Vec3 kArtery = {0.80, 0.24, 0.48};
const Vec3 kAtrium = {0.60, 0.52, 0.12};
const Vec3 kRight = {0.0, 0.45, 0.70}; ///< Blue is the right heart, as in the charts of volumes.
const Vec3 kSign = {0.50, 0.57, 0.62}; ///< Seen on dark and on light grounds.
const Vec3 kRelation = {0.0, 0.62, 0.45};
const Vec3 kBefore = {0.55, 0.58, 0.61};

constexpr double kLeft = 0.06; ///< Of the left axes.
constexpr int kRelationPoints = 60;
constexpr double kRoomForLegend = 1.3, kRoomForLoopLegend = 1.15;
constexpr double kBelowSounds = 1.2, kAboveSounds = 2.3; ///< Of the loudest sound.
constexpr float kBarWidth = 7;
constexpr float kThin = 1.3F;

/// A stretch of the window's height for a panel.
struct Strip {
  double bottom, top;
};
constexpr Strip kPressures{0.50, 0.95}, kValves{0.415, 0.475}, kVolume{0.245, 0.39}, kEcg{0.15, 0.225},
    kSound{0.065, 0.13};

// A low and wide window, in pixels; the strips share the height that gaps and labels leave.
constexpr double kStripLeft = 52, kStripRight = 12, kStripBottom = 40, kStripTop = 8, kStripGap = 5;
/// A panel of Wiggers's diagram in a strip, in the order of `wiggersPanels`.
struct StripRow {
  double height; ///< Its share.
  int ticks;
  bool HeartSigns::*chosen;
};
constexpr double kWiggersPart = 0.5; ///< Of the width.
constexpr int kFewTicks = 4, kTwoTicks = 2;
constexpr std::array<StripRow, 5> kStripRows = {{{0.34, kFewTicks, &HeartSigns::pressures},
                                                 {0.15, kTwoTicks, &HeartSigns::valves},
                                                 {0.17, kTwoTicks, &HeartSigns::pressures},
                                                 {0.17, kTwoTicks, &HeartSigns::ecg},
                                                 {0.17, kTwoTicks, &HeartSigns::sounds}}};
constexpr std::size_t kMostStripPoints = 600;
/// Pixels of a strip whose type has the usual size, and the smallest type that is legible.
constexpr double kUsualStripWidth = 900, kUsualStripHeight = 280, kLeastStripType = 0.6;

/// Pixels at the usual size of type as parts of a window.
class StripRoom {
public:
  StripRoom(int width, int height, double typeScale)
      : width_(std::max(1, width) / typeScale), height_(std::max(1, height) / typeScale) {}
  double partOfWidth(double pixels) const { return pixels / width_; }
  double partOfHeight(double pixels) const { return pixels / height_; }

private:
  double width_, height_;
};

/// Every other point where there are more than a small chart has pixels; both ends stay.
void thin(PanelCurve& curve) {
  while (curve.x.size() > kMostStripPoints) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < curve.x.size(); i += 2, ++kept) {
      curve.x[kept] = curve.x[i];
      curve.y[kept] = curve.y[i];
    }
    if (curve.x.size() % 2 == 0) {
      curve.x[kept] = curve.x.back();
      curve.y[kept++] = curve.y.back();
    }
    curve.x.resize(kept);
    curve.y.resize(kept);
  }
}

CurvePanel strip(const Strip& place, double right, double period, const std::string& yTitle) {
  CurvePanel panel;
  panel.left = kLeft;
  panel.right = right;
  panel.bottom = place.bottom;
  panel.top = place.top;
  panel.xRange = scene::ValueRange{0, period};
  panel.yTitle = yTitle;
  panel.xLabels = false;
  panel.cursor = true;
  return panel;
}

/// A beat as it is drawn: from before the P wave on.
class DrawnBeat {
public:
  explicit DrawnBeat(const ShownCirculation& shown)
      : beat_(shown.beat),
        first_(circulation::firstDrawn(shown.parameters, shown.beat, heart::kBeforeAtria)) {}

  /// A curve of the solved beat over the time since the drawn one began.
  PanelCurve curve(const std::string& name, const Vec3& color, const std::vector<double>& values,
                   float width = 2) const {
    return {name, color, beat_.time, circulation::drawnFrom(first_, values), width};
  }
  /// The time at which an instant of the solved beat is drawn, s.
  double at(double seconds) const {
    const double since = seconds - beat_.time[first_];
    return since - beat_.period * std::floor(since / beat_.period);
  }

private:
  const circulation::Beat& beat_;
  std::size_t first_;
};

/// A bar for each time in which the valve is open.
void addOpenTimes(CurvePanel& panel, const ShownCirculation& shown, Valve valve, double height,
                  const Vec3& color) {
  const DrawnBeat drawn(shown);
  const auto add = [&](double from, double to) {
    panel.curves.push_back({"", color, {from, to}, {height, height}, kBarWidth});
  };
  for (const circulation::ValveTimes& times : circulation::openTimes(shown.beat, valve)) {
    const double from = drawn.at(times.opens), to = drawn.at(times.shuts);
    if (from < to)
      add(from, to);
    else { // Over the end of what is drawn.
      add(from, shown.beat.period);
      add(0, to);
    }
  }
}

/// The first and the second heart sound: where the mitral and the aortic valve shut.
std::vector<scene::PanelMark> soundMarks(const ShownCirculation& shown) {
  const DrawnBeat drawn(shown);
  std::vector<scene::PanelMark> marks;
  const auto add = [&](const char* name, Valve valve) {
    if (const auto& times = shown.indices.valves[static_cast<std::size_t>(valve)])
      marks.push_back({drawn.at(times->shuts), name});
  };
  add("S1", Valve::mitral);
  add("S2", Valve::aortic);
  return marks;
}

PanelCurve relation(const std::string& name, double from, double to,
                    const std::function<double(double)>& pressure) {
  PanelCurve curve{name, kRelation, {}, {}, kThin};
  for (int i = 0; i <= kRelationPoints; ++i) {
    const double volume = from + (to - from) * i / kRelationPoints;
    curve.x.push_back(volume);
    curve.y.push_back(pressure(volume));
  }
  return curve;
}

double highest(const ShownCirculation& shown, Compartment ventricle) {
  return shown.indices.of(ventricle).highestMmHg;
}

CurvePanel loopPanel(const ShownCirculation& shown, const ShownCirculation* before, Compartment ventricle,
                     const circulation::Chamber& chamber, const std::string& name, const Vec3& color) {
  CurvePanel panel;
  panel.xTitle = name + " volume (ml)";
  panel.yTitle = "Pressure (mmHg)";
  panel.legend = true;
  double top = highest(shown, ventricle);
  double fullest = shown.indices.of(ventricle).edvMl;
  if (before) {
    panel.curves.push_back({before->name.english(), kBefore, before->beat.volumeOf(ventricle),
                            before->beat.pressureOf(ventricle), 2, true});
    top = std::max(top, highest(*before, ventricle));
    fullest = std::max(fullest, before->indices.of(ventricle).edvMl);
  }
  panel.curves.push_back(
      {shown.name.english(), color, shown.beat.volumeOf(ventricle), shown.beat.pressureOf(ventricle), 2.5F});
  const double pericardium = shown.beat.pericardium.front();
  top *= 1.12;
  fullest *= 1.08;
  panel.curves.push_back(relation(
      "ESPVR and EDPVR", chamber.v0, std::min(fullest, chamber.v0 + (top - pericardium) / chamber.ees),
      [&](double v) { return pericardium + circulation::endSystolicPressure(chamber, v); }));
  const double steepest = chamber.v0 + std::log1p((top - pericardium) / chamber.a) / chamber.b;
  panel.curves.push_back(relation("", chamber.v0, std::min(fullest, steepest), [&](double v) {
    return pericardium + circulation::relaxedPressure(chamber, v);
  }));
  panel.xRange = scene::ValueRange{0, fullest};
  panel.yRange = scene::ValueRange{0, top};
  return panel;
}

std::string numbers(const ShownCirculation& shown) {
  const auto& indices = shown.indices;
  return shown.name.english() + ": EF " + fixed(indices.of(Compartment::lv).ef, 2) + ", stroke volume " +
         fixed(indices.of(Compartment::lv).svMl, 0) + " ml, " + fixed(indices.cardiacOutputLMin, 1) +
         " l/min, aorta " + fixed(indices.aorta.systolic, 0) + "/" + fixed(indices.aorta.diastolic, 0) +
         " mmHg";
}

/// The rows of a strip that are chosen, from above. The lowest has the axis of time; where the sounds are not
/// drawn, the lowest with marks has their names.
std::vector<CurvePanel> wiggersRows(const ShownCirculation& shown, const HeartSigns& signs) {
  std::vector<CurvePanel> all = wiggersPanels(shown, 1), rows;
  const CurvePanel lowest = all.back();
  // Titles as long as their axes.
  all[0].yTitle = "mmHg";
  all[1].yTitle = "open";
  all[2].yTitle = "LV (ml)";
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].mostYTicks = kStripRows[i].ticks;
    if (signs.*kStripRows[i].chosen)
      rows.push_back(std::move(all[i]));
  }
  if (rows.empty())
    return rows;
  rows.back().xLabels = true;
  rows.back().xTitle = lowest.xTitle;
  const auto marked =
      std::find_if(rows.rbegin(), rows.rend(), [](const CurvePanel& row) { return !row.marks.empty(); });
  if (marked != rows.rend())
    marked->marks = lowest.marks;
  return rows;
}

/// Gives the rows their places in the left `part` of the width, below each other.
void placeRows(std::vector<CurvePanel>& rows, const StripLook& look, const StripRoom& room, double part) {
  std::vector<double> shares;
  for (const StripRow& row : kStripRows)
    if (look.signs.*row.chosen)
      shares.push_back(row.height);
  const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
  const double gap = room.partOfHeight(kStripGap), bottom = room.partOfHeight(kStripBottom);
  double top = 1 - room.partOfHeight(kStripTop);
  const double usable = top - bottom - gap * (static_cast<double>(rows.size()) - 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].left = room.partOfWidth(kStripLeft);
    rows[i].right = part < 1 ? part : 1 - room.partOfWidth(kStripRight);
    rows[i].top = top;
    top -= usable * shares[i] / all;
    rows[i].bottom = top;
    top -= gap;
  }
}

/// The loops of both ventricles beside each other, in the width right of `from`.
std::vector<CurvePanel> placedLoops(const ShownCirculation& shown, const ShownCirculation* before,
                                    const StripRoom& room, double from) {
  std::vector<CurvePanel> loops = loopPanels(shown, before, 0);
  const double axis = room.partOfWidth(kStripLeft);
  const double each = (1 - from - 2 * axis - room.partOfWidth(kStripRight)) / 2;
  double left = from + axis;
  const char* title = "LV (ml)";
  for (CurvePanel& panel : loops) {
    panel.left = left;
    panel.right = left + each;
    panel.bottom = room.partOfHeight(kStripBottom);
    panel.top = 1 - room.partOfHeight(kStripTop);
    panel.mostXTicks = panel.mostYTicks = kFewTicks;
    panel.xTitle = title;
    title = "RV (ml)";
    left += each + axis;
  }
  return loops;
}

/// The place in the window of a point in the axes of a panel with both ranges; that of its lower left corner
/// along an axis without one.
scene::InstantMarks::Ring placeIn(const CurvePanel& panel, double x, double y) {
  const auto between = [](double from, double to, const std::optional<scene::ValueRange>& range,
                          double value) {
    return range && range->high > range->low
               ? from + (to - from) * (value - range->low) / (range->high - range->low)
               : from;
  };
  return {between(panel.left, panel.right, panel.xRange, x),
          between(panel.bottom, panel.top, panel.yRange, y)};
}

} // namespace

std::vector<CurvePanel> wiggersPanels(const ShownCirculation& shown, double right) {
  const circulation::Beat& beat = shown.beat;
  const DrawnBeat drawn(shown);
  CurvePanel pressures = strip(kPressures, right, beat.period, "Pressure (mmHg)");
  pressures.title = numbers(shown);
  pressures.legend = true;
  pressures.curves = {drawn.curve("Left ventricle", kVentricle, beat.pressureOf(Compartment::lv)),
                      drawn.curve("Aorta", kArtery, beat.pressureOf(Compartment::systemicArteries)),
                      drawn.curve("Left atrium", kAtrium, beat.pressureOf(Compartment::la))};
  // The legend lies over the curves' end: room above them.
  pressures.yRange = scene::ValueRange{0, kRoomForLegend * highest(shown, Compartment::lv)};
  CurvePanel valves = strip(kValves, right, beat.period, "Open");
  valves.yRange = scene::ValueRange{0, 3};
  valves.yLabels = false;
  addOpenTimes(valves, shown, Valve::aortic, 2, kArtery);
  addOpenTimes(valves, shown, Valve::mitral, 1, kAtrium);
  CurvePanel volume = strip(kVolume, right, beat.period, "LV (ml)");
  volume.curves = {drawn.curve("", kVentricle, beat.volumeOf(Compartment::lv))};
  CurvePanel ecg = strip(kEcg, right, beat.period, "ECG");
  ecg.yLabels = false;
  std::vector<double> trace;
  for (const double seconds : beat.time)
    trace.push_back(circulation::electrocardiogram(shown.parameters, seconds));
  ecg.curves = {drawn.curve("", kSign, trace, kThin)};
  CurvePanel sound = strip(kSound, right, beat.period, "Sound");
  sound.curves = {
      drawn.curve("", kSign, circulation::phonocardiogram(shown.parameters, beat, shown.indices), kThin)};
  double loudest = 1;
  for (const double value : sound.curves.front().y)
    loudest = std::max(loudest, std::abs(value));
  // The sounds are named above their curve.
  sound.yRange = scene::ValueRange{-kBelowSounds * loudest, kAboveSounds * loudest};
  sound.yLabels = false;
  sound.xLabels = true;
  sound.xTitle = "Time (s)";
  for (CurvePanel* panel : {&pressures, &valves, &sound})
    panel->marks = soundMarks(shown);
  for (scene::PanelMark& mark : pressures.marks)
    mark.text.clear(); // They are named beside the sounds.
  for (scene::PanelMark& mark : valves.marks)
    mark.text.clear();
  return {pressures, valves, volume, ecg, sound};
}

std::vector<CurvePanel> loopPanels(const ShownCirculation& shown, const ShownCirculation* before,
                                   double left) {
  CurvePanel upper =
      loopPanel(shown, before, Compartment::lv, shown.parameters.lv, "Left ventricular", kVentricle);
  CurvePanel lower =
      loopPanel(shown, before, Compartment::rv, shown.parameters.rv, "Right ventricular", kRight);
  upper.left = lower.left = left;
  upper.right = lower.right = 0.98;
  upper.bottom = 0.44;
  upper.top = 0.95;
  lower.bottom = 0.065;
  lower.top = 0.35;
  return {upper, lower};
}

std::vector<CurvePanel> circulationStrip(const ShownCirculation& shown, const ShownCirculation* before,
                                         const StripLook& look) {
  const StripRoom room(look.width, look.height, look.typeScale);
  std::vector<CurvePanel> panels = wiggersRows(shown, look.signs);
  const double part = panels.empty() ? 0 : look.signs.loops ? kWiggersPart : 1;
  placeRows(panels, look, room, part);
  if (look.signs.loops)
    for (CurvePanel& panel : placedLoops(shown, before, room, part))
      panels.push_back(std::move(panel));
  for (CurvePanel& panel : panels) {
    panel.title.clear();
    if (panel.legend && panel.cursor)
      panel.yRange.reset(); // The legend stands above the strip.
    panel.legend = false;
    for (PanelCurve& curve : panel.curves)
      thin(curve);
  }
  return panels;
}

double stripTypeScale(int width, int height) {
  return std::clamp(std::min(width / kUsualStripWidth, height / kUsualStripHeight), kLeastStripType,
                    scene::kLectureTypeScale);
}

scene::InstantMarks instantMarks(const std::vector<CurvePanel>& strip, const ShownCirculation& shown,
                                 double fraction) {
  const circulation::Beat& beat = shown.beat;
  const std::size_t count = beat.time.size() - 1;
  const double passed = std::clamp(fraction, 0.0, 1.0);
  const std::size_t sample = (circulation::firstDrawn(shown.parameters, beat, heart::kBeforeAtria) +
                              static_cast<std::size_t>(std::lround(passed * static_cast<double>(count)))) %
                             count;
  scene::InstantMarks marks;
  Compartment ventricle = Compartment::lv;
  for (const CurvePanel& panel : strip) {
    if (panel.cursor) {
      marks.lines.push_back({placeIn(panel, passed * beat.period, 0).x, panel.bottom, panel.top});
      continue;
    }
    marks.rings.push_back(
        placeIn(panel, beat.volumeOf(ventricle)[sample], beat.pressureOf(ventricle)[sample]));
    ventricle = Compartment::rv; // The left ventricle's loop is first.
  }
  return marks;
}

std::vector<CirculationLine> circulationLegend(const ShownCirculation* before) {
  std::vector<CirculationLine> lines = {{"Left ventricle", kVentricle},
                                        {"Aorta", kArtery},
                                        {"Left atrium", kAtrium},
                                        {"Right ventricle", kRight},
                                        {"ESPVR and EDPVR", kRelation}};
  if (before)
    lines.push_back({before->name, kBefore, true});
  return lines;
}

std::vector<CurvePanel> circulationFigure(const ShownCirculation& shown, const ShownCirculation* before) {
  std::vector<CurvePanel> panels = wiggersPanels(shown, 0.58);
  for (CurvePanel& panel : loopPanels(shown, before, 0.65)) {
    panel.yRange->high *= kRoomForLoopLegend;
    panels.push_back(std::move(panel));
  }
  return panels;
}

} // namespace viscera::presentation
