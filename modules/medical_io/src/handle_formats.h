#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "file_bytes.h"
#include "viscera/medical_io/handle_file.h"

/// The two formats of handle files. Readers give positions in LPS mm, labels as they are in the file.
namespace viscera::medical_io {

HandleFile readMarkups(const FileBytes& file);
HandleFile readFcsv(const FileBytes& file);
void writeMarkups(std::ostream& out, const HandleFile& handles, Space space);
void writeFcsv(std::ostream& out, const HandleFile& handles, Space space);

/// Whether a point has a place, by 3D Slicer's status of its position, as a word or as the number of an older
/// file: undefined (0), preview (1), defined (2), missing (3). A point without a status has one.
bool isPlaced(std::string_view status);

/// Warns of the points that were left out because they have no place; `labels` of all of them. Throws
/// `DataError` when there is no other point in the file.
void reportUnplaced(HandleFile& read, const std::vector<std::string>& labels, const FileBytes& file);

/// Turns a position of the axes RAS into LPS, and back: half a turn, exact but for the sign of zero.
inline Vec3 lpsFromRas(const Vec3& ras) {
  return {0.0 - ras.x(), 0.0 - ras.y(), ras.z()};
}

} // namespace viscera::medical_io
