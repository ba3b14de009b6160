#include "viscera/sequences/volume_record.h"

#include <cassert>
#include <iomanip>
#include <ostream>
#include <utility>

#include "viscera/core/atomic_file.h"
#include "viscera/core/text.h"

namespace viscera::sequences {

VolumeRecord::VolumeRecord(std::vector<std::string> names, std::size_t capacity)
    : names_(std::move(names)), capacity_(capacity) {}

void VolumeRecord::add(double seconds, const std::vector<double>& milliliters) {
  assert(milliliters.size() == names_.size() && "one volume for each name");
  if (!seconds_.empty() && seconds <= seconds_.back())
    clear();
  seconds_.push_back(seconds);
  values_.insert(values_.end(), milliliters.begin(), milliliters.end());
  // Rows are dropped in bulk, so that the cost of a row stays constant.
  if (capacity_ > 0 && seconds_.size() >= 2 * capacity_) {
    const std::size_t surplus = seconds_.size() - capacity_;
    seconds_.erase(seconds_.begin(), seconds_.begin() + static_cast<std::ptrdiff_t>(surplus));
    values_.erase(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(surplus * names_.size()));
  }
}

void VolumeRecord::clear() {
  seconds_.clear();
  values_.clear();
}

std::vector<double> VolumeRecord::column(std::size_t column, double sinceSeconds) const {
  std::vector<double> out;
  for (std::size_t row = 0; row < rows(); ++row)
    if (seconds(row) >= sinceSeconds)
      out.push_back(milliliters(row, column));
  return out;
}

void writeVolumeTable(const std::filesystem::path& file, const VolumeRecord& volumes,
                      const std::vector<std::pair<std::string, std::size_t>>& wantedKeys) {
  // The table of one surface is a volume curve, which has two columns.
  const auto keys =
      volumes.names().size() > 1 ? wantedKeys : std::vector<std::pair<std::string, std::size_t>>();
  writeAtomically(file, [&](std::ostream& stream) {
    stream << "time_s";
    for (const std::string& name : volumes.names())
      stream << ',' << csvField(name + "_ml");
    for (const auto& [key, column] : keys)
      stream << ',' << csvField(key + "_ml");
    stream << '\n' << std::setprecision(12);
    for (std::size_t row = 0; row < volumes.rows(); ++row) {
      stream << volumes.seconds(row);
      for (std::size_t column = 0; column < volumes.names().size(); ++column)
        stream << ',' << volumes.milliliters(row, column);
      for (const auto& [key, column] : keys)
        stream << ',' << volumes.milliliters(row, column);
      stream << '\n';
    }
  });
}

} // namespace viscera::sequences
