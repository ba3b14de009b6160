#pragma once

#include <string>

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
  otherVtkXml,
  glb,
  gltf,
  markups,
  fcsv,
  otherJson,
  nifti,
  nrrd,
  metaImage,
  dicom,
  gzip,
  zip,
  picture,
};

/// Checks the first bytes, and for binary STL the length of the file, of which `file` may hold the beginning.
/// Cheap.
Signature signatureOf(const FileBytes& file);

/// What a file of that signature holds.
FileKind fileKind(Signature signature);

/// The problem, followed by the format that the file seems to have: "It is not a handle file; it looks like
/// an STL surface". The problem alone for a file of no recognisable kind.
Text looksLike(const Text& problem, Signature found);

/// Throws `DataError` for a file whose name promises another kind. `otherwise` says what to try when its kind
/// has no usual ending.
[[noreturn]] void failAsAnotherKind(const FileBytes& file, Signature found, const Text& otherwise);

} // namespace viscera::medical_io
