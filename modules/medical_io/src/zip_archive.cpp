#include "zip_archive.h"

#include <algorithm>
#include <bit>
#include <limits>

#include <zlib.h>

#include "byte_cursor.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

constexpr auto kLittle = std::endian::little;
constexpr std::string_view kEndMark = "PK\x05\x06";
constexpr std::string_view kEnd64Mark = "PK\x06\x06";
constexpr std::string_view kLocator64Mark = "PK\x06\x07";
constexpr std::string_view kListMark = "PK\x01\x02";
constexpr std::string_view kPartMark = "PK\x03\x04";
constexpr std::size_t kEndBytes = 22;
constexpr std::size_t kLocator64Bytes = 20;
constexpr std::size_t kLongestRemark = 65535;
constexpr std::uint32_t kIn64Bits = 0xFFFFFFFF; ///< The number stands in the ZIP64 field.
constexpr std::uint16_t kZip64Field = 1;
constexpr std::uint16_t kEncrypted = 1;
constexpr std::uint16_t kStored = 0;
constexpr std::uint16_t kDeflated = 8;

/// Text of numbers is deflated to a tenth; a part that shrinks to less than this part of itself holds nothing
/// but repetition.
constexpr std::uint64_t kMostShrinking = 60;
constexpr std::uint64_t kAlwaysUnpacked = std::uint64_t{1} << 24U;

/// 1 January 1980, midnight.
constexpr std::uint16_t kFirstDay = 0x21;
constexpr std::uint16_t kDeflateVersion = 20;

/// Where the record at the end of the archive begins; a remark of the archive may follow it.
std::size_t endRecord(const FileBytes& file) {
  const std::string_view bytes = file.view();
  const std::size_t first =
      bytes.size() > kEndBytes + kLongestRemark ? bytes.size() - kEndBytes - kLongestRemark : 0;
  for (std::size_t at = bytes.rfind(kEndMark); at != bytes.npos && at >= first;
       at = at == 0 ? bytes.npos : bytes.rfind(kEndMark, at - 1)) {
    if (bytes.size() - at < kEndBytes)
      continue;
    const std::size_t remark = loadValue<std::uint16_t>(bytes.data() + at + 20, kLittle);
    if (at + kEndBytes + remark <= bytes.size())
      return at;
  }
  file.fail(diagnostic("the file is cut off: the list of its parts, which ends a ZIP archive, is missing"));
}

template <class Number>
Number takeNumber(ByteCursor& list) {
  return loadValue<Number>(list.takeBytes(sizeof(Number), "the list of the ZIP archive").data(), kLittle);
}

/// Takes the numbers that do not fit into 32 bits from a part's extra fields.
void readZip64(const FileBytes& file, std::string_view extra, ZipArchive::Part& part) {
  ByteCursor fields(file, extra, kLittle);
  while (fields.remaining() >= 4) {
    const auto kind = takeNumber<std::uint16_t>(fields);
    const auto size = takeNumber<std::uint16_t>(fields);
    ByteCursor field(file, fields.takeBytes(size, "a field"), kLittle);
    if (kind != kZip64Field)
      continue;
    for (std::uint64_t* number : {&part.bytes, &part.packedBytes, &part.header})
      if (*number == kIn64Bits)
        *number = takeNumber<std::uint64_t>(field);
    return;
  }
}

std::string_view bytesFrom(const FileBytes& file, std::uint64_t begin) {
  if (begin > file.bytes.size())
    file.fail(diagnostic("a part of the ZIP archive begins behind the end of the file"));
  return file.view().substr(static_cast<std::size_t>(begin));
}

} // namespace

std::string plainPartName(std::string_view name) {
  std::string plain = lowered(name);
  std::replace(plain.begin(), plain.end(), '\\', '/');
  return plain.starts_with('/') ? plain.substr(1) : plain;
}

ZipArchive::ZipArchive(const FileBytes& file) : file_(file) {
  const std::size_t end = endRecord(file);
  ByteCursor record(file, file.view().substr(end), kLittle);
  record.takeBytes(10, "the end of the archive");
  std::uint64_t count = takeNumber<std::uint16_t>(record);
  takeNumber<std::uint32_t>(record);
  std::uint64_t begin = takeNumber<std::uint32_t>(record);
  if (end >= kLocator64Bytes && file.view().substr(end - kLocator64Bytes).starts_with(kLocator64Mark)) {
    const auto place = loadValue<std::uint64_t>(file.bytes.data() + end - kLocator64Bytes + 8, kLittle);
    ByteCursor large(file, bytesFrom(file, place), kLittle);
    if (large.takeBytes(4, "the end of the archive") != kEnd64Mark)
      file.fail(diagnostic("the ZIP archive is damaged at its end"));
    large.takeBytes(28, "the end of the archive");
    count = takeNumber<std::uint64_t>(large);
    takeNumber<std::uint64_t>(large);
    begin = takeNumber<std::uint64_t>(large);
  }
  readList(begin, count);
}

