#include "cli/number_bounds.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <CLI/CLI.hpp>

#include "viscera/core/text.h"

namespace viscera::app::cli {
namespace {

/// Digits that show every bound as it is written in the sources.
constexpr int kBoundDigits = 9;

std::optional<double> finiteNumber(const std::string& text) {
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  double value = 0;
  const auto read = std::from_chars(begin, end, value);
  return read.ec == std::errc() && read.ptr == end && std::isfinite(value) ? std::optional(value)
                                                                           : std::nullopt;
}

CLI::Validator bounded(const std::string& kind, const std::string& range,
                       std::function<bool(double)> isAllowed) {
  return CLI::Validator(
      [kind, range, isAllowed = std::move(isAllowed)](std::string& text) -> std::string {
        const std::optional<double> value = finiteNumber(text);
        if (value && isAllowed(*value))
          return {};
        const bool isKind = value && (kind == "number" || *value == std::floor(*value));
        return text + (isKind ? " is out of range" : " is no " + kind) + "; it has to be " + range;
      },
      range);
}

} // namespace

CLI::Validator above(double bound) {
  return bounded("number", "above " + significant(bound, kBoundDigits),
                 [bound](double value) { return value > bound; });
}

CLI::Validator atLeast(double bound) {
  return bounded("number", significant(bound, kBoundDigits) + " or more",
                 [bound](double value) { return value >= bound; });
}

CLI::Validator between(double low, double high) {
  return bounded("number", significant(low, kBoundDigits) + " to " + significant(high, kBoundDigits),
                 [low, high](double value) { return value >= low && value <= high; });
}

CLI::Validator wholeBetween(int low, int high) {
  return bounded(
      "whole number", std::to_string(low) + " to " + std::to_string(high),
      [low, high](double value) { return value == std::floor(value) && value >= low && value <= high; });
}

} // namespace viscera::app::cli
