#pragma once

#include <string>
#include <string_view>

#include "file_bytes.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/file_kind.h"

namespace viscera::medical_io {

/// The format of a file as recognised by its first bytes, independently of its name.
enum class Signature {
  unknown,
  stl,
  obj,
  ply,
  off,
  legacyVtk,
  vtp,
  vtm,
  vtu,
  otherVtkXml,
  glb,
  gltf,
  gifti,
  freeSurfer,
  gmsh,
  medit,
  carto,
  openCarp,
  markups,
  fcsv,
  sequence,
  session,
  otherJson,
  nifti,
  nrrd,
  metaImage,
  mgh,
  gipl,
  dicom,
  gzip,
  zip,
  threeMf,
  picture,
};

/// Checks the first bytes, and for binary STL the length of the file, of which `file` may hold the beginning.
/// Cheap. A compressed file is `gzip`, whatever is in it.
Signature signatureOf(const FileBytes& file);

/// The same of what is packed, for a file that gzip packed as a whole; `gzip` when it cannot be unpacked.
Signature signatureUnpacked(const FileBytes& file);

/// The signature that a name promises, the first one of those that share the ending; `unknown` for an ending
/// of no format. Without the ".gz" of a compressed file.
Signature signatureOfEnding(const std::filesystem::path& file);

/// The signature of the reader that a file of this kind goes to: the one of its bytes. A file whose bytes
/// tell nothing, and a compressed one, has the one of its ending, so that its reader says what is wrong.
/// Throws `DataError` for a file whose name promises another format than its bytes have, and for one of
/// another kind.
Signature signatureFor(const FileBytes& file, FileKind wanted);

/// What a file of that signature holds.
FileKind fileKind(Signature signature);

/// The usual ending of a file of that signature, with its dot; empty where Viscera reads none.
std::string_view usualEnding(Signature signature);

/// See `refuse` in file_kind.h, for a file of which the beginning is in memory.
[[noreturn]] void refuse(const FileBytes& file, FileKind wanted);

} // namespace viscera::medical_io
