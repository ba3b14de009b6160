#include "viscera/core/number_text.h"

#include <charconv>
#include <system_error>

namespace viscera {
namespace {

// Not printf, which follows the locale: a reader's script expects a point.
std::string written(double value, std::chars_format format, int digits) {
  char buffer[512];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value, format, digits);
  return error == std::errc() ? std::string(buffer, end) : std::string("?");
}

} // namespace

std::string fixed(double value, int digits) {
  return written(value, std::chars_format::fixed, digits);
}

std::string significant(double value, int digits) {
  return written(value, std::chars_format::general, digits);
}

} // namespace viscera
