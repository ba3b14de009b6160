#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"

/// Compresses arrays of numbers for a lesson's page: they are rounded to a step, each as the difference to an
/// earlier one, split into planes of bytes, which deflate compresses well (docs/lessons.md, "The file").
namespace viscera::lesson {

/// The place and encoding of an array among the packed bytes. Step 0: plain little-endian floats of width 4.
struct PackedArray {
  std::size_t at = 0; ///< Of its first byte; a multiple of 4.
  std::size_t count = 0;
  int width = 4;   ///< Bytes a number.
  int stride = 1;  ///< Each number is the difference to the one so many before it.
  double step = 1; ///< A number is an integer times this.
};

/// `values` as whole numbers of steps, rounded. Throws `DataError` for a number that is not finite or too
/// large for 32 bits. O(values).
std::vector<std::int32_t> wholeSteps(const std::vector<double>& values, double step);

/// Packs arrays one behind the other into one sequence of bytes.
class ArrayPacker {
public:
  /// Adds `values` rounded to multiples of `step`, in the fewest bytes that hold the largest. Throws
  /// `DataError` for a number that is not finite or too large for 32 bits. O(values).
  PackedArray add(const std::vector<double>& values, int stride, double step);
  /// Adds integers as they are.
  PackedArray add(const std::vector<std::int32_t>& values, int stride);
  /// Adds numbers in single precision.
  PackedArray addFloats(const std::vector<float>& values);

  const std::string& bytes() const { return bytes_; }

private:
  std::size_t begin();

  std::string bytes_;
};

/// Decodes an array as the page does. Throws `DataError` for one that does not lie within `bytes`.
std::vector<double> unpacked(const PackedArray& array, const std::string& bytes);

/// `bytes` as one zlib stream, at the best ratio.
std::string deflated(const std::string& bytes);
/// Decompresses a zlib stream. Throws `DataError` for what is no zlib stream.
std::string inflated(const std::string& bytes);

} // namespace viscera::lesson
