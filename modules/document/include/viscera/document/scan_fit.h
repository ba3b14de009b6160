#pragma once

#include <string>
#include <vector>

#include "viscera/document/document.h"

namespace viscera::document {

/// What is odd about organs and scan as one patient, one sentence each: organs whose label map has another
/// grid than the scan, organs that lie outside of it. Empty without a scan. Reads the
/// headers of the label maps that organs came from, where they still are. O(vertices).
std::vector<std::string> scanFit(const DocumentState& state);

} // namespace viscera::document
