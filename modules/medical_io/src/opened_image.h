#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "image_formats/data_file.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/scan.h"

/// Image files of any format but DICOM, which hold scans and label maps alike, in one reading.
namespace viscera::medical_io {

class SampleCollector;
struct NumberedLayer;

/// An image file whose header was read.
struct OpenedImage {
  FileBytes begin; ///< The beginning of the file.
  ImageHeader header;
};

/// Reads the header by what the file begins with, and by its ending where that says nothing. Throws as
/// `readScan`.
OpenedImage openImage(const std::filesystem::path& path);

/// Milliseconds from the first phase on of each of several phases, as far as the header states them; else
/// empty.
std::vector<double> statedPhaseTimes(const RawImage& image);

/// Told of the next values of a phase, aligned, and of their type and order.
using TakeValues =
    std::function<void(const char* bytes, std::size_t count, Scalar scalar, std::endian order)>;

/// Passes the values of one phase, block by block, to `take`; `prepare` as in `visitValues`, with the values
/// of the phase.
void visitPhase(OpenedImage& image, int phase, Progress& progress,
                const std::function<void(std::size_t count)>& prepare, const TakeValues& take);

/// The scan of samples that were collected.
Scan scanOf(OpenedImage&& image, int phase, SampleCollector& collector);

/// The label map of the one layer of a file, whose name says which formats of label maps it may have. Throws
/// as `readLabelMap`.
LabelMap labelMapOf(OpenedImage&& image, NumberedLayer&& layer, Progress& progress);

} // namespace viscera::medical_io
