#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>

class vtkImageData;
class vtkRenderWindow;

namespace viscera::scene {

/// Renders `window` and returns the picture: 8 bits, three components, first row at the bottom, as in VTK.
vtkSmartPointer<vtkImageData> grabPicture(vtkRenderWindow* window);

/// Writes a PNG: to a temporary file beside it first, then renamed. Throws `CannotCreateError`. May be called
/// from any thread with a picture of its own.
void writePng(const std::filesystem::path& file, vtkImageData* picture);

/// Writes a PNG as small as zlib makes it, for pictures that are kept. As `writePng` otherwise.
void writeSmallPng(const std::filesystem::path& file, vtkImageData* picture);

/// The bytes of the file that `writeSmallPng` would write. O(pixels).
std::string pngOf(vtkImageData* picture);

/// Renders and writes in one call.
void savePicture(vtkRenderWindow* window, const std::filesystem::path& file);

/// Reads a PNG as `grabPicture` would have given it. Throws `NoInputError` or `DataError`.
vtkSmartPointer<vtkImageData> readPng(const std::filesystem::path& file);

/// Pictures of one size side by side and below each other, row by row from the upper left; remaining places
/// in the last row have the colour of the last picture's first pixel. `columns` at least 1, at most as many
/// as there are pictures are used. Throws `UsageError` without pictures or for pictures of different sizes.
vtkSmartPointer<vtkImageData> contactSheet(const std::vector<vtkSmartPointer<vtkImageData>>& pictures,
                                           int columns);

/// The difference of two pictures: the part of differing pixels and the mean difference.
struct PictureDifference {
  double mean = 0;      ///< Mean absolute difference over pixels and channels, 0 to 255.
  double differing = 0; ///< Part of the pixels in which a channel differs by more than the threshold, 0 to 1.
};

/// Compares pictures of one size; of different sizes `differing` is 1 and `mean` 255.
PictureDifference comparePictures(vtkImageData* a, vtkImageData* b, int threshold = 24);

} // namespace viscera::scene
