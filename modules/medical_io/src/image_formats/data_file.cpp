#include "image_formats/data_file.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <limits>
#include <system_error>

#include "text_scanner.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

/// The most of a number in words with its white space.
constexpr std::uint64_t kMostBytesOfWord = 32;

/// The bytes with the voxels, which may be those of another file, from where they begin.
struct Source {
  FileBytes file;
  std::size_t begin = 0;
};

/// The file beside `file` that has the voxels.
std::filesystem::path besideOf(const FileBytes& file, const StoredValues& stored) {
  const std::filesystem::path name(*stored.beside);
  if (name.empty() || name.has_root_path())
    file.fail(phrase("its voxels are in another folder (%1)", inQuotes(*stored.beside)),
              "put both files into one folder");
  return file.file.parent_path() / name;
}

[[noreturn]] void failAsUseless(const FileBytes& file, const StoredValues& stored, const DataError& error) {
  file.fail(
      phrase("the file with its voxels, %1, cannot be read: %2", inQuotes(*stored.beside), error.problem()));
}

/// Calls `read` with the file that has the voxels; errors name `file`.
template <class Read>
auto readBeside(const FileBytes& file, const StoredValues& stored, const Read& read) {
  const std::filesystem::path beside = besideOf(file, stored);
  try {
    return read(beside);
  } catch (const DataError& error) {
    failAsUseless(file, stored, error);
  } catch (const NoInputError& error) {
    throw NoInputError(
        phrase("the file with its voxels, %1, cannot be read: %2", inQuotes(*stored.beside), error.problem()),
        file.name(), "put both files into one folder");
  }
}

Source sourceOf(FileBytes& file, const StoredValues& stored) {
  if (!stored.beside)
    return {std::move(file), stored.headerEnd};
  return readBeside(file, stored, [](const auto& beside) { return Source{readWholeFile(beside), 0}; });
}

void skipLines(Source& source, std::uint64_t lines) {
  for (; lines > 0; --lines) {
    const std::size_t end = source.file.view().find('\n', source.begin);
    if (end == std::string_view::npos)
      source.file.fail(diagnostic("the file is cut off: it has fewer lines than its header says"));
    source.begin = end + 1;
  }
}

/// Numbers in words become bytes of the scalar type double, which holds every label exactly.
void takeText(const Source& source, RawImage& raw) {
  TextScanner scanner(source.file, source.file.view().substr(source.begin));
  raw.storage.clear();
  const std::uint64_t count = raw.valueCount();
  if (count > scanner.remaining())
    source.file.fail(
        diagnostic("the file is cut off: %2 values are promised, there {is|are} only %n {byte|bytes}",
                   scanner.remaining(), count));
  for (std::uint64_t i = 0; i < count; ++i)
    appendValue(raw.storage, scanner.number("a voxel"));
  raw.scalar = Scalar::float64;
  raw.order = std::endian::little;
}