void ZipArchive::readList(std::uint64_t begin, std::uint64_t count) {
  ByteCursor list(file_, bytesFrom(file_, begin), kLittle);
  for (std::uint64_t i = 0; i < count; ++i) {
    if (list.takeBytes(4, "a part of the list") != kListMark)
      file_.fail(diagnostic("the ZIP archive is damaged: part %1 of its list has no mark", i + 1));
    Part part;
    list.takeBytes(4, "a version");
    part.flags = takeNumber<std::uint16_t>(list);
    part.method = takeNumber<std::uint16_t>(list);
    list.takeBytes(4, "a date");
    part.checksum = takeNumber<std::uint32_t>(list);
    part.packedBytes = takeNumber<std::uint32_t>(list);
    part.bytes = takeNumber<std::uint32_t>(list);
    const auto nameBytes = takeNumber<std::uint16_t>(list);
    const auto extraBytes = takeNumber<std::uint16_t>(list);
    const auto remarkBytes = takeNumber<std::uint16_t>(list);
    list.takeBytes(8, "a part's attributes");
    part.header = takeNumber<std::uint32_t>(list);
    part.name = std::string(list.takeBytes(nameBytes, "a part's name"));
    readZip64(file_, list.takeBytes(extraBytes, "a part's fields"), part);
    list.takeBytes(remarkBytes, "a part's remark");
    parts_.push_back(std::move(part));
  }
}

const ZipArchive::Part* ZipArchive::find(std::string_view name) const {
  const std::string wanted = plainPartName(name);
  const auto found = std::find_if(parts_.begin(), parts_.end(),
                                  [&](const Part& part) { return plainPartName(part.name) == wanted; });
  return found == parts_.end() ? nullptr : &*found;
}

std::string_view ZipArchive::packed(const Part& part) const {
  if ((part.flags & kEncrypted) != 0)
    file_.fail(diagnostic("its part \"%1\" is encrypted", part.name), "export it without a password");
  if (part.method != kStored && part.method != kDeflated)
    file_.fail(
        diagnostic("its part \"%1\" is packed by method %2, which is not deflation", part.name, part.method));
  ByteCursor header(file_, bytesFrom(file_, part.header), kLittle);
  if (header.takeBytes(4, "the beginning of a part") != kPartMark)
    file_.fail(
        diagnostic("the ZIP archive is damaged: \"%1\" does not begin where its list says", part.name));
  header.takeBytes(22, "the beginning of a part");
  const auto nameBytes = takeNumber<std::uint16_t>(header);
  const auto extraBytes = takeNumber<std::uint16_t>(header);
  header.takeBytes(std::uint64_t{nameBytes} + extraBytes, "the beginning of a part");
  return header.takeBytes(part.packedBytes, "a part of the archive");
}

