#include "normal_band.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>

namespace viscera::scene {
namespace {
constexpr double kLabelOpacity = 0.65;
constexpr double kLabelIndent = 0.008; ///< Of the width.
} // namespace

vtkStandardNewMacro(NormalBand);

void NormalBand::setExtent(ValueRange x, ValueRange y) {
  x_ = x;
  y_ = y;
  Modified();
}

void NormalBand::setLabel(const std::string& label, int size) {
  label_ = label;
  text_->SetFontSize(size);
  text_->SetFontFamilyToArial();
  text_->SetJustificationToLeft();
  text_->SetVerticalJustificationToCentered();
}

void NormalBand::setLabelColor(const Vec3& color) {
  text_->SetColor(color.x(), color.y(), color.z());
  text_->SetOpacity(kLabelOpacity);
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
  if (label_.empty())
    return true;
  painter->ApplyTextProp(text_);
  float box[4] = {0, 0, 0, 0};
  painter->ComputeStringBounds(label_, box);
  const double height = (y_.high - y_.low) * shiftScale.GetHeight();
  const double width = (x_.high - x_.low) * shiftScale.GetWidth();
  if (box[3] <= height)
    painter->DrawString(static_cast<float>(left + kLabelIndent * width),
                        static_cast<float>(bottom + height / 2), label_);
  return true;
}

void NormalBand::GetBounds(double bounds[4]) {
  bounds[0] = x_.low;
  bounds[1] = x_.high;
  bounds[2] = y_.low;
  bounds[3] = y_.high;
}

} // namespace viscera::scene
