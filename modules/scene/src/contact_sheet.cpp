#include "viscera/scene/contact_sheet.h"

#include <algorithm>
#include <cstddef>

#include <vtkImageData.h>

#include "viscera/core/error.h"

namespace viscera::scene {
namespace {

constexpr int kChannels = 3;

const unsigned char* rowOf(vtkImageData* picture, int y) {
  return static_cast<const unsigned char*>(picture->GetScalarPointer(0, y, 0));
}

} // namespace

vtkSmartPointer<vtkImageData> contactSheet(const std::vector<vtkSmartPointer<vtkImageData>>& pictures,
                                           int columns) {
  if (pictures.empty())
    throw UsageError("there is no picture to put on the sheet");
  const int* size = pictures.front()->GetDimensions();
  for (const auto& picture : pictures)
    if (!std::equal(size, size + 2, picture->GetDimensions()))
      throw UsageError("pictures of different sizes do not fit on one sheet");
  const int count = static_cast<int>(pictures.size());
  columns = std::clamp(columns, 1, count);
  const int rows = (count + columns - 1) / columns;
  const std::ptrdiff_t width = size[0];
  auto sheet = vtkSmartPointer<vtkImageData>::New();
  sheet->SetDimensions(columns * size[0], rows * size[1], 1);
  sheet->AllocateScalars(VTK_UNSIGNED_CHAR, kChannels);
  const unsigned char* ground = rowOf(pictures.back(), 0);
  for (int place = 0; place < rows * columns; ++place)
    for (int y = 0; y < size[1]; ++y) {
      // Rows of pixels run upwards, rows of pictures downwards.
      const int sheetY = (rows - 1 - place / columns) * size[1] + y;
      auto* to = static_cast<unsigned char*>(sheet->GetScalarPointer((place % columns) * size[0], sheetY, 0));
      if (place < count)
        std::copy_n(rowOf(pictures[static_cast<std::size_t>(place)], y), kChannels * width, to);
      else
        for (std::ptrdiff_t x = 0; x < width; ++x)
          std::copy_n(ground, kChannels, to + kChannels * x);
    }
  return sheet;
}

} // namespace viscera::scene
