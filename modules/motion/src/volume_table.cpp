#include "viscera/motion/volume_table.h"

#include <iomanip>
#include <ostream>
#include <string>

#include "viscera/core/atomic_file.h"
#include "viscera/core/text.h"

namespace viscera::motion {

void writeVolumeTable(const std::filesystem::path& file, const VolumeRecord& volumes) {
  writeAtomically(file, [&](std::ostream& stream) {
    stream << "time_s";
    for (const std::string& name : volumes.names())
      stream << ',' << csvField(name + "_ml");
    stream << '\n' << std::setprecision(12);
    for (std::size_t row = 0; row < volumes.rows(); ++row) {
      stream << volumes.seconds(row);
      for (std::size_t column = 0; column < volumes.names().size(); ++column)
        stream << ',' << volumes.milliliters(row, column);
      stream << '\n';
    }
  });
}

} // namespace viscera::motion
