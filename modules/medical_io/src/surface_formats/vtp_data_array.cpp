#include "surface_formats/vtp_data_array.h"

#include <algorithm>
#include <array>
#include <optional>

#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

#include "scalar.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

/// zlib, the best of the three on constant data, shrinks to a 1032nd at most; more is a lie of the header.
constexpr std::uint64_t kMostInflation = 1100;
constexpr std::uint64_t kLargestArray = std::uint64_t{1} << 32U;

constexpr std::array<std::pair<std::string_view, Scalar>, 11> kVtpTypes = {{{"Int8", Scalar::int8},
                                                                            {"UInt8", Scalar::uint8},
                                                                            {"Int16", Scalar::int16},
                                                                            {"UInt16", Scalar::uint16},
                                                                            {"Int32", Scalar::int32},
                                                                            {"UInt32", Scalar::uint32},
                                                                            {"Int64", Scalar::int64},
                                                                            {"UInt64", Scalar::uint64},
                                                                            {"String", Scalar::int8},
                                                                            {"Float32", Scalar::float32},
                                                                            {"Float64", Scalar::float64}}};

/// Unpacks one block, whose length is known. False when it is damaged or has another length.
using Unpack = bool (*)(std::string_view packed, char* out, std::size_t size);

bool unpackZlib(std::string_view packed, char* out, std::size_t size) {
  auto got = static_cast<uLongf>(size);
  return uncompress(reinterpret_cast<Bytef*>(out), &got, reinterpret_cast<const Bytef*>(packed.data()),
                    static_cast<uLong>(packed.size())) == Z_OK &&
         got == size;
}

bool unpackLz4(std::string_view packed, char* out, std::size_t size) {
  constexpr std::size_t kMost = LZ4_MAX_INPUT_SIZE;
  return packed.size() <= kMost && size <= kMost &&
         LZ4_decompress_safe(packed.data(), out, static_cast<int>(packed.size()), static_cast<int>(size)) ==
             static_cast<int>(size);
}

bool unpackLzma(std::string_view packed, char* out, std::size_t size) {
  std::uint64_t memory = UINT64_MAX;
  std::size_t read = 0, written = 0;
  return lzma_stream_buffer_decode(&memory, 0, nullptr, reinterpret_cast<const std::uint8_t*>(packed.data()),
                                   &read, packed.size(), reinterpret_cast<std::uint8_t*>(out), &written,
                                   size) == LZMA_OK &&
         written == size;
}

/// The three methods, under the names of the VTK classes that pack.
constexpr std::array<std::pair<std::string_view, Unpack>, 3> kCompressors = {
    {{"vtkZLibDataCompressor", unpackZlib},
     {"vtkLZ4DataCompressor", unpackLz4},
     {"vtkLZMADataCompressor", unpackLzma}}};

class ArrayReader {
public:
  ArrayReader(const VtpStorage& storage, const XmlElement& array) : storage_(storage), array_(array) {
    const std::string_view name = array.attribute("type");
    const auto type = lookUp(kVtpTypes, name);
    if (!type)
      fail(diagnostic("it has the unknown type %1", inQuotes(name)));
    type_ = *type;
  }

  std::vector<double> numbers() const { return values(loadDouble, parseNumber, "number"); }

