#pragma once

#include <iosfwd>

#include "file_bytes.h"
#include "viscera/medical_io/handle_file.h"

/// The two formats of handle files. Readers give positions in LPS mm, labels as they are in the file.
namespace viscera::medical_io {

HandleFile readMarkups(const FileBytes& file);
HandleFile readFcsv(const FileBytes& file);
void writeMarkups(std::ostream& out, const HandleFile& handles, Space space);
void writeFcsv(std::ostream& out, const HandleFile& handles, Space space);

/// Turns a position of the axes RAS into LPS, and back: half a turn, exact but for the sign of zero.
inline Vec3 lpsFromRas(const Vec3& ras) {
  return {0.0 - ras.x(), 0.0 - ras.y(), ras.z()};
}

} // namespace viscera::medical_io
