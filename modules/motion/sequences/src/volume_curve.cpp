#include "viscera/sequences/volume_curve.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

namespace viscera::sequences {
namespace {

constexpr double kSameCurveInstant = 1e-9;
constexpr double kSameVolume = 1e-3; ///< Relative, of the first and the last key of a whole cycle.
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
/// Headings of instants from 0 to 1 begin so.
constexpr std::array<const char*, 4> kPartsOfTheCycle = {"fraction", "phase", "part", "cycle"};

/// Where semicolons or tabs are between the fields, a comma is a decimal mark: spreadsheets write so in
/// languages that have one.
std::vector<std::string> fieldsOf(const std::string& line) {
  const bool decimalComma = line.find_first_of(";\t") != std::string::npos;
  std::vector<std::string> fields(1);
  for (const char letter : line)
    if (letter == ';' || letter == '\t' || (letter == ',' && !decimalComma))
      fields.emplace_back();
    else if (letter == ',')
      fields.back() += '.';
    else if (letter != ' ' && letter != '\r' && letter != '"')
      fields.back() += letter;
  return fields;
}

/// The factor that converts instants to fractions of the cycle, by the first field of the heading; empty for
/// an unknown one.
std::optional<double> scaleOf(std::string heading, double periodSeconds) {
  std::transform(heading.begin(), heading.end(), heading.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? char(letter - 'A' + 'a') : letter;
  });
  if (heading.starts_with("time"))
    return 1 / periodSeconds;
  const bool part = std::any_of(kPartsOfTheCycle.begin(), kPartsOfTheCycle.end(),
                                [&](const char* word) { return heading.starts_with(word); });
  return part ? std::optional(1.0) : std::nullopt;
}

std::optional<double> numberOf(const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
  return whole ? std::optional(number) : std::nullopt;
}

/// The rows of such a file, one after the other.
class CurveReader {
public:
  CurveReader(std::string file, double periodSeconds) : file_(std::move(file)), period_(periodSeconds) {}

  void take(std::string line) {
    if (++line_ == 1 && line.starts_with(kByteOrderMark))
      line.erase(0, kByteOrderMark.size());
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#')
      return;
    const std::vector<std::string> fields = fieldsOf(line);
    if (fields.size() != 2)
      fail(phrase("has %n {column|columns}", fields.size()), "leave two: the instant, and the volume in ml");
    const auto instant = numberOf(fields[0]);
    const auto milliliters = numberOf(fields[1]);
    if (!instant && !milliliters && !headerSeen_ && keys_.empty()) {
      headerSeen_ = true;
      const auto scale = scaleOf(fields[0], period_);
      if (!scale)
        fail("has a heading that does not say what the instants are",
             "let it begin with \"time_s\" for seconds, or with \"fraction\" for parts of the cycle");
      scale_ = *scale;
    } else if (instant && milliliters) {
      add(scale_ * *instant, *milliliters);
    } else {
      fail("holds something that is not a number", "write the instant and the volume in ml, as in 0.25,98.5");
    }
  }

  Curve curve() {
    if (keys_.empty())
      throw DataError("There is no volume in it", file_, "write lines of the instant and the volume in ml");
    if (keys_.size() > 1 && keys_.back().at > keys_.front().at + 1 - kSameCurveInstant) {
      if (std::abs(keys_.back().value - keys_.front().value) > kSameVolume * keys_.front().value)
        fail("the volume at the end of the cycle differs from the volume at its start",
             "let the last volume be the first one");
      keys_.pop_back(); // The next cycle begins with it.
    }
    return Curve::periodic(keys_, 1);
  }

private:
  void add(double fraction, double milliliters) {
    if (!(fraction >= 0 && fraction <= 1 + kSameCurveInstant))
      fail("names an instant outside the cycle",
           scale_ == 1 ? "name instants from 0 to 1, or write \"time_s\" above them for seconds"
                       : "play at the rate that the times are for");
    if (!keys_.empty() && !(fraction > keys_.back().at))
      fail("is not later than the line before", "sort the lines by their instants");
    if (!(milliliters > 0))
      fail("has a volume that is not positive", "write volumes in ml");
    keys_.push_back({fraction, milliliters});
  }

  [[noreturn]] void fail(const Text& problem, const Text& tryThis) const {
    throw DataError(problem, phrase("%1, line %2", file_, line_), tryThis);
  }

  std::string file_;
  double period_;
  double scale_ = 1; ///< Of the instants, to fractions of the cycle.
  int line_ = 0;
  bool headerSeen_ = false;
  std::vector<Key> keys_;
};

} // namespace

Curve readVolumeCurve(const std::filesystem::path& file, double periodSeconds) {
  std::ifstream stream(file);
  std::error_code unreachable;
  if (!std::filesystem::is_regular_file(file, unreachable) || !stream)
    throw NoInputError("is not a file that can be read", file.string(), "check the name and the folder");
  CurveReader reader(file.string(), periodSeconds);
  for (std::string line; std::getline(stream, line);)
    reader.take(std::move(line));
  requireReadToEnd(stream, file.string());
  return reader.curve();
}

Curve volumeCurve(const std::vector<std::array<double, 2>>& rows) {
  std::vector<Key> keys;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto [fraction, milliliters] = rows[i];
    const Text place = phrase("curve key %1", i + 1);
    if (!(milliliters > 0))
      throw DataError("has a volume that is not positive", place, "write volumes in ml");
    if (!(fraction >= 0 && fraction <= 1))
      throw DataError("names an instant outside the cycle", place, "name instants from 0 to 1");
    keys.push_back({fraction, milliliters});
  }
  return Curve::periodic(std::move(keys), 1);
}

} // namespace viscera::sequences
