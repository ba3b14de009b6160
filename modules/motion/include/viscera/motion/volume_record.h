#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// Volumes, and numbers made of them, while organs move.
namespace viscera::motion {

/// Volumes over time, for the chart and for tables: one row an instant, one column a surface. For one thread.
class VolumeRecord {
public:
  /// Keeps the last `capacity` rows at least, twice as many at most; 0 keeps all.
  explicit VolumeRecord(std::vector<std::string> names = {}, std::size_t capacity = 0);

  /// Adds a row; `milliliters` has one number for each name. A time that is not later than the last one
  /// (somebody went back) begins a new record.
  void add(double seconds, const std::vector<double>& milliliters);
  void clear();

  const std::vector<std::string>& names() const { return names_; }
  std::size_t rows() const { return seconds_.size(); }
  double seconds(std::size_t row) const { return seconds_[row]; }
  double milliliters(std::size_t row, std::size_t column) const {
    return values_[row * names_.size() + column];
  }
  /// One surface over all rows, or those not earlier than `sinceSeconds`.
  std::vector<double> column(std::size_t column, double sinceSeconds = -1e300) const;

private:
  std::vector<std::string> names_;
  std::size_t capacity_;
  std::vector<double> seconds_;
  std::vector<double> values_;
};

/// Writes a record as comma-separated values: `time_s`, then one column `<name>_ml` a surface, numbers with
/// six decimals, one row an instant. Names that hold commas or quotes are quoted. A reader sees the old file
/// or the whole new one. Throws `CannotCreateError`.
void writeVolumeTable(const std::filesystem::path& file, const VolumeRecord& volumes);

/// One number over a cycle, filled in as its instants are seen, in whatever order: what a monitor beside a
/// bed draws. An instant that is seen again takes the place of what was there. For one thread.
class CycleTrace {
public:
  /// `slots` instants of the cycle are told apart.
  explicit CycleTrace(std::size_t slots = 160) : slots_(slots) {}

  /// `fraction` of the cycle in [0, 1].
  void add(double fraction, double value);
  void clear() { seen_.clear(); }

  /// The instants that were seen, ascending, and the number at each.
  std::vector<double> fractions() const;
  std::vector<double> values() const;
  std::size_t seen() const { return seen_.size(); }

private:
  struct Instant {
    double fraction = 0;
    double value = 0;
  };
  std::size_t slots_;
  std::map<std::size_t, Instant> seen_; ///< By their slots.
};

} // namespace viscera::motion
