#pragma once

#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/document/document.h"

namespace viscera::document {

/// Checks whether organs and scan belong to one patient, and returns one warning for each doubt: organs whose
/// label map has another grid than the scan, organs that lie outside of it. Empty without a scan. Reads the
/// headers of the label maps that organs came from, where they still are. O(vertices).
std::vector<Text> scanFit(const DocumentState& state);

} // namespace viscera::document
