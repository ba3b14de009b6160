#pragma once

#include <string>
#include <utility>
#include <vector>

#include "viscera/core/text.h"

namespace viscera::app::cli {

/// Lines "label  value" for a reader, the values below each other.
class Listing {
public:
  Listing& add(std::string label, std::string value);
  std::string text() const;

private:
  std::vector<std::pair<std::string, std::string>> lines_;
};

} // namespace viscera::app::cli
