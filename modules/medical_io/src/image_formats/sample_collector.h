#pragma once

#include <bit>
#include <cstddef>

#include "scalar.h"
#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {

/// Collects the stored values of a scan as its samples, block by block: of the type that the file states
/// where samples can have it, else as whole numbers of 32 bits or as fractions. Where a value does not fit
/// (numbers in words may be no whole ones, whatever the header says, and 64 bits may need more than 32), all
/// samples become fractions.
class SampleCollector {
public:
  explicit SampleCollector(Scalar stated);

  /// Takes memory for so many samples.
  void reserve(std::size_t count);
  /// Takes the next values. `bytes` is aligned for them.
  void take(const char* bytes, std::size_t count, Scalar scalar, std::endian order);

  /// Whether a value did not fit.
  bool rounded() const { return rounded_; }
  /// The samples; leaves none here.
  Scan::Samples samples() { return std::move(samples_); }

private:
  Scan::Samples samples_;
  bool rounded_ = false;
};

} // namespace viscera::medical_io
