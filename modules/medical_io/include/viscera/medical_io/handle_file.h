#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::medical_io {

/// One handle of a file.
struct HandleRecord {
  std::string label; ///< "H-1"; unique within the file after reading.
  Vec3 position = Vec3::Zero(); ///< mm, LPS.
  std::string description;
  bool locked = false;
  bool visible = true;
};

/// One markup list: a group of handles with one colour.
struct HandleGroupRecord {
  std::string name;
  Vec3 color = {1.0, 0.5, 0.2}; ///< Red green blue, 0 to 1.
  std::vector<HandleRecord> handles;
};

/// A rig of handles as 3D Slicer keeps it: one markup list a group.
struct HandleFile {
  std::vector<HandleGroupRecord> groups;
  std::vector<std::string> warnings;

  Eigen::Index count() const;
  /// All positions in order of groups, `n x 3`.
  Points positions() const;
  std::vector<std::string> labels() const;
};

/// Reads `.mrk.json` (markups schema 1.0.x: Fiducial lists, LPS or RAS, mm). Throws `NoInputError`, and `DataError`
/// naming file, list and point for anything that is not such a file or has a position that is missing or not finite.
HandleFile readHandles(const std::filesystem::path& file);

/// Writes `.mrk.json`, LPS, full double precision: reading it back gives the same bits. Atomic. Throws
/// `CannotCreateError`.
void writeHandles(const std::filesystem::path& file, const HandleFile& handles);

} // namespace viscera::medical_io
