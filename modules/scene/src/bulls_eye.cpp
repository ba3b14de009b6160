#include "viscera/scene/bulls_eye.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <vtkAbstractContextItem.h>
#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkWeakPointer.h>

#include "viscera/core/text.h"
#include "viscera/scene/organ_view.h"

#include "chart_pen.h"
#include "text_guard.h"

namespace viscera::scene {
namespace {

constexpr int kTitlePixels = 16, kValuePixels = 13, kSidePixels = 12;
constexpr double kScaleWidth = 14; ///< Of the scale of colours, pixels.
constexpr double kScaleRoom = 62;  ///< With its numbers.
constexpr double kSideRoom = 20;   ///< Of the name of a side, pixels.
constexpr double kTitleRoom = 24;  ///< Above the side's name, where there is a title.
constexpr double kNoteRoom = 16;   ///< Below the side's name, where there is a note.
constexpr int kLeastValuePixels = 8;
constexpr double kValuePart = 0.62; ///< Of a ring's width that a value's type may take.
constexpr double kHatchDegrees = 5;
constexpr int kScaleSteps = 128;
constexpr double kFull = 360;

/// The place of a figure in the window, pixels.
struct Place {
  double x = 0, y = 0; ///< Of the middle.
  double radius = 0;
  double right = 0; ///< Where the scale of colours begins.
};

std::array<std::uint8_t, 3> colorAt(const BullsEyeFigure& figure, double value) {
  const double part = std::clamp(partOf(figure.range, value), 0.0, 1.0);
  const auto row =
      static_cast<Eigen::Index>(std::lround(part * static_cast<double>(figure.colors.colors.rows() - 1)));
  return {figure.colors.colors(row, 0), figure.colors.colors(row, 1), figure.colors.colors(row, 2)};
}

/// Whether dark type is read better on a colour.
bool isLight(const std::array<std::uint8_t, 3>& color) {
  return 0.299 * color[0] + 0.587 * color[1] + 0.114 * color[2] > 140;
}

/// The rings' radii: the innermost is a disc.
std::pair<double, double> radiiOf(const BullsEyeFigure& figure, const BullsEyeSector& sector, double radius) {
  const double step = radius / figure.rings;
  const double outer = radius - sector.ring * step;
  return {std::max(0.0, outer - step), outer};
}

class BullsEyeItem : public vtkAbstractContextItem {
public:
  static BullsEyeItem* New();
  vtkTypeMacro(BullsEyeItem, vtkAbstractContextItem)

      bool Paint(vtkContext2D* painter) override;