/// A stream of zlib without a header.
class ZipPartReader::Inflation {
public:
  Inflation() { started = inflateInit2(&stream, -MAX_WBITS) == Z_OK; }
  ~Inflation() { inflateEnd(&stream); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;

  z_stream stream{};
  bool started = false;
};

ZipPartReader::ZipPartReader(const ZipArchive& archive, const ZipArchive::Part& part, std::uint64_t mostBytes)
    : file_(archive.file()), part_(part), packed_(archive.packed(part)),
      checksum_(static_cast<std::uint32_t>(crc32(0, nullptr, 0))) {
  if (part.bytes > mostBytes ||
      (part.bytes > kAlwaysUnpacked && part.bytes / kMostShrinking > packed_.size()))
    file_.fail(diagnostic("its part \"%1\" would unpack from %2 to %3 bytes, which no model does", part.name,
                          packed_.size(), part.bytes));
  if (part.method == kStored && part.bytes != packed_.size())
    file_.fail(diagnostic("its part \"%1\" has two different sizes", part.name));
  if (part.method == kStored)
    return;
  inflation_ = std::make_unique<Inflation>();
  if (!inflation_->started)
    file_.fail(diagnostic("It cannot be unpacked: zlib does not start"));
}

ZipPartReader::~ZipPartReader() = default;

std::size_t ZipPartReader::read(char* out, std::size_t count) {
  count = static_cast<std::size_t>(std::min<std::uint64_t>(count, part_.bytes - done_));
  if (count == 0)
    return 0;
  count = std::min<std::size_t>(count, std::numeric_limits<unsigned>::max());
  if (inflation_) {
    z_stream& stream = inflation_->stream;
    stream.next_out = reinterpret_cast<Bytef*>(out);
    stream.avail_out = static_cast<unsigned>(count);
    while (stream.avail_out > 0) {
      const auto given =
          static_cast<unsigned>(std::min<std::size_t>(packed_.size(), std::numeric_limits<unsigned>::max()));
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed_.data()));
      stream.avail_in = given;
      const unsigned wanted = stream.avail_out;
      const int result = inflate(&stream, Z_NO_FLUSH);
      packed_.remove_prefix(given - stream.avail_in);
      const bool stands = stream.avail_out == wanted && stream.avail_in == given;
      if ((result != Z_OK && result != Z_STREAM_END) ||
          (stream.avail_out > 0 && (result == Z_STREAM_END || stands)))
        file_.fail(diagnostic("the packed data of \"%1\" are damaged", part_.name));
    }
  } else {
    packed_.copy(out, count);
    packed_.remove_prefix(count);
  }
  done_ += count;
  checksum_ = static_cast<std::uint32_t>(
      crc32(checksum_, reinterpret_cast<const Bytef*>(out), static_cast<unsigned>(count)));
  if (done_ == part_.bytes && checksum_ != part_.checksum)
    file_.fail(diagnostic("its part \"%1\" is damaged: its checksum differs", part_.name));
  return count;
}

namespace {

std::string deflatedBytes(const std::string& bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw CannotCreateError("zlib cannot pack it");
  std::string out(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<unsigned>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<unsigned>(out.size());
  const int result = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  if (result != Z_STREAM_END)
    throw CannotCreateError("zlib cannot pack it");
  return out;
}

void appendPartFields(std::string& out, const ZipArchive::Part& part) {
  appendValue(out, kDeflateVersion);
  appendValue(out, std::uint16_t{0});
  appendValue(out, kDeflated);
  appendValue(out, std::uint16_t{0});
  appendValue(out, kFirstDay);
  appendValue(out, part.checksum);
  appendValue(out, static_cast<std::uint32_t>(part.packedBytes));
  appendValue(out, static_cast<std::uint32_t>(part.bytes));
  appendValue(out, static_cast<std::uint16_t>(part.name.size()));
  appendValue(out, std::uint16_t{0});
}

} // namespace

std::string zipped(const std::vector<std::pair<std::string, std::string>>& parts) {
  std::string out, list;
  for (const auto& [name, bytes] : parts) {
    if (bytes.size() >= std::numeric_limits<std::uint32_t>::max())
      throw CannotCreateError("the surface is too large for 3MF, whose parts end at 4 GB", {},
                              phrase("let its name end in %1", ".ply, .vtp"));
    ZipArchive::Part part;
    part.name = name;
    part.header = out.size();
    part.bytes = bytes.size();
    part.checksum =
        static_cast<std::uint32_t>(crc32(crc32(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()),
                                         static_cast<unsigned>(bytes.size())));
    const std::string packed = deflatedBytes(bytes);
    part.packedBytes = packed.size();
    out += kPartMark;
    appendPartFields(out, part);
    out += name;
    out += packed;
    list += kListMark;
    appendValue(list, kDeflateVersion);
    appendPartFields(list, part);
    list.append(10, '\0'); // No remark, one disk, no attributes.
    appendValue(list, static_cast<std::uint32_t>(part.header));
    list += name;
  }
  if (out.size() >= std::numeric_limits<std::uint32_t>::max())
    throw CannotCreateError("the surface is too large for 3MF, whose parts end at 4 GB", {},
                            phrase("let its name end in %1", ".ply, .vtp"));
  const auto begin = static_cast<std::uint32_t>(out.size());
  out += list;
  out += kEndMark;
  out.append(4, '\0');
  appendValue(out, static_cast<std::uint16_t>(parts.size()));
  appendValue(out, static_cast<std::uint16_t>(parts.size()));
  appendValue(out, static_cast<std::uint32_t>(list.size()));
  appendValue(out, begin);
  out.append(2, '\0');
  return out;
}

} // namespace viscera::medical_io