void takeValuesOf(Source& source, const StoredValues& stored, RawImage& raw) {
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

/// Hands values on in blocks that are aligned for any scalar type.
class Blocks {
public:
  using Visit = std::function<void(const char*, std::size_t)>;
  Blocks(std::uint64_t count, std::size_t width, Progress& progress, const Visit& visit)
      : count_(count), width_(width), progress_(progress), visit_(visit),
        buffer_(static_cast<std::size_t>(std::min<std::uint64_t>(count, kBlockValues))) {}

  /// Calls `fill(bytes, wanted)` for block after block; it gives the bytes there were.
  template <class Fill>
  void run(const FileBytes& file, const Fill& fill) {
    char* bytes = reinterpret_cast<char*>(buffer_.data());
    for (std::uint64_t done = 0; done < count_;) {
      progress_.report(static_cast<double>(done) / static_cast<double>(count_), "voxels");
      progress_.throwIfCancelled();
      const auto values = static_cast<std::size_t>(std::min<std::uint64_t>(kBlockValues, count_ - done));
      if (fill(bytes, values * width_) < values * width_)
        file.fail(diagnostic("the file is cut off: its header promises more voxels than there are"));
      visit_(bytes, values);
      done += values;
    }
  }

private:
  static constexpr std::size_t kBlockValues = std::size_t{1} << 16U;

  std::uint64_t count_;
  std::size_t width_;
  Progress& progress_;
  const Visit& visit_;
  std::vector<std::uint64_t> buffer_; ///< The widest scalar has eight bytes.
};

/// The place of voxels that are not packed, from byte `begin` on; `whole` is what the header promises.
struct PlainVoxels {
  std::uint64_t begin = 0;
  std::uint64_t whole = 0;
  bool atEnd = false;
};

/// Opens the file; gives its length.
std::uint64_t openedAtEnd(std::ifstream& stream, const FileBytes& file) {
  errno = 0;
  stream.open(file.file, std::ios::binary | std::ios::ate);
  if (!stream)
    throw NoInputError(phrase("It cannot be opened: %1", std::generic_category().message(errno)), file.name(),
                       "check that you may read it");
  return static_cast<std::uint64_t>(std::max<std::streamoff>(stream.tellg(), 0));
}

/// `file` holds the beginning, or nothing but its name.
void visitPlain(const FileBytes& file, const PlainVoxels& voxels, std::uint64_t skipped,
                const std::function<void(std::uint64_t)>& prepare, std::uint64_t count, Blocks& blocks) {
  std::ifstream stream;
  const std::uint64_t length = file.unpacked ? file.bytes.size() : openedAtEnd(stream, file);
  const std::uint64_t begin =
      voxels.atEnd && length >= voxels.whole ? length - voxels.whole : std::min(voxels.begin, length);
  if (length - begin < voxels.whole)
    file.fail(diagnostic("the file is cut off: its header promises %1 bytes of voxels, %2 are there",
                         voxels.whole, length - begin));
  prepare(count);
  const auto held = static_cast<std::uint64_t>(file.bytes.size());
  std::uint64_t at = begin + skipped;
  if (!file.unpacked)
    stream.seekg(static_cast<std::streamoff>(std::max(at, held)));
  blocks.run(file, [&](char* bytes, std::size_t wanted) {
    std::size_t got = at < held ? file.view().copy(bytes, wanted, static_cast<std::size_t>(at)) : 0;
    if (got < wanted && !file.unpacked) {
      stream.read(bytes + got, static_cast<std::streamsize>(wanted - got));
      got += static_cast<std::size_t>(stream.gcount());
    }
    at += got;
    return got;
  });
}

/// No zlib stream is longer than this many times its packed bytes.
constexpr std::uint64_t kMostOfZlib = 1032;

void visitPacked(const FileBytes& source, std::size_t begin, const StoredValues& stored,
                 std::uint64_t skipped, const std::function<void(std::uint64_t)>& prepare,
                 std::uint64_t count, std::uint64_t bytes, Blocks& blocks) {
  const std::string_view packed = source.view().substr(std::min(begin, source.bytes.size()));
  Unpacker unpacker(source, packed, stored.packing);
  std::uint64_t left = saturatedSum(stored.skippedBytes, skipped);
  std::vector<char> aside(static_cast<std::size_t>(std::min<std::uint64_t>(left, std::uint64_t{1} << 16U)));
  while (left > 0) {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(left, aside.size()));
    if (unpacker.read(aside.data(), wanted) < wanted)
      source.fail(diagnostic("the file is cut off: its header promises more voxels than there are"));
    left -= wanted;
  }
  if (stored.packing == Packing::zlib && bytes / kMostOfZlib <= packed.size())
    prepare(count);
  blocks.run(source, [&](char* out, std::size_t wanted) { return unpacker.read(out, wanted); });
}

void takeValues(FileBytes& file, const StoredValues& stored, RawImage& raw) {
  const FileBytes named{file.file, {}};
  Source source = sourceOf(file, stored);
  file.file = named.file;
  try {
    takeValuesOf(source, stored, raw);
  } catch (const DataError& error) {
    if (!stored.beside)
      throw;
    failAsUseless(named, stored, error);
  }
}

