#include "cli/listing.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace viscera::app::cli {
namespace {

// Not printf, which follows the locale: a reader's script expects a point.
std::string written(double value, std::chars_format format, int digits) {
  char buffer[512];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value, format, digits);
  return error == std::errc() ? std::string(buffer, end) : std::string("?");
}

} // namespace

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

std::string fixed(double value, int digits) {
  return written(value, std::chars_format::fixed, digits);
}

std::string significant(double value, int digits) {
  return written(value, std::chars_format::general, digits);
}

} // namespace viscera::app::cli
