#pragma once

#include <filesystem>
#include <string_view>

namespace viscera::medical_io {

/// The kind of a file: surface, handles, session and others.
enum class FileKind { unknown, surface, handles, sequence, session, labelMap, scan };

/// Determines the kind by the first bytes of the file, and by its extension if they are not conclusive:
/// sequences (`.sequence.json`), sessions (`.viscera`), compressed files, files too damaged to be recognised.
/// All NIfTI, NRRD and MetaImage files count as label maps, and so do DICOM segmentations; other DICOM files
/// count as scans. Only a guess; only reading checks whether the file is valid. If bytes and extension
/// disagree, the bytes count. Throws `NoInputError` when it is missing or not readable.
FileKind fileKind(const std::filesystem::path& file);

/// "surface", "handles", "sequence", "session", "label map", "scan", "unknown": as `viscera info` prints it.
std::string_view nameOf(FileKind kind);

} // namespace viscera::medical_io