/// Visits the values of one file.
void visitOneFile(const FileBytes& file, const StoredValues& stored, RawImage& raw, const ValueRange& range,
                  Progress& progress, const std::function<void(std::uint64_t)>& prepare,
                  const std::function<void(const char*, std::size_t)>& visit) {
  const std::size_t width = sizeOf(raw.scalar);
  const std::uint64_t skipped = saturatedProduct(range.first, width);
  const auto walk = [&](const FileBytes& begin) {
    const std::size_t first = stored.beside ? 0 : stored.headerEnd;
    Blocks blocks(range.count, width, progress, visit);
    if (stored.packing == Packing::none)
      visitPlain(begin, {saturatedSum(first, stored.skippedBytes), raw.byteCount(), stored.atEnd}, skipped,
                 prepare, range.count, blocks);
    else
      visitPacked(readRestOfFile(begin), first, stored, skipped, prepare, range.count,
                  saturatedProduct(range.count, width), blocks);
    return true;
  };
  const bool atEndOfPacked = stored.atEnd && stored.packing != Packing::none;
  if (!stored.text && stored.skippedLines == 0 && !atEndOfPacked) {
    if (stored.beside)
      readBeside(file, stored, [&](const auto& beside) { return walk(FileBytes{beside, {}, 0}); });
    else
      walk(file);
    return;
  }
  FileBytes whole = readRestOfFile(file);
  takeValues(whole, stored, raw);
  const std::size_t stride = sizeOf(raw.scalar);
  std::string_view rest = raw.values().substr(static_cast<std::size_t>(range.first) * stride);
  prepare(range.count);
  Blocks blocks(range.count, stride, progress, visit);
  blocks.run(file, [&](char* bytes, std::size_t wanted) {
    const std::size_t there = rest.copy(bytes, wanted);
    rest.remove_prefix(there);
    return there;
  });
  raw.storage = {};
}

/// The values of one of several files.
struct Part {
  StoredValues stored;
  RawImage raw;
};

std::vector<Part> partsOf(const FileBytes& file, const StoredValues& stored, const RawImage& raw) {
  const std::uint64_t count = raw.valueCount(), files = stored.parts.size(), each = count / files;
  if (count % files != 0 || each > std::numeric_limits<int>::max())
    file.fail(diagnostic("its header is damaged: %1 values cannot be in %2 equal files", count, files));
  StoredValues one = stored;
  one.parts.clear();
  std::vector<Part> parts;
  for (const std::string& name : stored.parts) {
    Part& part = parts.emplace_back();
    part.stored = one;
    part.stored.beside = name;
    part.raw.size = {static_cast<int>(each), 1, 1};
    part.raw.scalar = raw.scalar;
    part.raw.order = raw.order;
  }
  return parts;
}

std::uint64_t bytesThere(const FileBytes& file, const std::vector<Part>& parts) {
  std::uint64_t sum = 0;
  for (const Part& part : parts) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(besideOf(file, part.stored), error);
    sum = saturatedSum(sum, error ? 0 : size);
  }
  return sum;
}

/// Visits the values of several files, one after the other.
void visitSeveralFiles(const FileBytes& file, const StoredValues& stored, RawImage& raw,
                       const ValueRange& range, Progress& progress,
                       const std::function<void(std::uint64_t)>& prepare,
                       const std::function<void(const char*, std::size_t)>& visit) {
  std::vector<Part> parts = partsOf(file, stored, raw);
  if (raw.byteCount() / (stored.packing == Packing::none ? 1 : kMostOfZlib) <= bytesThere(file, parts))
    prepare(range.count);
  const std::uint64_t each = raw.valueCount() / parts.size();
  std::uint64_t begin = 0;
  for (Part& part : parts) {
    const std::uint64_t first = std::max(begin, range.first);
    const std::uint64_t end = std::min(begin + each, range.first + range.count);
    progress.report(static_cast<double>(begin) / static_cast<double>(raw.valueCount()), "voxels");
    progress.throwIfCancelled();
    if (first < end) {
      Progress quiet;
      visitOneFile(
          file, part.stored, part.raw, {first - begin, end - first}, quiet, [](std::uint64_t) {},
          [&](const char* bytes, std::size_t count) {
            raw.scalar = part.raw.scalar; // Numbers in words have another type than the header says.
            raw.order = part.raw.order;
            visit(bytes, count);
          });
    }
    begin += each;
  }
}

