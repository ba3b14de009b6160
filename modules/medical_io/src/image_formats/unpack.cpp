#include "image_formats/unpack.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <bzlib.h>
#include <zlib.h>

#include "viscera/core/phrase.h"

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
      file.fail(diagnostic("It cannot be unpacked: zlib does not start"));
  }
  ~Zlib() { inflateEnd(&stream); }
  Zlib(const Zlib&) = delete;
  Zlib& operator=(const Zlib&) = delete;

  /// True at the stream's end.
  bool unpack() {
    const int result = inflate(&stream, Z_NO_FLUSH);
    if (result != Z_OK && result != Z_BUF_ERROR && result != Z_STREAM_END)
      file_.fail(stream.msg != nullptr
                     ? diagnostic("the packed data are damaged (%1)", std::string(stream.msg))
                     : diagnostic("the packed data are damaged"));
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
      file.fail(diagnostic("It cannot be unpacked: bzip2 does not start"));
  }
  ~Bzip2() { BZ2_bzDecompressEnd(&stream); }
  Bzip2(const Bzip2&) = delete;
  Bzip2& operator=(const Bzip2&) = delete;

  bool unpack() {
    const int result = BZ2_bzDecompress(&stream);
    if (result != BZ_OK && result != BZ_STREAM_END)
      file_.fail(diagnostic("the packed data are damaged (bzip2 error %1)", result));
    return result == BZ_STREAM_END;
  }

  bz_stream stream{};

private:
  const FileBytes& file_;
};

unsigned chunk(std::size_t size) {
  return static_cast<unsigned>(std::min<std::size_t>(size, std::numeric_limits<unsigned>::max()));
}

} // namespace

class Unpacker::Library {
public:
  virtual ~Library() = default;
  virtual std::size_t read(char* out, std::size_t count) = 0;
};

template <class Kind>
class Unpacker::LibraryOf final : public Library {
public:
  LibraryOf(const FileBytes& file, std::string_view packed) : file_(file), packed_(packed) {
    stream_.emplace(file);
  }

  std::size_t read(char* out, std::size_t count) override {
    std::size_t written = 0;
    while (written < count && stream_) {
      auto& stream = stream_->stream;
      stream.next_in = reinterpret_cast<decltype(stream.next_in)>(const_cast<char*>(packed_.data()));
      stream.avail_in = chunk(packed_.size());
      stream.next_out = reinterpret_cast<decltype(stream.next_out)>(out + written);
      stream.avail_out = chunk(count - written);
      const unsigned hadIn = stream.avail_in, hadOut = stream.avail_out;
      const bool ended = stream_->unpack();
      packed_.remove_prefix(hadIn - stream.avail_in);
      written += hadOut - stream.avail_out;
      if (ended)
        startNext();
      else if (packed_.empty() && stream.avail_out > 0)
        file_.fail(diagnostic("the file is cut off: its packed data end too early"));
    }
    return written;
  }

private:
  void startNext() {
    stream_.reset();
    if (packed_.starts_with(Kind::kNextStream))
      stream_.emplace(file_);
  }

  const FileBytes& file_;
  std::string_view packed_;
  std::optional<Kind> stream_;
};

Unpacker::Unpacker(const FileBytes& file, std::string_view packed, Packing packing) {
  if (packing == Packing::bzip2)
    library_ = std::make_unique<LibraryOf<Bzip2>>(file, packed);
  else
    library_ = std::make_unique<LibraryOf<Zlib>>(file, packed);
}

Unpacker::~Unpacker() = default;

std::size_t Unpacker::read(char* out, std::size_t count) {
  return library_->read(out, count);
}

std::string unpacked(const FileBytes& file, std::string_view packed, Packing packing, std::uint64_t most) {
  Unpacker unpacker(file, packed, packing);
  std::string out;
  for (bool more = true; more && out.size() < most;) {
    const std::size_t written = out.size();
    out.resize(static_cast<std::size_t>(
        std::min<std::uint64_t>(most, std::max<std::size_t>(kFirstOutput, 2 * written))));
    const std::size_t wanted = out.size() - written;
    const std::size_t got = unpacker.read(out.data() + written, wanted);
    out.resize(written + got);
    more = got == wanted;
  }
  return out;
}

} // namespace viscera::medical_io
