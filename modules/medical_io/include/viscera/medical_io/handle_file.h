#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/space.h"

namespace viscera::medical_io {

/// A handle as stored in a handle file.
struct HandleRecord {
  std::string label;            ///< "H-1"; after reading no two different handles have the same.
  Vec3 position = Vec3::Zero(); ///< mm, LPS.
  std::string description;
  bool locked = false;
  bool visible = true;

  friend bool operator==(const HandleRecord&, const HandleRecord&) = default;
};

/// A markup list of a handle file: a group of handles with one colour.
struct HandleGroupRecord {
  std::string name;
  Vec3 color = {1.0, 0.5, 0.2}; ///< Red green blue, 0 to 1.
  std::vector<HandleRecord> handles;
};

/// The contents of a handle file of 3D Slicer: one markup list for each group of handles.
struct HandleFile {
  std::vector<HandleGroupRecord> groups;
  std::vector<Text> warnings; ///< What was repaired or left out, one sentence each.

  /// The number of records; a handle that several groups share counts once for each.
  Eigen::Index count() const;
  /// All positions in order of groups, `n x 3`.
  Points positions() const;
  std::vector<std::string> labels() const;
};

/// Reads `.mrk.json` (3D Slicer markups schema 1.0: point lists) and `.fcsv` (its older table); positions in
/// RAS or in another unit than mm are converted, bits of LPS mm positions are kept. A `.fcsv` without axes is
/// RAS. Points that Slicer has not placed, and markups of other types, are left out with a warning. Handles
/// without a label, or with one that another handle has, get a new one; the same label at the same place in
/// two lists is one handle in two groups and keeps it. Throws `NoInputError` when the file is missing or not
/// readable, and `DataError` naming file, list and point for anything that is not such a file, is cut off,
/// holds no point (it names the markups of other types), or has a position that is missing or not finite.
HandleFile readHandles(const std::filesystem::path& file);

/// Options of `writeHandles`.
struct WriteHandles {
  Space space = Space::lps;
};

/// Writes `.mrk.json` or `.fcsv` by the name's ending, mm, full double precision: reading it back gives the
/// same bits. A `.fcsv` table is one list: groups and their colours are left out (see `fcsvLoses`), a handle
/// of several groups is written once, and line breaks in labels become spaces. Atomic. Throws
/// `CannotCreateError` when it cannot be written or has another ending, `DataError` naming the handle for a
/// position that is not finite.
void writeHandles(const std::filesystem::path& file, const HandleFile& handles,
                  const WriteHandles& options = {});

/// What a `.fcsv` file does not keep of these handles, one sentence each.
std::vector<Text> fcsvLoses(const HandleFile& handles);

} // namespace viscera::medical_io
