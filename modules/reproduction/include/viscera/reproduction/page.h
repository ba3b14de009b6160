#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viscera/reproduction/result.h"

namespace viscera::reproduction {

/// The whole page as HTML: a table of all verdicts, then every figure and table with its pictures, what the
/// thesis says, and how that was judged. Takes nothing from outside its folder.
std::string pageOf(const std::vector<Result>& results);

/// One row of Markdown a figure or table: what it is, and the verdict.
std::string verdictsOf(const std::vector<Result>& results);

/// Writes `index.html`, `verdicts.md`, the pictures (.svg) and the tables (.csv) into `folder`, which is made
/// when missing. Each file atomically. Throws `CannotCreateError`.
void writePage(const std::filesystem::path& folder, const std::vector<Result>& results);

} // namespace viscera::reproduction