  std::vector<BullsEyeFigure> figures;
  std::vector<Place> places;
  Theme theme = lightTheme();
  double ratio = 1;

private:
  void paintFigure(vtkContext2D* painter, const BullsEyeFigure& figure, const Place& place) const;
  void paintSector(vtkContext2D* painter, const BullsEyeFigure& figure, const BullsEyeSector& sector,
                   const Place& place) const;
  void paintHatch(vtkContext2D* painter, const BullsEyeSector& sector, const Place& place, double inner,
                  double outer) const;
  void paintScale(vtkContext2D* painter, const BullsEyeFigure& figure, const Place& place) const;
  void paintWords(vtkContext2D* painter, const BullsEyeFigure& figure, const Place& place) const;
  void setText(vtkContext2D* painter, int pixels, const Vec3& color, bool bold = false) const;
};
vtkStandardNewMacro(BullsEyeItem);

void BullsEyeItem::setText(vtkContext2D* painter, int pixels, const Vec3& color, bool bold) const {
  vtkTextProperty* text = painter->GetTextProp();
  text->SetFontFamilyToArial();
  text->SetFontSize(static_cast<int>(std::lround(pixels)));
  text->SetColor(color.x(), color.y(), color.z());
  text->SetBold(bold ? 1 : 0);
  text->SetJustificationToCentered();
  text->SetVerticalJustificationToCentered();
}

bool BullsEyeItem::Paint(vtkContext2D* painter) {
  for (std::size_t i = 0; i < figures.size() && i < places.size(); ++i)
    paintFigure(painter, figures[i], places[i]);
  return true;
}

void BullsEyeItem::paintFigure(vtkContext2D* painter, const BullsEyeFigure& figure,
                               const Place& place) const {
  for (const BullsEyeSector& sector : figure.sectors)
    paintSector(painter, figure, sector, place);
  if (figure.selected >= 0 && figure.selected < static_cast<int>(figure.sectors.size())) {
    const BullsEyeSector& sector = figure.sectors[static_cast<std::size_t>(figure.selected)];
    const auto [inner, outer] = radiiOf(figure, sector, place.radius);
    setPen(painter->GetPen(), theme.accent, 1);
    painter->GetPen()->SetWidth(static_cast<float>(3 * ratio));
    for (const double radius : {inner, outer})
      painter->DrawEllipticArc(static_cast<float>(place.x), static_cast<float>(place.y),
                               static_cast<float>(radius), static_cast<float>(radius),
                               static_cast<float>(sector.fromDegrees), static_cast<float>(sector.toDegrees));
  }
  paintScale(painter, figure, place);
  paintWords(painter, figure, place);
}

void BullsEyeItem::paintSector(vtkContext2D* painter, const BullsEyeFigure& figure,
                               const BullsEyeSector& sector, const Place& place) const {
  const auto [inner, outer] = radiiOf(figure, sector, place.radius);
  const auto x = static_cast<float>(place.x), y = static_cast<float>(place.y);
  const std::array<std::uint8_t, 3> color =
      sector.value ? colorAt(figure, *sector.value) : figure.colors.missing;
  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  painter->GetBrush()->SetColor(color[0], color[1], color[2], 255);
  painter->DrawEllipseWedge(x, y, static_cast<float>(outer), static_cast<float>(outer),
                            static_cast<float>(inner), static_cast<float>(inner),
                            static_cast<float>(sector.fromDegrees), static_cast<float>(sector.toDegrees));
  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  if (sector.hatched || !sector.value)
    paintHatch(painter, sector, place, inner, outer);
  setPen(painter->GetPen(), theme.dark ? Vec3(0.1, 0.1, 0.12) : Vec3(0.25, 0.25, 0.28), 1);
  painter->GetPen()->SetWidth(static_cast<float>(1.2 * ratio));
  painter->DrawEllipticArc(x, y, static_cast<float>(outer), static_cast<float>(outer),
                           static_cast<float>(sector.fromDegrees), static_cast<float>(sector.toDegrees));
  const bool whole = sector.toDegrees - sector.fromDegrees >= kFull;
  for (const double degrees : {sector.fromDegrees, sector.toDegrees}) {
    if (whole)
      continue;
    const double angle = degrees * std::numbers::pi / 180;
    painter->DrawLine(static_cast<float>(place.x + inner * std::cos(angle)),
                      static_cast<float>(place.y + inner * std::sin(angle)),
                      static_cast<float>(place.x + outer * std::cos(angle)),
                      static_cast<float>(place.y + outer * std::sin(angle)));
  }
  if (!sector.value)
    return;
  const double middle = (sector.fromDegrees + sector.toDegrees) / 2 * std::numbers::pi / 180;
  const double at = whole ? 0 : (inner + outer) / 2;
  const int type =
      std::clamp(static_cast<int>(kValuePart * (outer - inner) / ratio), kLeastValuePixels, kValuePixels);
  setText(painter, type, isLight(color) ? Vec3(0.05, 0.05, 0.08) : Vec3(1, 1, 1));
  painter->DrawString(static_cast<float>(place.x + at * std::cos(middle)),
                      static_cast<float>(place.y + at * std::sin(middle)),
                      fixed(*sector.value, figure.decimals));
}

void BullsEyeItem::paintHatch(vtkContext2D* painter, const BullsEyeSector& sector, const Place& place,
                              double inner, double outer) const {
  setPen(painter->GetPen(), Vec3(0.35, 0.35, 0.38), 1);
  painter->GetPen()->SetWidth(static_cast<float>(0.7 * ratio));
  for (double degrees = sector.fromDegrees + kHatchDegrees / 2; degrees < sector.toDegrees;
       degrees += kHatchDegrees) {
    const double angle = degrees * std::numbers::pi / 180;
    painter->DrawLine(static_cast<float>(place.x + inner * std::cos(angle)),
                      static_cast<float>(place.y + inner * std::sin(angle)),
                      static_cast<float>(place.x + outer * std::cos(angle)),
                      static_cast<float>(place.y + outer * std::sin(angle)));
  }
}

void BullsEyeItem::paintScale(vtkContext2D* painter, const BullsEyeFigure& figure, const Place& place) const {
  const double low = place.y - place.radius, height = 2 * place.radius;
  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  for (int step = 0; step < kScaleSteps; ++step) {
    const double part = (step + 0.5) / kScaleSteps;
    const auto color = colorAt(figure, valueAt(figure.range, part));
    painter->GetBrush()->SetColor(color[0], color[1], color[2], 255);
    painter->DrawRect(static_cast<float>(place.right), static_cast<float>(low + height * step / kScaleSteps),
                      static_cast<float>(kScaleWidth * ratio), static_cast<float>(height / kScaleSteps + 1));
  }
  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  setText(painter, kSidePixels, theme.text);
  painter->GetTextProp()->SetJustificationToLeft();
  for (const double part : {0.0, 0.5, 1.0})
    painter->DrawString(static_cast<float>(place.right + (kScaleWidth + 5) * ratio),
                        static_cast<float>(low + part * height),
                        fixed(valueAt(figure.range, part), figure.decimals) +
                            (part == 1 && !figure.unit.empty() ? " " + figure.unit : ""));
}

void BullsEyeItem::paintWords(vtkContext2D* painter, const BullsEyeFigure& figure, const Place& place) const {
  setText(painter, kTitlePixels, theme.text, true);
  painter->DrawString(static_cast<float>(place.x),
                      static_cast<float>(place.y + place.radius + (kSideRoom + 0.45 * kTitleRoom) * ratio),
                      figure.title);
  setText(painter, kSidePixels, theme.text);
  const double gap = 10 * ratio;
  for (std::size_t side = 0; side < figure.sides.size() && side < 4; ++side) {
    const double angle = static_cast<double>(side) * std::numbers::pi / 2;
    painter->GetTextProp()->SetOrientation(side == 0 ? -90 : side == 2 ? 90 : 0);
    painter->DrawString(static_cast<float>(place.x + (place.radius + gap) * std::cos(angle)),
                        static_cast<float>(place.y + (place.radius + gap) * std::sin(angle)),
                        figure.sides[side]);
  }
  painter->GetTextProp()->SetOrientation(0);
  if (!figure.note.empty())
    painter->DrawString(static_cast<float>(place.x),
                        static_cast<float>(place.y - place.radius - (kSideRoom + 0.4 * kNoteRoom) * ratio),
                        figure.note);
}

} // namespace

struct BullsEyes::Parts {
  vtkNew<vtkRenderer> renderer;
  vtkNew<ChartActor> actor;
  vtkNew<BullsEyeItem> item;
  vtkWeakPointer<vtkRenderWindow> window;
};

BullsEyes::BullsEyes() : parts_((guardText(), std::make_unique<Parts>())) {
  parts_->actor->GetScene()->SetRenderer(parts_->renderer);
  parts_->actor->GetScene()->AddItem(parts_->item);
  parts_->renderer->AddViewProp(parts_->actor);
  setTheme(parts_->item->theme);
}

BullsEyes::~BullsEyes() {
  setWindow(nullptr);
}

void BullsEyes::setWindow(vtkRenderWindow* window) {
  auto& p = *parts_;
  if (p.window)
    p.window->RemoveRenderer(p.renderer);
  p.window = window;
  if (!window)
    return;
  window->SetMultiSamples(8);
  window->AddRenderer(p.renderer);
}

void BullsEyes::setTheme(const Theme& theme) {
  parts_->item->theme = theme;
  parts_->renderer->SetBackground(theme.panel.data());
}

void BullsEyes::setFigures(std::vector<BullsEyeFigure> figures) {
  parts_->item->figures = std::move(figures);
}

void BullsEyes::update() {
  auto& p = *parts_;
  if (!p.window)
    return;
  const int* size = p.window->GetSize();
  p.item->ratio = pixelRatioOf(p.window);
  const std::size_t count = std::max<std::size_t>(1, p.item->figures.size());
  const double width = size[0] / static_cast<double>(count), height = size[1];
  const double ratio = p.item->ratio, sideRoom = kSideRoom * ratio;
  p.item->places.clear();
  for (std::size_t i = 0; i < p.item->figures.size(); ++i) {
    Place place;
    const BullsEyeFigure& figure = p.item->figures[i];
    const double above = sideRoom + (figure.title.empty() ? 0 : kTitleRoom * ratio);
    const double below = sideRoom + (figure.note.empty() ? 0 : kNoteRoom * ratio);
    const double across = width - kScaleRoom * ratio - 2 * sideRoom;
    place.radius = std::max(10.0, std::min(across, height - above - below) / 2);
    place.x = static_cast<double>(i) * width + (width - kScaleRoom * ratio) / 2;
    place.y = (height + below - above) / 2;
    place.right = place.x + place.radius + sideRoom;
    p.item->places.push_back(place);
  }
  p.actor->GetScene()->SetDirty(true);
}

std::optional<BullsEyes::Hit> BullsEyes::at(double x, double y) const {
  const BullsEyeItem& item = *parts_->item;
  for (std::size_t i = 0; i < item.places.size(); ++i) {
    const double dx = x - item.places[i].x, dy = y - item.places[i].y, distance = std::hypot(dx, dy);
    if (distance > item.places[i].radius)
      continue;
    const double degrees = std::atan2(dy, dx) * 180 / std::numbers::pi;
    for (std::size_t sector = 0; sector < item.figures[i].sectors.size(); ++sector) {
      const BullsEyeSector& each = item.figures[i].sectors[sector];
      const auto [inner, outer] = radiiOf(item.figures[i], each, item.places[i].radius);
      const double turned = std::fmod(degrees - each.fromDegrees + 2 * kFull, kFull);
      if (distance >= inner && distance < outer && turned < each.toDegrees - each.fromDegrees)
        return Hit{i, sector};
    }
  }
  return std::nullopt;
}

} // namespace viscera::scene
