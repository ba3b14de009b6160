#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace viscera::motion {

/// Lists of numbers by name.
using NumberTable = std::map<std::string, std::vector<double>>;

/// Numbers that took long to find, one JSON file for each table, believed only under the key of all that they
/// depend on.
class NumberCache {
public:
  /// An empty path keeps nothing.
  explicit NumberCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The table, or nothing when it is not there, damaged, or of another key. The numbers are finite.
  std::optional<NumberTable> load(const std::string& name, std::uint64_t key) const;

  /// Keeps a table for the next time, to the last bit; does nothing when the folder cannot be written.
  void store(const std::string& name, std::uint64_t key, const NumberTable& table) const;

private:
  std::filesystem::path fileOf(const std::string& name, std::uint64_t key) const;

  std::filesystem::path folder_;
};

} // namespace viscera::motion
