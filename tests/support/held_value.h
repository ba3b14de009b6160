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
/// (`--gtest_output=json`), when it goes; resources/scripts/strain_table.py makes the table of these.
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

} // namespace viscera::tests
