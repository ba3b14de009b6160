#include "label_formats/data_file.h"

#include <algorithm>
#include <cmath>

#include "text_scanner.h"
#include "viscera/core/error.h"

namespace viscera::medical_io {
namespace {

/// The bytes with the voxels, which may be those of another file, from where they begin.
struct Source {
  FileBytes file;
  std::size_t begin = 0;
};

Source sourceOf(FileBytes& file, const StoredValues& stored) {
  if (!stored.beside)
    return {std::move(file), stored.headerEnd};
  const std::filesystem::path name(*stored.beside);
  const bool several = stored.pattern && stored.beside->find('%') != std::string::npos;
  if (name.empty() || name.has_root_path() || several)
    file.fail("its voxels are in several files or in another folder (" + inQuotes(*stored.beside) + ")",
              "save it as one file");
  try {
    return {readWholeFile(file.file.parent_path() / name), 0};
  } catch (const DataError& error) {
    file.fail("the file with its voxels, " + inQuotes(*stored.beside) +
              ", cannot be used: " + error.problem());
  } catch (const NoInputError& error) {
    throw NoInputError("the file with its voxels, " + inQuotes(*stored.beside) +
                           ", cannot be read: " + error.problem(),
                       file.name(), "put both files into one folder");
  }
}

void skipLines(Source& source, std::uint64_t lines) {
  for (; lines > 0; --lines) {
    const std::size_t end = source.file.view().find('\n', source.begin);
    if (end == std::string_view::npos)
      source.file.fail("the file is cut off: it has fewer lines than its header says");
    source.begin = end + 1;
  }
}

/// Numbers in words become bytes of the scalar type double, which holds every label exactly.
void takeText(const Source& source, RawLabels& raw) {
  TextScanner scanner(source.file, source.file.view().substr(source.begin));
  raw.storage.clear();
  const std::uint64_t count = raw.valueCount();
  if (count > scanner.remaining())
    source.file.fail("the file is cut off: " + std::to_string(count) +
                     " values are promised, there are only " + counted(scanner.remaining(), "byte", "bytes"));
  for (std::uint64_t i = 0; i < count; ++i)
    appendValue(raw.storage, scanner.number("a voxel"));
  raw.scalar = Scalar::float64;
  raw.order = std::endian::little;
}

void takeValuesOf(Source& source, const StoredValues& stored, RawLabels& raw) {
  skipLines(source, stored.skippedLines);
  if (stored.text) {
    takeText(source, raw);
    return;
  }
  const std::uint64_t wanted = raw.byteCount();
  if (stored.packing != Packing::none) {
    const std::string_view packed =
        source.file.view().substr(std::min(source.begin, source.file.bytes.size()));
    const std::uint64_t most = saturatedSum(saturatedSum(stored.skippedBytes, wanted), 1);
    raw.storage = unpacked(source.file, packed, stored.packing, most);
    source.begin = 0;
  } else {
    raw.storage = std::move(source.file.bytes);
  }
  const std::uint64_t begin = stored.atEnd && raw.storage.size() >= wanted
                                  ? raw.storage.size() - wanted
                                  : saturatedSum(source.begin, stored.skippedBytes);
  raw.offset = static_cast<std::size_t>(std::min<std::uint64_t>(begin, raw.storage.size()));
  requireAllValues(raw, source.file);
}

} // namespace

void takeValues(FileBytes& file, const StoredValues& stored, RawLabels& raw) {
  const FileBytes named{file.file, {}};
  Source source = sourceOf(file, stored);
  file.file = named.file;
  try {
    takeValuesOf(source, stored, raw);
  } catch (const DataError& error) {
    if (!stored.beside)
      throw;
    named.fail("the file with its voxels, " + inQuotes(*stored.beside) +
               ", cannot be used: " + error.problem());
  }
}

} // namespace viscera::medical_io
