#include "dicom/deflated_dicom.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>

#include "file_bytes.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/quiet_dcmtk.h"

// DCMTK wants its configuration before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>
#include <zlib.h>

namespace viscera::medical_io {
namespace {

/// A picture of nothing packs a thousand times; a scan is seldom packed twenty times.
constexpr std::uint64_t kInflatedAlways = std::uint64_t{128} << 20U, kInflatedPerByte = 20;
constexpr std::streamoff kPreamble = 128;

bool isDeflated(const std::filesystem::path& file) {
  DcmMetaInfo meta;
  OFString syntax;
  return meta.loadFile(file.c_str()).good() &&
         meta.findAndGetOFString(DCM_TransferSyntaxUID, syntax).good() &&
         syntax == UID_DeflatedExplicitVRLittleEndianTransferSyntax;
}

std::uint32_t littleEndian(const unsigned char* bytes, int count) {
  std::uint32_t value = 0;
  for (int i = count - 1; i >= 0; --i)
    value = value << 8U | bytes[i];
  return value;
}

/// Where the data begin: behind the elements of group 2, which are never packed. None: they are not written
/// as the standard wants them.
std::optional<std::streamoff> dataBegin(std::ifstream& stream, std::streamoff size) {
  std::array<unsigned char, 12> head{};
  const auto bytes = reinterpret_cast<char*>(head.data());
  const bool marked = stream.seekg(kPreamble).read(bytes, 4) && std::string_view(bytes, 4) == "DICM";
  stream.clear();
  std::streamoff at = marked ? kPreamble + 4 : 0, elements = 0; // Some files have no preamble.
  while (at + 8 <= size && stream.seekg(at).read(bytes, 8) && littleEndian(head.data(), 2) == 2) {
    const std::string_view kind(bytes + 4, 2);
    const bool isLong = kind == "OB" || kind == "UN" || kind == "OW" || kind == "UT" || kind == "SQ";
    if (isLong && !stream.read(bytes + 8, 4))
      return std::nullopt;
    at += isLong ? 12 + std::streamoff(littleEndian(head.data() + 8, 4))
                 : 8 + std::streamoff(littleEndian(head.data() + 6, 2));
    ++elements;
  }
  return elements > 0 && at <= size ? std::optional(at) : std::nullopt;
}

/// How many bytes come out, up to somewhat more than `most`; of damaged data those before the damage.
std::uint64_t inflatedBytes(std::ifstream& stream, std::uint64_t most) {
  std::array<char, 1 << 15> packed;
  std::array<Bytef, 1 << 16> unpacked;
  z_stream zlib{};
  if (inflateInit2(&zlib, -MAX_WBITS) != Z_OK)
    return 0;
  std::uint64_t bytes = 0;
  int state = Z_OK;
  while (state == Z_OK && bytes <= most) {
    stream.read(packed.data(), packed.size());
    zlib.next_in = reinterpret_cast<Bytef*>(packed.data());
    zlib.avail_in = static_cast<uInt>(stream.gcount());
    if (zlib.avail_in == 0)
      break;
    do {
      zlib.next_out = unpacked.data();
      zlib.avail_out = static_cast<uInt>(unpacked.size());
      state = inflate(&zlib, Z_NO_FLUSH);
      bytes += unpacked.size() - zlib.avail_out;
    } while (state == Z_OK && zlib.avail_out == 0 && bytes <= most);
    if (state == Z_BUF_ERROR) // It wants more to read.
      state = Z_OK;
  }
  inflateEnd(&zlib);
  return bytes;
}

} // namespace

void requireBoundedInflation(const std::filesystem::path& file) {
  silenceDcmtk();
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) || !isDeflated(file))
    return;
  const FileBytes named{file, {}};
  const auto size = std::filesystem::file_size(file, error);
  std::ifstream stream(file, std::ios::binary);
  const auto begin = dataBegin(stream, error ? 0 : static_cast<std::streamoff>(size));
  if (!begin)
    named.fail(diagnostic("It is damaged or no DICOM file: its header violates the DICOM standard"));
  stream.clear();
  stream.seekg(*begin);
  const std::uint64_t most = kInflatedAlways + kInflatedPerByte * size;
  if (inflatedBytes(stream, most) > most)
    named.fail(diagnostic("its packed data are more than %1 MB unpacked, which no scan of its size is",
                          most >> 20U));
}

} // namespace viscera::medical_io