  std::vector<std::int64_t> integers() const {
    if (!isWhole(type_))
      fail(diagnostic("it should hold whole numbers"));
    return values(loadInteger, parseInteger, "whole number");
  }

private:
  /// `kind` names what each word has to be.
  template <class Number>
  std::vector<Number> values(Number (*load)(const char*, Scalar, std::endian),
                             std::optional<Number> (*parse)(std::string_view), std::string_view kind) const {
    std::vector<Number> list;
    if (array_.attribute("format") == "ascii") {
      std::string_view rest = array_.text;
      for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
        const std::optional<Number> value = parse(word);
        if (!value)
          fail(diagnostic("it contains %1, which is no %2", inQuotes(word), kind));
        list.push_back(*value);
      }
      return list;
    }
    const std::string bytes = content();
    list.reserve(bytes.size() / sizeOf(type_));
    for (std::size_t at = 0; at < bytes.size(); at += sizeOf(type_))
      list.push_back(load(bytes.data() + at, type_, storage_.order));
    return list;
  }

  [[noreturn]] void fail(const Text& problem) const {
    const std::string_view name = array_.attribute("Name");
    storage_.file->fail(diagnostic("the array %1: %2", inQuotes(name), problem));
  }

  [[noreturn]] void failAsTooLong(std::uint64_t bytes) const {
    fail(diagnostic("it should have %1 bytes, more than there are: the file is cut off or damaged", bytes));
  }

  std::string content() const {
    const std::string_view format = array_.attribute("format");
    std::string bytes;
    if (format == "binary")
      bytes = fromBase64(trimmed(array_.text));
    else if (format == "appended")
      bytes = storage_.appendedIsBase64 ? fromBase64(appendedData()) : fromRaw(appendedData());
    else
      fail(diagnostic("it has the unknown format %1", inQuotes(format)));
    if (bytes.size() % sizeOf(type_) != 0)
      fail(diagnostic("it does not hold a whole number of values"));
    return bytes;
  }

  std::string_view appendedData() const {
    const std::optional<std::int64_t> offset = parseInteger(array_.attribute("offset"));
    if (!offset || *offset < 0 || static_cast<std::uint64_t>(*offset) >= storage_.appended.size())
      fail(diagnostic("it begins behind the end of the data: the file is cut off"));
    return storage_.appended.substr(static_cast<std::size_t>(*offset));
  }

  std::uint64_t headerWord(std::string_view header, std::size_t index) const {
    const char* data = header.data() + index * storage_.headerBytes;
    return storage_.headerBytes == 8 ? loadValue<std::uint64_t>(data, storage_.order)
                                     : loadValue<std::uint32_t>(data, storage_.order);
  }

  static std::uint64_t encodedSize(std::uint64_t bytes) { return (bytes + 2) / 3 * 4; }

  /// Decodes exactly `bytes` bytes from the beginning of `text`.
  std::string decode(std::string_view text, std::uint64_t bytes) const {
    if (bytes > kLargestArray || encodedSize(bytes) > text.size())
      failAsTooLong(bytes);
    std::optional<std::string> decoded =
        decodeBase64(text.substr(0, static_cast<std::size_t>(encodedSize(bytes))));
    if (!decoded || decoded->size() < bytes)
      fail(diagnostic("it is not valid base64: the file is damaged"));
    decoded->resize(static_cast<std::size_t>(bytes));
    return std::move(*decoded);
  }

  std::string fromBase64(std::string_view text) const {
    const std::size_t word = storage_.headerBytes;
    if (!storage_.compressor.empty()) {
      const std::uint64_t blocks = headerWord(decode(text, 3 * word), 0);
      requireBlocks(blocks, text.size());
      const std::uint64_t headerSize = (3 + blocks) * word;
      const std::string header = decode(text, headerSize);
      text.remove_prefix(static_cast<std::size_t>(encodedSize(headerSize)));
      return inflate(header, decode(text, compressedSize(header, text.size())));
    }
    const std::uint64_t size = headerWord(decode(text, word), 0);
    // Size and data are one piece of base64 or two; a padded first piece tells.
    const std::size_t headerEnd = static_cast<std::size_t>(encodedSize(word));
    if (text.substr(0, headerEnd).ends_with('='))
      return decode(text.substr(headerEnd), size);
    if (size > text.size())
      failAsTooLong(size);
    return decode(text, word + size).substr(word);
  }

  std::string fromRaw(std::string_view data) const {
    const std::size_t word = storage_.headerBytes;
    const auto take = [&](std::uint64_t bytes) {
      if (bytes > data.size())
        fail(diagnostic("it should have %1 more bytes, but %2 are left: the file is cut off or damaged",
                        bytes, data.size()));
      const std::string_view taken = data.substr(0, static_cast<std::size_t>(bytes));
      data.remove_prefix(taken.size());
      return taken;
    };
    if (storage_.compressor.empty())
      return std::string(take(headerWord(take(word), 0)));
    std::string header(take(3 * word));
    const std::uint64_t blocks = headerWord(header, 0);
    requireBlocks(blocks, data.size());
    header += take(blocks * word);
    return inflate(header, take(compressedSize(header, data.size())));
  }

  void requireBlocks(std::uint64_t blocks, std::size_t available) const {
    if (blocks > available / storage_.headerBytes)
      fail(diagnostic("it claims %1 blocks, more than there are: the file is cut off or damaged", blocks));
  }

  std::uint64_t compressedSize(std::string_view header, std::size_t available) const {
    const std::uint64_t blocks = headerWord(header, 0);
    std::uint64_t total = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const std::uint64_t size = headerWord(header, static_cast<std::size_t>(3 + b));
      if (size > available)
        fail(diagnostic("it claims a block larger than the file: the file is cut off or damaged"));
      total += size;
    }
    return total;
  }

  /// `header`: number of blocks, size of a block, size of the last one (0: it is full), compressed sizes.
  std::string inflate(std::string_view header, std::string_view data) const {
    const std::uint64_t blocks = headerWord(header, 0);
    const std::uint64_t fullSize = headerWord(header, 1);
    const std::uint64_t lastSize = headerWord(header, 2);
    const auto unpack = lookUp(kCompressors, storage_.compressor);
    if (!unpack)
      fail(diagnostic("it is compressed by %1, which Viscera does not know", inQuotes(storage_.compressor)));
    std::string result;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const std::uint64_t packed = headerWord(header, static_cast<std::size_t>(3 + b));
      const std::uint64_t size = b + 1 == blocks && lastSize > 0 ? lastSize : fullSize;
      if (size > saturatedProduct(packed, kMostInflation) || result.size() + size > kLargestArray)
        fail(diagnostic("it claims %1 bytes in %2: the file is damaged", size, packed));
      const std::size_t at = result.size();
      result.resize(at + static_cast<std::size_t>(size));
      if (!(*unpack)(data.substr(0, static_cast<std::size_t>(packed)), result.data() + at,
                     static_cast<std::size_t>(size)))
        fail(diagnostic("it cannot be decompressed: the file is damaged"));
      data.remove_prefix(static_cast<std::size_t>(packed));
    }
    return result;
  }

  const VtpStorage& storage_;
  const XmlElement& array_;
  Scalar type_ = Scalar::int8;
};

} // namespace

std::vector<double> readVtpNumbers(const VtpStorage& storage, const XmlElement& array) {
  return ArrayReader(storage, array).numbers();
}

std::vector<std::int64_t> readVtpIntegers(const VtpStorage& storage, const XmlElement& array) {
  return ArrayReader(storage, array).integers();
}

std::string readVtpText(const VtpStorage& storage, const XmlElement& array) {
  std::string text;
  for (const std::int64_t code : readVtpIntegers(storage, array)) {
    if (code == 0)
      break;
    text += static_cast<char>(code);
  }
  return text;
}

} // namespace viscera::medical_io
