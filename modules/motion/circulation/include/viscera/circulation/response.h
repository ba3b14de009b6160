#pragma once

#include <string>
#include <vector>

#include "viscera/circulation/indices.h"
#include "viscera/circulation/parameters.h"
#include "viscera/core/progress.h"

namespace viscera::circulation {

/// The computed numbers of the circulation at one value of a varied parameter.
struct ResponsePoint {
  double value = 0;
  Indices indices;
};

/// Computes how the numbers depend on one parameter while all others stay: over `stressedVolume` it is Frank
/// and Starling's curve, over `systemicResistance` the response to afterload. One point for each value, in
/// their order; each search starts from the point before. Throws `UsageError` for unknown names and values
/// out of range, `DataError` at a value without a periodic beat, `Cancelled`. About 10 ms a point.
std::vector<ResponsePoint> responseTo(const Parameters& parameters, const std::string& name,
                                      const std::vector<double>& values, Progress& progress);

} // namespace viscera::circulation
