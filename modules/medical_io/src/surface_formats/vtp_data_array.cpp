#include "surface_formats/vtp_data_array.h"

#include <algorithm>
#include <array>
#include <optional>

#include <vtkDataCompressor.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkSmartPointer.h>
#include <vtkZLibDataCompressor.h>

#include "base64.h"
#include "quiet_vtk.h"
#include "text_scanner.h"

namespace viscera::medical_io {
namespace {

/// zlib, the best of the three on constant data, shrinks to a 1032nd at most; more is a lie of the header.
constexpr std::uint64_t kMostInflation = 1100;
constexpr std::uint64_t kLargestArray = std::uint64_t{1} << 32U;

struct ValueType {
  std::string_view name;
  std::size_t bytes;
  bool isWhole;
  double (*load)(const char*, std::endian);
  std::int64_t (*loadInteger)(const char*, std::endian);
};

template <typename T>
constexpr ValueType valueType(std::string_view name, bool isWhole = true) {
  return {name, sizeof(T), isWhole,
          [](const char* data, std::endian order) { return static_cast<double>(loadValue<T>(data, order)); },
          [](const char* data, std::endian order) {
            if constexpr (std::is_integral_v<T>)
              return static_cast<std::int64_t>(loadValue<T>(data, order));
            else
              return std::int64_t{0};
          }};
}

constexpr std::array<ValueType, 11> kTypes = {
    {valueType<std::int8_t>("Int8"), valueType<std::uint8_t>("UInt8"), valueType<std::int16_t>("Int16"),
     valueType<std::uint16_t>("UInt16"), valueType<std::int32_t>("Int32"), valueType<std::uint32_t>("UInt32"),
     valueType<std::int64_t>("Int64"), valueType<std::uint64_t>("UInt64"), valueType<std::int8_t>("String"),
     valueType<float>("Float32", false), valueType<double>("Float64", false)}};

class ArrayReader {
public:
  ArrayReader(const VtpStorage& storage, const XmlElement& array) : storage_(storage), array_(array) {
    const std::string_view name = array.attribute("type");
    const auto found =
        std::find_if(kTypes.begin(), kTypes.end(), [&](const ValueType& t) { return t.name == name; });
    if (found == kTypes.end())
      fail("It has the unknown type " + inQuotes(name));
    type_ = &*found;
  }

  std::vector<double> numbers() const {
    std::vector<double> values;
    if (isText()) {
      forEachWord([&](std::string_view word) {
        const std::optional<double> value = parseNumber(word);
        if (!value)
          fail("contains " + inQuotes(word) + ", which is no number");
        values.push_back(*value);
      });
      return values;
    }
    const std::string bytes = content();
    values.reserve(bytes.size() / type_->bytes);
    for (std::size_t at = 0; at < bytes.size(); at += type_->bytes)
      values.push_back(type_->load(bytes.data() + at, storage_.order));
    return values;
  }

  std::vector<std::int64_t> integers() const {
    if (!type_->isWhole)
      fail("should hold whole numbers");
    std::vector<std::int64_t> values;
    if (isText()) {
      forEachWord([&](std::string_view word) {
        const std::optional<std::int64_t> value = parseInteger(word);
        if (!value)
          fail("contains " + inQuotes(word) + ", which is no whole number");
        values.push_back(*value);
      });
      return values;
    }
    const std::string bytes = content();
    values.reserve(bytes.size() / type_->bytes);
    for (std::size_t at = 0; at < bytes.size(); at += type_->bytes)
      values.push_back(type_->loadInteger(bytes.data() + at, storage_.order));
    return values;
  }

private:
  [[noreturn]] void fail(const std::string& problem) const {
    const std::string_view name = array_.attribute("Name");
    storage_.file->fail("the array " + inQuotes(name) + " " + problem);
  }

  bool isText() const { return array_.attribute("format") == "ascii"; }

  template <typename Take>
  void forEachWord(const Take& take) const {
    std::string_view rest = array_.text;
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
      take(word);
  }

