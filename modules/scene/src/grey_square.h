#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>

#include "viscera/core/arrays.h"

namespace viscera::scene {

/// The geometry and texture of a rectangle with grey levels, for a 3D or a 2D actor.
class GreySquare {
public:
  GreySquare();

  vtkPolyData* data() { return data_; }
  vtkTexture* texture() { return texture_; }

  /// The outer corners: lower left, lower right, upper right, upper left.
  void setCorners(const std::array<Vec3, 4>& corners);
  /// `width * height` grey levels, row by row from the lower left.
  void setGrey(int width, int height, const std::vector<std::uint8_t>& grey);

private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkImageData> image_;
  vtkNew<vtkTexture> texture_;
};

} // namespace viscera::scene
