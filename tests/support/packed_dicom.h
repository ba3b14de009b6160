#pragma once

#include <string>

namespace viscera::tests {

/// A DICOM file in another transfer syntax, as DCMTK packs it: "rle", "jpeg-lossless", "jpeg-ls", "jpeg" (12
/// bits, with loss), "deflated" or "big-endian"; and as OpenJPEG does: "jpeg-2000" (without loss; one frame
/// of 16 bits allocated, without a sign). Throws `std::runtime_error` when they cannot.
std::string packedDicom(const std::string& plain, const std::string& packing);

} // namespace viscera::tests
