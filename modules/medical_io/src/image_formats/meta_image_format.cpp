#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <vector>

#include "image_formats/data_file.h"
#include "image_formats/file_list.h"
#include "image_formats/raw_image.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

/// MetaImage (.mha, .mhd) as ITK writes it (itk.org/Wiki/ITK/MetaIO/Documentation); its axes are LPS.
namespace viscera::medical_io {
namespace {

class MetaImageReader {
public:
  explicit MetaImageReader(const FileBytes& file) : file_(file) { readHeader(); }

  ImageHeader run() {
    readSize();
    raw_.space = "LPS";
    raw_.scalar = scalar();
    if (parseInteger(value({"ElementNumberOfChannels"}).value_or("1")) != 1)
      file_.fail("It has several values per voxel", "save it with one value per voxel");
    readGrid();
    StoredValues stored = storedValues();
    return {std::move(raw_), std::move(stored)};
  }

private:
  /// The header's last line is that of ElementDataFile.
  void readHeader() {
    TextScanner scanner(file_, file_.view());
    while (scanner.remaining() > 0) {
      const std::string_view line = scanner.line();
      const std::size_t equals = line.find('=');
      if (trimmed(line).empty())
        continue;
      if (equals == line.npos)
        scanner.fail(diagnostic("this is not a line of a MetaImage header: %1", inQuotes(line)));
      const std::string key(trimmed(line.substr(0, equals)));
      values_[key] = trimmed(line.substr(equals + 1));
      if (key == "ElementDataFile") {
        headerEnd_ = scanner.position();
        if (isListOfFiles(values_[key]))
          files_ = namesOfFiles(scanner);
        return;
      }
    }
    file_.fail(diagnostic("the file is cut off: its header has no ElementDataFile"));
  }

  /// The value of the first of the keys that the header has; they are old and new names of one thing.
  std::optional<std::string_view> value(std::initializer_list<const char*> keys) const {
    for (const char* key : keys)
      if (const auto found = values_.find(key); found != values_.end())
        return found->second;
    return std::nullopt;
  }

  bool flag(std::initializer_list<const char*> keys, bool otherwise) const {
    const auto text = value(keys);
    return text ? lowered(*text) == "true" || *text == "1" : otherwise;
  }

  /// Exactly `count` numbers under one of the keys, or none.
  std::vector<double> numbers(std::initializer_list<const char*> keys, std::size_t count) const {
    std::vector<double> list;
    auto text = value(keys);
    if (!text)
      return list;
    for (std::string_view word = takeWord(*text); !word.empty() && list.size() <= count;
         word = takeWord(*text)) {
      const auto number = parseNumber(word);
      if (!number)
        file_.fail(
            diagnostic("its header is damaged: %1 is not a number of %2", inQuotes(word), *keys.begin()));
      list.push_back(*number);
    }
    if (list.size() != count)
      file_.fail(diagnostic("its header is damaged: %1 has not %2 numbers", *keys.begin(), count));
    return list;
  }

  /// A fourth dimension is time.
  void readSize() {
    const auto dimensions = parseInteger(value({"NDims"}).value_or(""));
    if (dimensions != 3 && dimensions != 4)
      file_.fail("It does not have three dimensions", "save it as a 3D image");
    dimensions_ = static_cast<std::size_t>(*dimensions);
    std::string_view text = value({"DimSize"}).value_or("");
    for (std::size_t i = 0; i < dimensions_; ++i) {
      const auto size = parseInteger(takeWord(text));
      if (!size)
        file_.fail(diagnostic("its header is damaged: DimSize has not %1 numbers",
                              dimensions_ == 4 ? "four" : "three"));
      if (i < 3)
        raw_.size[i] = axisSize(file_, *size, std::string_view("ijk").substr(i, 1));
      else
        raw_.layers = axisSize(file_, *size, "the volumes");
    }
    raw_.overTime = raw_.layers > 1;
  }

