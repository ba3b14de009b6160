#pragma once

#include <string>

namespace viscera::tests {

/// A DICOM file in another transfer syntax, as DCMTK packs it: "rle", "jpeg-lossless", "jpeg-ls", "jpeg" (12
/// bits, with loss), "deflated" or "big-endian". Throws `std::runtime_error` when DCMTK cannot.
std::string packedDicom(const std::string& plain, const std::string& packing);

} // namespace viscera::tests
