#include "viscera/session/volume_table.h"

#include <iomanip>
#include <ostream>
#include <string>

#include "viscera/core/atomic_file.h"

namespace viscera::session {
namespace {

/// As RFC 4180 has it.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

} // namespace

void writeVolumeTable(const std::filesystem::path& file, const VolumeRecord& volumes) {
  writeAtomically(file, [&](std::ostream& stream) {
    stream << "time_s";
    for (const std::string& name : volumes.names())
      stream << ',' << field(name + "_ml");
    stream << '\n' << std::fixed << std::setprecision(6);
    for (std::size_t row = 0; row < volumes.rows(); ++row) {
      stream << volumes.seconds(row);
      for (std::size_t column = 0; column < volumes.names().size(); ++column)
        stream << ',' << volumes.milliliters(row, column);
      stream << '\n';
    }
  });
}

} // namespace viscera::session
