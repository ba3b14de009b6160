#pragma once

#include <string>
#include <vector>

#include "viscera/core/progress.h"

namespace viscera::circulation {

/// A value that was published for humans, compared with the value of this circulation.
struct PublishedValue {
  std::string scenario; ///< Its id.
  std::string quantity; ///< "Cardiac output, of that at rest"
  std::string unit;     ///< Empty for a ratio.
  double published = 0;
  std::string spread; ///< "+- 3.3", ">=" and the like; may be empty.
  std::string source; ///< Authors, year and DOI.
  double ours = 0;
  double ratio() const { return ours / published; }
};

/// The table of docs/circulation.md: every scenario is solved. About 0.1 s. Throws `Cancelled`.
std::vector<PublishedValue> publishedValues(Progress& progress);

/// The same table as lines of Markdown, header included.
std::string publishedTable(const std::vector<PublishedValue>& values);

} // namespace viscera::circulation
