#pragma once

#include <algorithm>
#include <cmath>

#include <vtkPen.h>

#include "viscera/core/arrays.h"

/// Converts colours for the pens of VTK's charts.
namespace viscera::scene {

/// 0 to 1 as 0 to 255.
inline unsigned char byteOf(double part) {
  return static_cast<unsigned char>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
}

inline void setPen(vtkPen* pen, const Vec3& color, double opacity) {
  pen->SetColor(byteOf(color.x()), byteOf(color.y()), byteOf(color.z()), byteOf(opacity));
}

} // namespace viscera::scene
