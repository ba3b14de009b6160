#pragma once

#include <string_view>

#include "file_bytes.h"

namespace viscera::medical_io {

/// What a file looks like by its first bytes, whatever it is called.
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

/// Looks at the first bytes, and for binary STL at the size of the whole. Cheap.
Signature signatureOf(const FileBytes& file);

/// "an STL surface", "a NIfTI image".
std::string_view describe(Signature signature);

/// The extension such a file should have; empty when there is no usual one.
std::string_view usualExtension(Signature signature);

} // namespace viscera::medical_io
