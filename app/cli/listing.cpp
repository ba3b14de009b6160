#include "cli/listing.h"

#include <algorithm>

namespace viscera::app::cli {

Listing& Listing::add(std::string label, std::string value) {
  lines_.emplace_back(std::move(label), std::move(value));
  return *this;
}

std::string Listing::text() const {
  std::size_t width = 0;
  for (const auto& [label, value] : lines_)
    width = std::max(width, label.size());
  std::string text;
  for (const auto& [label, value] : lines_)
    text += label + std::string(width - label.size() + 2, ' ') + value + "\n";
  return text;
}

} // namespace viscera::app::cli