/// How many bytes a packed file has, counted up to `most`.
std::uint64_t unpackedLength(const FileBytes& file, const StoredValues& stored, std::size_t begin,
                             std::uint64_t most) {
  const FileBytes whole = readRestOfFile(file);
  Unpacker unpacker(whole, whole.view().substr(std::min(begin, whole.bytes.size())), stored.packing);
  std::vector<char> aside(std::size_t{1} << 16U);
  std::uint64_t length = 0;
  while (length < most) {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(most - length, aside.size()));
    const std::size_t got = unpacker.read(aside.data(), wanted);
    length += got;
    if (got < wanted)
      break;
  }
  return length;
}

} // namespace

void visitValues(const FileBytes& file, const StoredValues& stored, RawImage& raw, const ValueRange& range,
                 Progress& progress, const std::function<void(std::uint64_t)>& prepare,
                 const std::function<void(const char*, std::size_t)>& visit) {
  if (stored.parts.empty())
    visitOneFile(file, stored, raw, range, progress, prepare, visit);
  else
    visitSeveralFiles(file, stored, raw, range, progress, prepare, visit);
}

ImageHeader headerBehindGzip(FileBytes& file, ImageHeader (*read)(const FileBytes&)) {
  if (!file.view().starts_with("\x1f\x8b"))
    return read(file);
  FileBytes inner{file.file, unpacked(file, file.view(), Packing::zlib, kMostHeaderBytes / 2)};
  ImageHeader header = read(inner);
  StoredValues& stored = header.stored;
  if (stored.elsewhere())
    return header;
  if (stored.packing == Packing::none && !stored.text && !stored.atEnd && stored.skippedLines == 0) {
    stored.packing = Packing::zlib;
    stored.skippedBytes = saturatedSum(stored.skippedBytes, stored.headerEnd);
    stored.headerEnd = 0;
    return header;
  }
  const std::uint64_t each = stored.text ? kMostBytesOfWord : sizeOf(header.image.scalar);
  const std::uint64_t values = saturatedProduct(header.image.valueCount(), each);
  const FileBytes whole = readRestOfFile(file);
  inner.bytes = unpacked(whole, whole.view(), Packing::zlib,
                         saturatedSum(saturatedSum(values, stored.skippedBytes), kMostHeaderBytes));
  inner.length = inner.bytes.size();
  inner.unpacked = true;
  file = std::move(inner);
  return header;
}

bool holdsValuesOf(const FileBytes& file, const StoredValues& stored, const RawImage& raw, Scalar scalar) {
  if (stored.text || stored.skippedLines > 0)
    return false;
  RawImage wide;
  wide.size = raw.size;
  wide.layers = raw.layers;
  wide.scalar = scalar;
  const std::uint64_t wanted = saturatedSum(stored.skippedBytes, wide.byteCount());
  try {
    if (!stored.parts.empty())
      return stored.packing == Packing::none &&
             bytesThere(file, partsOf(file, stored, wide)) >= wide.byteCount();
    const auto holds = [&](const FileBytes& source) {
      const std::size_t begin = stored.beside ? 0 : stored.headerEnd;
      if (stored.packing != Packing::none)
        return unpackedLength(source, stored, begin, wanted) >= wanted;
      std::ifstream stream;
      const std::uint64_t length = source.unpacked ? source.bytes.size() : openedAtEnd(stream, source);
      return length >= saturatedSum(begin, wanted);
    };
    return stored.beside ? readBeside(file, stored,
                                      [&](const auto& name) {
                                        return holds(stored.packing == Packing::none ? FileBytes{name, {}, 0}
                                                                                     : readWholeFile(name));
                                      })
                         : holds(file);
  } catch (const Error&) {
    return false; // What is wrong with the file is said when it is read.
  }
}

} // namespace viscera::medical_io
