#include "label_formats/inflate.h"

#include <algorithm>
#include <limits>

#include <zlib.h>

namespace viscera::medical_io {
namespace {

constexpr std::size_t kFirstOutput = std::size_t{1} << 16U;
/// zlib finds out itself whether a gzip or a zlib header comes.
constexpr int kAnyHeader = MAX_WBITS + 32;

/// Ends zlib's stream however it is left.
struct Stream {
  z_stream z{};
  ~Stream() { inflateEnd(&z); }
};

uInt chunk(std::size_t size) {
  return static_cast<uInt>(std::min<std::size_t>(size, std::numeric_limits<uInt>::max()));
}

} // namespace

std::string inflated(const FileBytes& file, std::string_view packed, std::uint64_t most) {
  Stream stream;
  if (inflateInit2(&stream.z, kAnyHeader) != Z_OK)
    file.fail("It cannot be unpacked: zlib does not start");
  std::string out;
  std::size_t read = 0, written = 0;
  while (written < most) {
    if (written == out.size())
      out.resize(
          static_cast<std::size_t>(std::min<std::uint64_t>(most, std::max(kFirstOutput, 2 * written))));
    stream.z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + read));
    stream.z.avail_in = chunk(packed.size() - read);
    stream.z.next_out = reinterpret_cast<Bytef*>(out.data() + written);
    stream.z.avail_out = chunk(out.size() - written);
    const uInt hadIn = stream.z.avail_in, hadOut = stream.z.avail_out;
    const int result = inflate(&stream.z, Z_NO_FLUSH);
    read += hadIn - stream.z.avail_in;
    written += hadOut - stream.z.avail_out;
    if (result == Z_STREAM_END) {
      // Another gzip member may follow.
      if (packed.size() - read < 2 || !packed.substr(read).starts_with("\x1f\x8b"))
        break;
      if (inflateReset(&stream.z) != Z_OK)
        file.fail("It cannot be unpacked: zlib does not start again");
    } else if (result != Z_OK && result != Z_BUF_ERROR) {
      file.fail("the packed data are damaged" +
                (stream.z.msg != nullptr ? " (" + std::string(stream.z.msg) + ")" : std::string()));
    } else if (read == packed.size() && stream.z.avail_out > 0) {
      file.fail("the file is cut off: its packed data end too early");
    }
  }
  out.resize(written);
  return out;
}

} // namespace viscera::medical_io