  std::string content() const {
    const std::string_view format = array_.attribute("format");
    std::string bytes;
    if (format == "binary")
      bytes = fromBase64(trimmed(array_.text));
    else if (format == "appended")
      bytes = storage_.appendedIsBase64 ? fromBase64(appendedData()) : fromRaw(appendedData());
    else
      fail("It has the unknown format " + inQuotes(format));
    if (bytes.size() % type_->bytes != 0)
      fail("does not hold a whole number of values");
    return bytes;
  }

  std::string_view appendedData() const {
    const std::optional<std::int64_t> offset = parseInteger(array_.attribute("offset"));
    if (!offset || *offset < 0 || static_cast<std::uint64_t>(*offset) >= storage_.appended.size())
      fail("begins behind the end of the data: the file is cut off");
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
      fail("should have " + std::to_string(bytes) +
           " bytes, more than there are: the file is cut off or damaged");
    std::optional<std::string> decoded =
        decodeBase64(text.substr(0, static_cast<std::size_t>(encodedSize(bytes))));
    if (!decoded || decoded->size() < bytes)
      fail("It is damaged: it is no valid base64");
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
      fail("should have " + std::to_string(size) +
           " bytes, more than there are: the file is cut off or damaged");
    return decode(text, word + size).substr(word);
  }

  std::string fromRaw(std::string_view data) const {
    const std::size_t word = storage_.headerBytes;
    const auto take = [&](std::uint64_t bytes) {
      if (bytes > data.size())
        fail("should have " + std::to_string(bytes) + " more bytes, but " + std::to_string(data.size()) +
             " are left: the file is cut off or damaged");
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
      fail("claims " + std::to_string(blocks) +
           " blocks, more than there are: the file is cut off or damaged");
  }

  std::uint64_t compressedSize(std::string_view header, std::size_t available) const {
    const std::uint64_t blocks = headerWord(header, 0);
    std::uint64_t total = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const std::uint64_t size = headerWord(header, static_cast<std::size_t>(3 + b));
      if (size > available)
        fail("claims a block larger than the file: the file is cut off or damaged");
      total += size;
    }
    return total;
  }

  vtkSmartPointer<vtkDataCompressor> newCompressor() const {
    if (storage_.compressor == "vtkZLibDataCompressor")
      return vtkSmartPointer<vtkZLibDataCompressor>::New();
    if (storage_.compressor == "vtkLZ4DataCompressor")
      return vtkSmartPointer<vtkLZ4DataCompressor>::New();
    if (storage_.compressor == "vtkLZMADataCompressor")
      return vtkSmartPointer<vtkLZMADataCompressor>::New();
    fail("It is compressed by " + inQuotes(storage_.compressor) + ", which Viscera does not know");
  }

  /// `header`: number of blocks, size of a block, size of the last one (0: it is full), compressed sizes.
  std::string inflate(std::string_view header, std::string_view data) const {
    const std::uint64_t blocks = headerWord(header, 0);
    const std::uint64_t fullSize = headerWord(header, 1);
    const std::uint64_t lastSize = headerWord(header, 2);
    const vtkSmartPointer<vtkDataCompressor> compressor = newCompressor();
    const QuietVtk quiet(compressor);
    std::string result;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const std::uint64_t packed = headerWord(header, static_cast<std::size_t>(3 + b));
      const std::uint64_t size = b + 1 == blocks && lastSize > 0 ? lastSize : fullSize;
      if (size > saturatedProduct(packed, kMostInflation) || result.size() + size > kLargestArray)
        fail("claims " + std::to_string(size) + " bytes in " + std::to_string(packed) +
             ": the file is damaged");
      const std::size_t at = result.size();
      result.resize(at + static_cast<std::size_t>(size));
      const std::size_t got = compressor->Uncompress(
          reinterpret_cast<const unsigned char*>(data.data()), static_cast<std::size_t>(packed),
          reinterpret_cast<unsigned char*>(result.data() + at), static_cast<std::size_t>(size));
      if (got != size || quiet.failed())
        fail("It cannot be decompressed: the file is damaged");
      data.remove_prefix(static_cast<std::size_t>(packed));
    }
    return result;
  }

  const VtpStorage& storage_;
  const XmlElement& array_;
  const ValueType* type_ = nullptr;
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
