#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "dicom/dicom_pixels.h"

/// Converts the stored pixels of DICOM frames to samples.
namespace viscera::medical_io {

/// How all slices are made samples: as they are where they agree, else by their values.
struct SampleForm {
  DicomPixelFormat format;
  double slope = 1, intercept = 0;
  bool uniform = true;
};

/// A stored pixel: the bits that count, with their sign.
class PixelValue {
public:
  explicit PixelValue(const DicomPixelFormat& format)
      : shift_(format.high + 1 - format.stored), isSigned_(format.isSigned),
        mask_((std::uint64_t{1} << unsigned(format.stored)) - 1),
        sign_(std::uint64_t{1} << unsigned(format.stored - 1)) {}

  std::int64_t operator()(std::uint64_t raw) const {
    const std::uint64_t bits = (raw >> unsigned(shift_)) & mask_;
    return isSigned_ ? static_cast<std::int64_t>(bits ^ sign_) - static_cast<std::int64_t>(sign_)
                     : static_cast<std::int64_t>(bits);
  }

private:
  int shift_;
  bool isSigned_;
  std::uint64_t mask_, sign_;
};

template <class Raw, class Out>
void convertSlice(const DicomPixels& pixels, const DicomFrame& frame, const SampleForm& form, Out* out) {
  const PixelValue value(pixels.format);
  const auto& padding = pixels.format.padding;
  const std::size_t count = pixels.bytes.size() / sizeof(Raw);
  const bool asStored = form.uniform && pixels.format.stored == pixels.format.allocated;
  for (std::size_t i = 0; i < count; ++i) {
    Raw raw;
    std::memcpy(&raw, pixels.bytes.data() + i * sizeof(Raw), sizeof(Raw));
    std::int64_t stored = 0;
    if (asStored)
      stored = form.format.isSigned ? std::int64_t(std::make_signed_t<Raw>(raw)) : std::int64_t(raw);
    else
      stored = value(raw);
    const bool padded = padding && stored >= (*padding)[0] && stored <= (*padding)[1];
    if constexpr (std::is_floating_point_v<Out>)
      out[i] = padded ? std::numeric_limits<Out>::quiet_NaN()
                      : static_cast<Out>(frame.slope * double(stored) + frame.intercept);
    else
      out[i] = static_cast<Out>(padded ? (*padding)[0] : stored);
  }
}

/// The samples of a frame, `rows * columns` at `out`: fractions are values, with NaN for padding, and whole
/// numbers are pixels as they are stored.
template <class Out>
void convertPixels(const DicomPixels& pixels, const DicomFrame& frame, const SampleForm& form, Out* out) {
  if (pixels.format.allocated == 8)
    convertSlice<std::uint8_t>(pixels, frame, form, out);
  else if (pixels.format.allocated == 16)
    convertSlice<std::uint16_t>(pixels, frame, form, out);
  else
    convertSlice<std::uint32_t>(pixels, frame, form, out);
}

} // namespace viscera::medical_io
