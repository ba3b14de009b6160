#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace viscera::sequences {

/// A table of volumes over time, for charts and files: one row for each instant, one column for each
/// surface. For one thread.
class VolumeRecord {
public:
  /// Keeps at least the last `capacity` rows and at most twice as many; 0 keeps all.
  explicit VolumeRecord(std::vector<std::string> names = {}, std::size_t capacity = 0);

  /// Adds a row; `milliliters` has one number for each name. A time that is not later than the last one
  /// (after going back) begins a new record.
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

/// Writes a record as comma-separated values: `time_s`, then one column `<name>_ml` for each surface, and
/// once more those that `keys` names, each key with the place of its surface (`anatomy::chamberKeys`): unless
/// there is one surface only, whose table is a volume curve. Numbers have twelve digits, and each instant one
/// row. Names that hold commas or quotes are quoted. A reader sees the old file or the whole new one. Throws
/// `CannotCreateError`.
void writeVolumeTable(const std::filesystem::path& file, const VolumeRecord& volumes,
                      const std::vector<std::pair<std::string, std::size_t>>& keys = {});

} // namespace viscera::sequences
