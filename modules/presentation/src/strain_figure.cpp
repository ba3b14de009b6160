#include "viscera/presentation/strain_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include <vtkImageData.h>
#include <vtkRenderWindow.h>

#include "viscera/scene/picture.h"
#include "viscera/scene/surfaceless_window.h"
#include "viscera/strain/aha_segments.h"

namespace viscera::presentation {
namespace {

using live::StrainDirection;
using live::StrainMoment;

constexpr double kPercentOfPart = 100, kMsOfSecond = 1000;
// Safe for people who do not tell red from green (Okabe and Ito).
const Vec3 kAlongColor(0.84, 0.37, 0.0), kAroundColor(0.0, 0.45, 0.70), kAcrossColor(0.0, 0.62, 0.45);
/// Ends of the scales of colours, per cent.
constexpr double kShortening = 30, kThickening = 60, kDifference = 15;

/// Red to one side, blue to the other, white at zero: safe for people who do not tell red from green. Of
/// shortening, which is negative, the low end is red, as clinics draw strain.
scene::ColorMap strainColors(bool lowIsRed) {
  constexpr int kHalf = 128;
  const Vec3 white(255, 255, 255), red(178, 24, 43), blue(33, 102, 172);
  scene::ColorMap map;
  map.name = "strain";
  map.colors.resize(2 * kHalf + 1, 3);
  for (int i = -kHalf; i <= kHalf; ++i) {
    const bool isRed = (i < 0) == lowIsRed;
    const double part = std::pow(std::abs(i) / static_cast<double>(kHalf), 0.85);
    const Vec3 color = (1 - part) * white + part * (isRed ? red : blue);
    map.colors.row(i + kHalf) = color.array().round().cast<std::uint8_t>().matrix().transpose();
  }
  return map;
}

scene::BullsEyeFigure emptyFigure() {
  scene::BullsEyeFigure figure;
  figure.unit = "%";
  figure.sides = {"lateral", "anterior", "septal", "inferior"};
  for (const strain::Segment& segment : strain::segments()) {
    scene::BullsEyeSector sector;
    sector.ring = segment.ring;
    sector.fromDegrees = segment.fromDegrees;
    sector.toDegrees = segment.toDegrees;
    figure.sectors.push_back(sector);
  }
  return figure;
}

/// Says what hatching means below a figure that has some.
scene::BullsEyeFigure withNote(scene::BullsEyeFigure figure) {
  const bool hatched = std::any_of(figure.sectors.begin(), figure.sectors.end(),
                                   [](const scene::BullsEyeSector& sector) { return sector.hatched; });
  figure.note = hatched ? "hatched: uncertain" : "";
  return figure;
}

/// Whether a difference of two peaks is larger than what both fits leave uncertain together.
bool differenceKnown(const live::StrainReading& reading, const live::StrainReading& before, int segment,
                     StrainDirection direction, const std::optional<double>& difference) {
  if (!reading.reliable(reading.strain.segment(segment)) || !before.reliable(before.strain.segment(segment)))
    return false;
  const double both = std::hypot(live::strainDeviation(reading, segment, direction).value_or(0),
                                 live::strainDeviation(before, segment, direction).value_or(0));
  return !difference || both == 0 || both <= std::abs(*difference);
}

scene::PanelCurve panelCurve(const std::string& name, const Vec3& color, const std::vector<double>& seconds,
                             const std::vector<double>& parts) {
  scene::PanelCurve curve{name, color, seconds, {}, 2.2F, false};
  for (const double part : parts)
    curve.y.push_back(kPercentOfPart * part);
  return curve;
}

/// A picture that a figure fills alone.
template <class Figure>
vtkSmartPointer<vtkImageData> pictureOf(const StrainPicture& wanted, int height, Figure& figure) {
  scene::SurfacelessWindow window(wanted.width, height);
  figure.setWindow(window.window());
  figure.setTheme(wanted.theme);
  figure.update();
  vtkSmartPointer<vtkImageData> picture = scene::grabPicture(window.window());
  figure.setWindow(nullptr);
  return picture;
}

} // namespace

const char* titleOf(StrainDirection direction) {
  switch (direction) {
  case StrainDirection::longitudinal:
    return "Longitudinal strain";
  case StrainDirection::circumferential:
    return "Circumferential strain";
  case StrainDirection::radial:
    return "Radial strain";
  case StrainDirection::thickening:
    return "Thickening";
  }
  return "";
}

scene::BullsEyeFigure strainBullsEye(const live::StrainReading& reading, StrainDirection direction,
                                     StrainMoment moment, std::size_t phase) {
  scene::BullsEyeFigure figure = emptyFigure();
  figure.title = titleOf(direction);
  const bool thickens = direction == StrainDirection::radial || direction == StrainDirection::thickening;
  const double end = thickens ? kThickening : kShortening;
  figure.range = {-end, end};
  figure.colors = strainColors(!thickens);
  if (moment == StrainMoment::timeToPeak) {
    figure.unit = "ms";
    figure.colors = scene::colorMapByName("cividis");
    figure.range = {0, std::max(1.0, kMsOfSecond * reading.strain.seconds.back())};
  }
  for (const strain::Segment& segment : strain::segments()) {
    scene::BullsEyeSector& sector = figure.sectors[static_cast<std::size_t>(segment.number - 1)];
    sector.value = live::strainValue(reading, segment.number, direction, moment, phase);
    sector.hatched = moment == StrainMoment::timeToPeak
                         ? !reading.reliable(reading.strain.segment(segment.number))
                         : !live::reliablePeak(reading, segment.number, direction);
  }
  return withNote(std::move(figure));
}

scene::BullsEyeFigure strainDifference(const live::StrainReading& reading, const live::StrainReading& before,
                                       StrainDirection direction) {
  scene::BullsEyeFigure figure = strainBullsEye(reading, direction, StrainMoment::peak);
  figure.title = "Difference of both";
  figure.range = {-kDifference, kDifference};
  for (const strain::Segment& segment : strain::segments()) {
    scene::BullsEyeSector& sector = figure.sectors[static_cast<std::size_t>(segment.number - 1)];
    const std::optional<double> other =
        live::strainValue(before, segment.number, direction, StrainMoment::peak);
    sector.value = sector.value && other ? std::optional(*sector.value - *other) : std::nullopt;
    sector.hatched = !differenceKnown(reading, before, segment.number, direction, sector.value);
  }
  return withNote(std::move(figure));
}

std::vector<GlobalStrain> globalStrains(const live::StrainReading& reading) {
  const strain::HeartStrain& strain = reading.strain;
  std::vector<GlobalStrain> known;
  const auto add = [&](const char* name, const Vec3& color, const char* norm,
                       const std::optional<strain::ContourStrain>& contour) {
    if (!contour)
      return;
    const anatomy::Norm& healthy = anatomy::norm(norm);
    known.push_back({name, color, kPercentOfPart * contour->peak.value, kMsOfSecond * contour->peak.seconds,
                     anatomy::rangeOf(healthy), &healthy});
  };
  add("GLS", kAlongColor, "lv.gls", strain.gls);
  add("GCS", kAroundColor, "lv.gcs", strain.gcs);
  add("GRS", kAcrossColor, "lv.grs", strain.grs);
  return known;
}

scene::CurvePanel strainPanel(const live::StrainReading& reading, int segment, StrainDirection direction) {
  const strain::HeartStrain& strain = reading.strain;
  scene::CurvePanel panel;
  panel.xTitle = "Time (s)";
  panel.yTitle = "Strain (%)";
  panel.legend = true;
  panel.left = 0.09;
  panel.right = 0.97;
  panel.bottom = 0.17;
  panel.top = 0.95;
  const auto add = [&](const char* name, const Vec3& color,
                       const std::optional<strain::ContourStrain>& contour) {
    if (contour)
      panel.curves.push_back(panelCurve(name, color, strain.seconds, contour->curve));
  };
  add("GLS", kAlongColor, strain.gls);
  add("GCS", kAroundColor, strain.gcs);
  add("GRS", kAcrossColor, strain.grs);
  add("RV free wall", Vec3(0.80, 0.24, 0.48), strain.rightFreeWall);
  add("Left atrium", Vec3(0.90, 0.62, 0.0), strain.leftReservoir);
  for (const GlobalStrain& global : globalStrains(reading))
    panel.bands.push_back({{global.healthyPercent.low, global.healthyPercent.high}, global.color});
  if (segment < 1 || segment > strain::kSegments)
    return panel;
  const std::vector<double>& curve = live::strainCurve(strain.segment(segment), direction);
  if (!curve.empty()) {
    const Vec3 color = direction == StrainDirection::longitudinal      ? kAlongColor
                       : direction == StrainDirection::circumferential ? kAroundColor
                                                                       : kAcrossColor;
    panel.curves.push_back(panelCurve(std::to_string(segment), color, strain.seconds, curve));
    panel.curves.back().dashed = true;
  }
  return panel;
}

void translate(scene::BullsEyeFigure& figure, const std::function<std::string(const std::string&)>& words) {
  if (!words)
    return;
  figure.title = words(figure.title);
  for (std::string& side : figure.sides)
    side = words(side);
  if (!figure.note.empty())
    figure.note = words(figure.note);
}

void translate(scene::CurvePanel& panel, const std::function<std::string(const std::string&)>& words) {
  if (!words)
    return;
  panel.xTitle = words(panel.xTitle);
  panel.yTitle = words(panel.yTitle);
  for (scene::PanelCurve& curve : panel.curves)
    curve.name = words(curve.name);
}

void writeStrainPicture(const std::filesystem::path& file, const live::StrainReading& reading,
                        const StrainPicture& picture) {
  std::vector<scene::BullsEyeFigure> figures;
  for (const StrainDirection direction :
       {StrainDirection::longitudinal, StrainDirection::circumferential, StrainDirection::radial})
    if (direction != StrainDirection::radial || reading.strain.wall) {
      figures.push_back(strainBullsEye(reading, direction, StrainMoment::peak));
      translate(figures.back(), picture.translate);
    }
  scene::CurvePanel curves = strainPanel(reading);
  translate(curves, picture.translate);
  scene::BullsEyes eyes;
  eyes.setFigures(std::move(figures));
  scene::CurvePanels panels;
  panels.setPanels({std::move(curves)});
  const int half = picture.height / 2;
  scene::writeSmallPng(
      file, scene::contactSheet({pictureOf(picture, half, eyes), pictureOf(picture, half, panels)}, 1));
}

Values strainOnSurface(const scene::BullsEyeFigure& figure, const std::vector<int>& segments, int chosen) {
  Values values =
      Values::Constant(static_cast<Eigen::Index>(segments.size()), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const int segment = segments[i];
    if (segment < 1 || (chosen > 0 && segment != chosen))
      continue;
    if (const auto& value = figure.sectors[static_cast<std::size_t>(segment - 1)].value)
      values[static_cast<Eigen::Index>(i)] = *value;
  }
  return values;
}

} // namespace viscera::presentation
