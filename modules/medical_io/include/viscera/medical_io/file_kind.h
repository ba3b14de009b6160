#pragma once

#include <filesystem>
#include <string_view>

namespace viscera::medical_io {

/// The kind of a file: surface, handles, session and others.
enum class FileKind { unknown, surface, handles, sequence, session, labelMap, scan };

/// Tells by the first bytes of the file, and by its ending where they leave a doubt: sequences
/// (`.sequence.json`), sessions (`.viscera`), compressed files, files too damaged to be recognised. All
/// NIfTI, NRRD and MetaImage files count as label maps, and so do DICOM segmentations; other DICOM files
/// count as scans. Only guesses; reading says whether the file is good. A file whose bytes are of another
/// kind than its ending promises is what its bytes are. Throws `NoInputError` when it is missing or not
/// readable.
FileKind fileKind(const std::filesystem::path& file);

/// "surface", "handles", "sequence", "session", "label map", "scan", "unknown": as `viscera info` prints it.
std::string_view nameOf(FileKind kind);

} // namespace viscera::medical_io
