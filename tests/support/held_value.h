#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace viscera::tests {

/// A row of a page's table of what holds its numbers: the largest of some differences, which may not exceed a
/// bound. The bound is checked, and value, bound and unit are recorded as a property of the test
/// (`--gtest_output=json`), when it goes; resources/scripts/held_table.py makes the table of these.
/// It reads the declarations, too: row and unit are literals, the bound is a number or a constant of the
/// file.
///
///     HeldValue held("uniform stretch", 1e-10);
///     held.add(strain - 0.4);
class HeldValue {
public:
  HeldValue(std::string row, double bound, std::string unit = "")
      : row_(std::move(row)), unit_(std::move(unit)), bound_(bound) {}
  HeldValue(const HeldValue&) = delete;
  HeldValue& operator=(const HeldValue&) = delete;
  ~HeldValue() {
    EXPECT_GT(added_, 0) << row_ << ": nothing was compared";
    EXPECT_LE(largest_, bound_) << row_;
    ::testing::Test::RecordProperty("held: " + row_, inWords(largest_) + " | " + inWords(bound_));
  }

  void add(double difference) {
    ++added_;
    largest_ = std::isnan(difference) ? difference : std::max(largest_, std::abs(difference));
  }

private:
  std::string inWords(double value) const {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", value);
    return text + (unit_.empty() ? "" : " " + unit_);
  }

  std::string row_, unit_;
  double bound_;
  double largest_ = 0;
  int added_ = 0;
};

/// A row of such a table for numbers that have to lie within a range, with who says so: all that are added,
/// from the least to the largest. Row, unit and source are literals, the bounds numbers or constants of the
/// file.
///
///     HeldRange held("aorta, five places", 22.7, 39.1, "mm", "Hager 2002, doi 10.1067/mtc.2002.122310");
///     held.add(diameter);
class HeldRange {
public:
  HeldRange(std::string row, double low, double high, std::string unit, std::string source)
      : row_(std::move(row)), unit_(std::move(unit)), source_(std::move(source)), low_(low), high_(high) {}
  HeldRange(const HeldRange&) = delete;
  HeldRange& operator=(const HeldRange&) = delete;
  ~HeldRange() {
    EXPECT_GT(added_, 0) << row_ << ": nothing was measured";
    EXPECT_GE(least_, low_) << row_;
    EXPECT_LE(largest_, high_) << row_;
    ::testing::Test::RecordProperty("held: " + row_, inWords(least_, largest_) + " | " +
                                                         inWords(low_, high_) + " | " + source_);
  }

  void add(double value) {
    const bool first = added_++ == 0;
    least_ = first || std::isnan(value) ? value : std::min(least_, value);
    largest_ = first || std::isnan(value) ? value : std::max(largest_, value);
  }

private:
  /// "18 to 28.2 mm"; "23.1 mm" of two that are written alike.
  std::string inWords(double low, double high) const {
    char from[32], to[32];
    std::snprintf(from, sizeof from, "%.3g", low);
    std::snprintf(to, sizeof to, "%.3g", high);
    const std::string range = std::string(from) == to ? from : std::string(from) + " to " + to;
    return range + (unit_.empty() ? "" : " " + unit_);
  }

  std::string row_, unit_, source_;
  double low_, high_;
  double least_ = 0, largest_ = 0;
  int added_ = 0;
};

} // namespace viscera::tests
