#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Tells what a file is: the one place that knows all formats, those that Viscera reads and those it names.
namespace viscera::medical_io {

/// The kind of a file: surface, handles, session and others.
enum class FileKind { unknown, surface, handles, sequence, session, labelMap, scan };

/// Determines the kind by the first bytes of the file, and by its extension if they are not conclusive
/// (compressed files, files too damaged to be recognised). All NIfTI, NRRD and MetaImage files count as label
/// maps, and so do DICOM segmentations; other DICOM files with pixels count as scans, those with an STL or
/// OBJ file within as surfaces. Only a guess; only reading checks whether the file is valid. If bytes and
/// extension disagree, the bytes count. Throws `NoInputError` when it is missing or not readable.
FileKind fileKind(const std::filesystem::path& file);

/// The ending that a file with these bytes usually has, with its dot: ".stl", ".nii.gz"; for bytes that came
/// without a name, since readers choose by the ending. Empty for bytes of no known kind. Throws
/// `NoInputError` when the file is missing or not readable, `DataError` when it is empty.
std::string usualEnding(const std::filesystem::path& file);

/// "surface", "handles", "sequence", "session", "label map", "scan", "unknown": as `viscera info` prints it.
std::string_view nameOf(FileKind kind);

/// A format that Viscera reads.
struct FileFormat {
  FileKind kind = FileKind::unknown; ///< Images are label maps here; their values tell a scan.
  std::string name;                  ///< "NIfTI"
  std::vector<std::string> endings;  ///< Lower-case, with the dot; the usual one is the first.
  bool written = false;              ///< Whether Viscera also writes it.
};

/// All formats that Viscera reads, surfaces first. From any thread.
const std::vector<FileFormat>& fileFormats();

/// The lower-case endings, with their dots, of the formats of that kind. From any thread.
const std::vector<std::string>& endingsOf(FileKind kind);

/// Throws the error for a file that is of no kind that the caller reads: names what it is, by its bytes and
/// by its ending, and a way out. `wanted` is the kind that the caller reads; `unknown`: any. Throws
/// `NoInputError` when it is missing or not readable, else `DataError`.
[[noreturn]] void refuse(const std::filesystem::path& file, FileKind wanted = FileKind::unknown);

} // namespace viscera::medical_io
