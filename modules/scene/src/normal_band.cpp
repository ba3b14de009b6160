#include "normal_band.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>

namespace viscera::scene {

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

} // namespace viscera::scene
