#include "label_formats/unpack_bzip2.h"

#include <algorithm>
#include <limits>

#include <bzlib.h>

namespace viscera::medical_io {
namespace {

constexpr std::size_t kFirstOutput = std::size_t{1} << 16U;

/// One bzip2 stream; ended however it is left.
struct Stream {
  explicit Stream(const FileBytes& file) {
    if (BZ2_bzDecompressInit(&bz, 0, 0) != BZ_OK)
      file.fail("It cannot be unpacked: bzip2 does not start");
  }
  ~Stream() { BZ2_bzDecompressEnd(&bz); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  bz_stream bz{};
};

unsigned chunk(std::size_t size) {
  return static_cast<unsigned>(std::min<std::size_t>(size, std::numeric_limits<unsigned>::max()));
}

/// Appends what one stream at the beginning of `packed` holds, until `out` has `most` bytes; gives what of
/// `packed` is left behind it.
std::string_view unpackStream(const FileBytes& file, std::string_view packed, std::uint64_t most,
                              std::string& out) {
  Stream stream(file);
  std::size_t written = out.size();
  int result = BZ_OK;
  while (result != BZ_STREAM_END && written < most) {
    if (written == out.size())
      out.resize(static_cast<std::size_t>(
          std::min<std::uint64_t>(most, std::max<std::size_t>(kFirstOutput, 2 * written))));
    stream.bz.next_in = const_cast<char*>(packed.data());
    stream.bz.avail_in = chunk(packed.size());
    stream.bz.next_out = out.data() + written;
    stream.bz.avail_out = chunk(out.size() - written);
    const unsigned hadIn = stream.bz.avail_in, hadOut = stream.bz.avail_out;
    result = BZ2_bzDecompress(&stream.bz);
    packed.remove_prefix(hadIn - stream.bz.avail_in);
    written += hadOut - stream.bz.avail_out;
    if (result != BZ_OK && result != BZ_STREAM_END)
      file.fail("the packed data are damaged (bzip2 error " + std::to_string(result) + ")");
    if (result == BZ_OK && packed.empty() && stream.bz.avail_out > 0)
      file.fail("the file is cut off: its packed data end too early");
  }
  out.resize(written);
  return packed;
}

} // namespace

std::string unpackedBzip2(const FileBytes& file, std::string_view packed, std::uint64_t most) {
  std::string out;
  do
    packed = unpackStream(file, packed, most, out);
  while (out.size() < most && packed.starts_with("BZh"));
  return out;
}

} // namespace viscera::medical_io
