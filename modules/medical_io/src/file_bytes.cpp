#include "file_bytes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <limits>
#include <new>
#include <system_error>

#include "viscera/core/base64.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

constexpr std::array<std::string_view, 12> kDoubleExtensions = {
    ".mrk.json", ".sequence.json", ".nii.gz",  ".hdr.gz", ".img.gz", ".seg.nrrd",
    ".seg.nhdr", ".seg.nrrd.gz",   ".nrrd.gz", ".mha.gz", ".mgh.gz", ".gipl.gz"};

constexpr std::string_view kGzipEnding = ".gz";

void requireReadable(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    throw NoInputError("there is no such file", file.string(), "check the name and the folder");
  if (std::filesystem::is_directory(status))
    throw NoInputError("It is a folder, not a file", file.string(), "name a file in it");
  if (!std::filesystem::is_regular_file(status))
    throw NoInputError("It is not a regular file", file.string(), "copy its contents to a file first");
}

} // namespace

void FileBytes::fail(const Text& problem, const Text& tryThis) const {
  throw DataError(problem, name(), tryThis);
}

namespace {

/// The file up to `most` bytes, of which the first ones are known.
FileBytes readUpTo(const std::filesystem::path& file, std::size_t most, std::string_view known) {
  requireReadable(file);
  errno = 0;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream)
    throw NoInputError(phrase("It cannot be opened: %1", std::generic_category().message(errno)),
                       file.string(), "check that you may read it");
  FileBytes result{file, {}, static_cast<std::uint64_t>(std::max<std::streamoff>(stream.tellg(), 0))};
  try {
    result.bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(most, result.length)));
  } catch (const std::bad_alloc&) {
    result.fail("it does not fit into memory", "reduce the surface first");
  }
  const std::size_t held = known.copy(result.bytes.data(), result.bytes.size());
  const auto missing = static_cast<std::streamsize>(result.bytes.size() - held);
  stream.seekg(static_cast<std::streamoff>(held));
  stream.read(result.bytes.data() + held, missing);
  if (stream.gcount() != missing)
    throw NoInputError("It cannot be read to its end", file.string(), "check the disk or the connection");
  if (result.bytes.empty())
    result.fail("the file is empty");
  return result;
}

} // namespace

FileBytes readBeginOfFile(const std::filesystem::path& file, std::size_t most) {
  return readUpTo(file, most, {});
}

FileBytes readRestOfFile(const FileBytes& begin) {
  if (begin.unpacked)
    return begin;
  return readUpTo(begin.file, std::numeric_limits<std::size_t>::max(), begin.view());
}

FileBytes readWholeFile(const std::filesystem::path& file) {
  return readBeginOfFile(file, std::numeric_limits<std::size_t>::max());
}

std::string lowered(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return result;
}

std::string extensionOf(const std::filesystem::path& file) {
  const std::string name = lowered(file.filename().string());
  for (const std::string_view extension : kDoubleExtensions)
    if (name.size() > extension.size() && name.ends_with(extension))
      return std::string(extension);
  return lowered(file.extension().string());
}

std::string extensionWithin(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  return extension == kGzipEnding ? extensionOf(file.stem()) : extension;
}

std::string stemOf(const std::filesystem::path& file) {
  const std::filesystem::path within = extensionOf(file) == kGzipEnding ? file.stem() : file.filename();
  const std::string name = within.string();
  return name.substr(0, name.size() - extensionOf(within).size());
}

std::optional<std::string> decodeBase64(std::string_view text) {
  constexpr std::string_view kSpaces = " \n\r\t";
  if (text.find_first_of(kSpaces) == text.npos)
    return bytesOfBase64(text);
  std::string digits;
  digits.reserve(text.size());
  std::copy_if(text.begin(), text.end(), std::back_inserter(digits),
               [kSpaces](char c) { return kSpaces.find(c) == kSpaces.npos; });
  return bytesOfBase64(digits);
}

} // namespace viscera::medical_io
