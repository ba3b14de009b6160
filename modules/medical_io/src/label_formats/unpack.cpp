#include "label_formats/unpack.h"

#include <algorithm>
#include <limits>

#include <bzlib.h>
#include <zlib.h>

namespace viscera::medical_io {
namespace {

constexpr std::size_t kFirstOutput = std::size_t{1} << 16U;
/// zlib finds out itself whether a gzip or a zlib header comes.
constexpr int kAnyHeader = MAX_WBITS + 32;

/// One stream of a library; ended however it is left.
class Zlib {
public:
  static constexpr std::string_view kNextStream = "\x1f\x8b"; ///< With what another one begins.

  explicit Zlib(const FileBytes& file) : file_(file) {
    if (inflateInit2(&stream, kAnyHeader) != Z_OK)
      file.fail("It cannot be unpacked: zlib does not start");
  }
  ~Zlib() { inflateEnd(&stream); }
  Zlib(const Zlib&) = delete;
  Zlib& operator=(const Zlib&) = delete;

  /// True at the stream's end.
  bool unpack() {
    const int result = inflate(&stream, Z_NO_FLUSH);
    if (result != Z_OK && result != Z_BUF_ERROR && result != Z_STREAM_END)
      file_.fail("the packed data are damaged" +
                 (stream.msg != nullptr ? " (" + std::string(stream.msg) + ")" : std::string()));
    return result == Z_STREAM_END;
  }

  z_stream stream{};

private:
  const FileBytes& file_;
};

class Bzip2 {
public:
  static constexpr std::string_view kNextStream = "BZh";

  explicit Bzip2(const FileBytes& file) : file_(file) {
    if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK)
      file.fail("It cannot be unpacked: bzip2 does not start");
  }
  ~Bzip2() { BZ2_bzDecompressEnd(&stream); }
  Bzip2(const Bzip2&) = delete;
  Bzip2& operator=(const Bzip2&) = delete;

  bool unpack() {
    const int result = BZ2_bzDecompress(&stream);
    if (result != BZ_OK && result != BZ_STREAM_END)
      file_.fail("the packed data are damaged (bzip2 error " + std::to_string(result) + ")");
    return result == BZ_STREAM_END;
  }

  bz_stream stream{};

private:
  const FileBytes& file_;
};

unsigned chunk(std::size_t size) {
  return static_cast<unsigned>(std::min<std::size_t>(size, std::numeric_limits<unsigned>::max()));
}

/// Appends what one stream at the beginning of `packed` holds, until `out` has `most` bytes; gives what of
/// `packed` is left behind it.
template <class Library>
std::string_view unpackStream(const FileBytes& file, std::string_view packed, std::uint64_t most,
                              std::string& out) {
  Library library(file);
  auto& stream = library.stream;
  std::size_t written = out.size();
  for (bool ended = false; !ended && written < most;) {
    if (written == out.size())
      out.resize(static_cast<std::size_t>(
          std::min<std::uint64_t>(most, std::max<std::size_t>(kFirstOutput, 2 * written))));
    stream.next_in = reinterpret_cast<decltype(stream.next_in)>(const_cast<char*>(packed.data()));
    stream.avail_in = chunk(packed.size());
    stream.next_out = reinterpret_cast<decltype(stream.next_out)>(out.data() + written);
    stream.avail_out = chunk(out.size() - written);
    const unsigned hadIn = stream.avail_in, hadOut = stream.avail_out;
    ended = library.unpack();
    packed.remove_prefix(hadIn - stream.avail_in);
    written += hadOut - stream.avail_out;
    if (!ended && packed.empty() && stream.avail_out > 0)
      file.fail("the file is cut off: its packed data end too early");
  }
  out.resize(written);
  return packed;
}

template <class Library>
std::string unpackStreams(const FileBytes& file, std::string_view packed, std::uint64_t most) {
  std::string out;
  do
    packed = unpackStream<Library>(file, packed, most, out);
  while (out.size() < most && packed.starts_with(Library::kNextStream));
  return out;
}

} // namespace

std::string unpacked(const FileBytes& file, std::string_view packed, Packing packing, std::uint64_t most) {
  return packing == Packing::bzip2 ? unpackStreams<Bzip2>(file, packed, most)
                                   : unpackStreams<Zlib>(file, packed, most);
}

} // namespace viscera::medical_io
