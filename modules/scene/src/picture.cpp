#include "viscera/scene/picture.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <system_error>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::scene {
namespace {

/// Level 1 is three times as fast as zlib's default and a few per cent larger.
constexpr int kFastCompression = 1, kBestCompression = 9;

constexpr int kChannels = 3;

const unsigned char* rowOf(vtkImageData* picture, int y) {
  return static_cast<const unsigned char*>(picture->GetScalarPointer(0, y, 0));
}

void write(const std::filesystem::path& file, vtkImageData* picture, int compression) {
  AtomicFile output(file);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName(output.temporary().c_str());
  writer->SetCompressionLevel(compression);
  writer->GlobalWarningDisplayOff();
  writer->Write();
  if (writer->GetErrorCode() != 0)
    throw CannotCreateError("the picture cannot be written", file.string(),
                            "check that there is room on the disk");
  output.commit();
}

} // namespace

vtkSmartPointer<vtkImageData> grabPicture(vtkRenderWindow* window) {
  window->Render();
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  pixels->SetNumberOfComponents(3);
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, /*front=*/0, pixels);
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(size[0], size[1], 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy_n(pixels->GetPointer(0), pixels->GetNumberOfValues(),
              static_cast<unsigned char*>(picture->GetScalarPointer()));
  return picture;
}

void writePng(const std::filesystem::path& file, vtkImageData* picture) {
  write(file, picture, kFastCompression);
}

void writeSmallPng(const std::filesystem::path& file, vtkImageData* picture) {
  write(file, picture, kBestCompression);
}

std::string pngOf(vtkImageData* picture) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetCompressionLevel(kBestCompression);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
          static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

void savePicture(vtkRenderWindow* window, const std::filesystem::path& file) {
  writePng(file, grabPicture(window));
}

vtkSmartPointer<vtkImageData> readPng(const std::filesystem::path& file) {
  std::error_code unreachable;
  if (!std::filesystem::exists(file, unreachable))
    throw NoInputError(misuse("the picture does not exist"), file.string());
  vtkNew<vtkPNGReader> reader;
  if (!reader->CanReadFile(file.c_str()))
    throw DataError(misuse("this is not a PNG picture"), file.string());
  reader->SetFileName(file.c_str());
  reader->Update();
  auto* picture = reader->GetOutput();
  if (picture->GetScalarType() != VTK_UNSIGNED_CHAR || picture->GetNumberOfScalarComponents() != 3)
    throw DataError(misuse("the picture is not of three channels of 8 bits"), file.string());
  return picture;
}

vtkSmartPointer<vtkImageData> contactSheet(const std::vector<vtkSmartPointer<vtkImageData>>& pictures,
                                           int columns) {
  if (pictures.empty())
    throw UsageError(misuse("there is no picture to put on the sheet"));
  const int* size = pictures.front()->GetDimensions();
  for (const auto& picture : pictures)
    if (!std::equal(size, size + 2, picture->GetDimensions()))
      throw UsageError(misuse("pictures of different sizes do not fit on one sheet"));
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

PictureDifference comparePictures(vtkImageData* a, vtkImageData* b, int threshold) {
  const int* sizeA = a->GetDimensions();
  const int* sizeB = b->GetDimensions();
  if (sizeA[0] != sizeB[0] || sizeA[1] != sizeB[1])
    return {255, 1};
  const auto* pixelsA = static_cast<const unsigned char*>(a->GetScalarPointer());
  const auto* pixelsB = static_cast<const unsigned char*>(b->GetScalarPointer());
  const std::size_t count = std::size_t(sizeA[0]) * std::size_t(sizeA[1]);
  double sum = 0;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < count; ++i) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int difference = std::abs(int(pixelsA[3 * i + c]) - int(pixelsB[3 * i + c]));
      sum += difference;
      most = std::max(most, difference);
    }
    differing += most > threshold;
  }
  return {sum / (3.0 * double(count)), double(differing) / double(count)};
}

} // namespace viscera::scene
