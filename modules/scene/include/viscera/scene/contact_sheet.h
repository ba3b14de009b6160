#pragma once

#include <vector>

#include <vtkSmartPointer.h>

class vtkImageData;

namespace viscera::scene {

/// Pictures of one size side by side and below each other, row by row from the upper left; places that are
/// left over in the last row have the colour of the last picture's first pixel. `columns` at least 1, at most
/// as many as there are pictures are used. Throws `UsageError` without pictures or for pictures of different
/// sizes.
vtkSmartPointer<vtkImageData> contactSheet(const std::vector<vtkSmartPointer<vtkImageData>>& pictures,
                                           int columns);

} // namespace viscera::scene
