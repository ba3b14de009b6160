#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "viscera/sequences/curve.h"

namespace viscera::sequences {

/// Reads the volume of an organ over a cycle: a table of two columns, separated by commas, semicolons or
/// tabs, the instant and the volume in ml, one row for each key, in ascending order. Between semicolons or
/// tabs numbers may have a decimal comma. The instant is a fraction of the cycle, 0 to 1, without a header
/// and under one that begins with "fraction", "phase", "part" or "cycle"; under one that begins with "time"
/// it is in seconds, of a cycle of `periodSeconds`; capitals are the same. A byte-order mark is ignored.
/// Between the keys the volume follows a curve that overshoots none of them. Returns it over the fraction,
/// with period 1.
///
/// Throws `NoInputError` when the file cannot be read, and `DataError` that names the line for one
/// without two numbers, for another header, for an instant outside the cycle or not later than the one
/// before, for a volume that is not positive, and for a curve that ends at another volume than it begins.
Curve readVolumeCurve(const std::filesystem::path& file, double periodSeconds);

/// Makes such a curve from rows as a session keeps them, each a fraction of the cycle and a volume in ml.
/// Throws `DataError` when they do not ascend strictly within one cycle, for a volume that is not positive,
/// and for numbers that are not finite.
Curve volumeCurve(const std::vector<std::array<double, 2>>& rows);

} // namespace viscera::sequences