  Scalar scalar() const {
    // The long ones have 32 bits, as ITK writes them on all systems: see `metaImageHeader`.
    static constexpr std::array<std::pair<std::string_view, Scalar>, 12> kTypes = {
        {{"MET_CHAR", Scalar::int8},
         {"MET_UCHAR", Scalar::uint8},
         {"MET_SHORT", Scalar::int16},
         {"MET_USHORT", Scalar::uint16},
         {"MET_INT", Scalar::int32},
         {"MET_UINT", Scalar::uint32},
         {"MET_LONG", Scalar::int32},
         {"MET_ULONG", Scalar::uint32},
         {"MET_LONG_LONG", Scalar::int64},
         {"MET_ULONG_LONG", Scalar::uint64},
         {"MET_FLOAT", Scalar::float32},
         {"MET_DOUBLE", Scalar::float64}}};
    const std::string_view type = value({"ElementType"}).value_or("");
    if (const auto found = lookUp(kTypes, type))
      return *found;
    file_.fail(phrase("its voxels are no plain numbers (%1)", inQuotes(type)),
               "save it with one value per voxel");
  }

  /// The first three numbers of the matrix are the direction of i.
  void readGrid() {
    const std::size_t n = dimensions_;
    const std::vector<double> spacing = numbers({"ElementSpacing", "ElementSize"}, n);
    const std::vector<double> origin = numbers({"Offset", "Origin", "Position"}, n);
    const std::vector<double> matrix = numbers({"TransformMatrix", "Rotation", "Orientation"}, n * n);
    if (spacing.empty())
      raw_.warnings.push_back("it does not say how large its voxels are; 1 mm is assumed");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int column = static_cast<int>(axis);
      for (std::size_t row = 0; row < 3 && !matrix.empty(); ++row)
        raw_.indexToLps.linear()(static_cast<int>(row), column) = matrix[n * axis + row];
      if (!spacing.empty())
        raw_.indexToLps.linear().col(column) *= spacing[axis];
      if (!origin.empty())
        raw_.indexToLps.translation()[column] = origin[axis];
    }
    if (raw_.overTime)
      raw_.times = RawTimes{{}, spacing.empty() ? 0 : spacing[3], {}};
  }

  StoredValues storedValues() {
    StoredValues stored;
    stored.headerEnd = headerEnd_;
    const std::string data(value({"ElementDataFile"}).value_or(""));
    stored.parts = isListOfFiles(data) ? files_ : filesOfPattern(file_, data);
    if (isListOfFiles(data) && stored.parts.empty())
      file_.fail(diagnostic("its header is damaged: its list of files is empty"));
    if (stored.parts.empty() && lowered(data) != "local")
      stored.beside = data;
    stored.packing = flag({"CompressedData"}, false) ? Packing::zlib : Packing::none;
    stored.text = !flag({"BinaryData"}, true);
    raw_.order = flag({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}, false) ? std::endian::big
                                                                                : std::endian::little;
    const std::string_view type = value({"ElementType"}).value_or("");
    if (type == "MET_LONG" || type == "MET_ULONG")
      stored.maybeWider = type == "MET_LONG" ? Scalar::int64 : Scalar::uint64;
    const auto headerSize = parseInteger(value({"HeaderSize"}).value_or("0"));
    if (!headerSize || *headerSize < -1)
      file_.fail(diagnostic("its header is damaged: HeaderSize is not a number of bytes"));
    stored.atEnd = *headerSize == -1;
    stored.skippedBytes = static_cast<std::uint64_t>(std::max<std::int64_t>(*headerSize, 0));
    return stored;
  }

  const FileBytes& file_;
  std::map<std::string, std::string> values_;
  std::vector<std::string> files_; ///< Behind "ElementDataFile = LIST".
  std::size_t dimensions_ = 3;
  std::size_t headerEnd_ = 0;
  RawImage raw_;
};

} // namespace

/// Old programs wrote 64 bits for a long where the system had them, under the same name: the size of the data
/// tells.
ImageHeader metaImageHeader(FileBytes& file) {
  ImageHeader header =
      headerBehindGzip(file, [](const FileBytes& plain) { return MetaImageReader(plain).run(); });
  if (header.stored.maybeWider && holdsValuesOf(file, header.stored, header.image, *header.stored.maybeWider))
    header.image.scalar = *header.stored.maybeWider;
  return header;
}

} // namespace viscera::medical_io
