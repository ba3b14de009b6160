#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh_formats/cell_mesh.h"
#include "mesh_formats/vtk_cells.h"
#include "scalar.h"
#include "space_tag.h"
#include "surface_formats.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

// Own reader: VTK's walks through the cells of a damaged file without looking where they end, which is a
// crash, and allocates what the header promises.
namespace viscera::medical_io {
namespace {

/// The type of an array; none for texts and for what is only skipped.
using Type = std::optional<Scalar>;

constexpr std::array<std::pair<std::string_view, Type>, 17> kVtkTypes = {{{"unsigned_char", Scalar::uint8},
                                                                          {"char", Scalar::int8},
                                                                          {"signed_char", Scalar::int8},
                                                                          {"unsigned_short", Scalar::uint16},
                                                                          {"short", Scalar::int16},
                                                                          {"unsigned_int", Scalar::uint32},
                                                                          {"int", Scalar::int32},
                                                                          {"unsigned_long", Scalar::uint64},
                                                                          {"long", Scalar::int64},
                                                                          {"vtktypeint64", Scalar::int64},
                                                                          {"vtktypeuint64", Scalar::uint64},
                                                                          {"vtkidtype", Scalar::int32},
                                                                          {"float", Scalar::float32},
                                                                          {"double", Scalar::float64},
                                                                          {"string", std::nullopt},
                                                                          {"utf8_string", std::nullopt},
                                                                          {"bit", std::nullopt}}};

/// Whether a word stands for a number: also "-1.#IND" and "1.#QNAN", which Windows wrote.
bool isNumberOfAnyForm(std::string_view word) {
  std::string form = lowered(word);
  std::replace(form.begin(), form.end(), ',', '.');
  if (parseNumber(form))
    return true;
  if (form.starts_with('-') || form.starts_with('+'))
    form.erase(0, 1);
  const std::size_t mark = form.find(".#");
  return form.starts_with("nan") ||
         (mark != form.npos && mark > 0 && form.find_first_not_of("0123456789") == mark);
}

/// Attributes of which every element has a fixed number of values, behind "KEYWORD name type".
constexpr std::array<std::pair<std::string_view, std::uint64_t>, 9> kFixedAttributes = {
    {{"vectors", 3},
     {"normals", 3},
     {"tensors", 9},
     {"tensors6", 6},
     {"global_ids", 1},
     {"pedigree_ids", 1},
     {"edge_flags", 1},
     {"rationalweights", 1},
     {"higherorderdegrees", 3}}};

class LegacyVtkReader {
public:
  explicit LegacyVtkReader(const FileBytes& file) : file_(file), scanner_(file, file.view()) {}

  void run() {
    readHeader();
    while (!scanner_.atEnd() && readSection()) {
    }
    scanner_.finishCommas(raw_.warnings);
  }

  bool isGrid() const { return isGrid_; }
  RawSurface takeSurface() { return std::move(raw_); }

  CellMesh takeCells() {
    if (cellTypes_.size() != cellEnds_.size())
      file_.fail(diagnostic("it has %1 cells, but %2 types of cells", cellEnds_.size(), cellTypes_.size()));
    const bool numbered = regions_.size() == cellEnds_.size();
    CellMesh mesh;
    mesh.surface = std::move(raw_);
    std::size_t begin = 0;
    for (std::size_t cell = 0; cell < cellEnds_.size(); ++cell) {
      addVtkCell(mesh, cellTypes_[cell], std::span(cellPoints_).subspan(begin, cellEnds_[cell] - begin),
                 numbered ? regions_[cell] : 0, file_);
      begin = cellEnds_[cell];
    }
    return mesh;
  }

private:
  void readHeader() {
    std::string_view first = scanner_.line();
    if (!first.starts_with("# vtk DataFile"))
      file_.fail(diagnostic("It does not begin with \"# vtk DataFile\": it is not a legacy VTK file"),
                 "check its ending");
    const std::size_t version = first.find_first_of("0123456789");
    offsetsApart_ = version != first.npos && parseNumber(trimmed(first.substr(version))).value_or(0) >= 5.0;
    const std::string_view title = scanner_.line();
    raw_.takeComment(title);
    std::string mode = lowered(trimmed(scanner_.line()));
    while (mode.empty() && scanner_.remaining() > 0)
      mode = lowered(trimmed(scanner_.line()));
    if (mode != "ascii" && mode != "binary")
      scanner_.fail(diagnostic("expected %2, found %1", inQuotes(mode), "ASCII or BINARY"));
    binary_ = mode == "binary";
  }

  /// False when the rest of the file is not understood and not needed.
  bool readSection() {
    const std::string_view word = scanner_.word();
    const std::string keyword = lowered(word);
    if (keyword == "dataset")
      readDatasetType();
    else if (keyword == "points")
      readPoints();
    else if (keyword == "polygons" || keyword == "triangle_strips" || keyword == "lines" ||
             keyword == "vertices" || (isGrid_ && keyword == "cells"))
      readCells(keyword);
    else if (isGrid_ && keyword == "cell_types")
      cellTypes_ = readIntegers(scanner_.count("the number of cells", 1), Scalar::int32);
    else if (keyword == "metadata")
      skipMetadata();
    else if (keyword == "field")
      readField();
    else if (keyword == "point_data" || keyword == "cell_data")
      beginAttributes(keyword == "point_data");
    else if (attributes_ && readAttribute(keyword))
      return true;
    else if (attributes_)
      return stopAt(word);
    else
      scanner_.fail(diagnostic("%1 is not a section of a legacy VTK surface", inQuotes(word)));
    return true;
  }

  bool stopAt(std::string_view word) {
    raw_.warnings.push_back(
        phrase("values from the section %1 on were not understood and ignored", inQuotes(word)));
    return false;
  }

  void readDatasetType() {
    const std::string_view type = scanner_.word();
    isGrid_ = lowered(type) == "unstructured_grid";
    if (lowered(type) != "polydata" && !isGrid_)
      file_.fail(phrase("It holds %1, not %2", inQuotes(type), inQuotes("POLYDATA")),
                 "extract its surface first");
  }

  Type readType() {
    const std::string_view word = scanner_.word();
    const auto type = lookUp(kVtkTypes, lowered(word));
    bits_ = lowered(word) == "bit";
    if (!type)
      scanner_.fail(diagnostic("%1 is not a type of numbers", inQuotes(word)));
    return *type;
  }

  void requireRoom(std::uint64_t bytes, std::uint64_t numbers) const {
    if (bytes > scanner_.remaining())
      scanner_.fail(
          diagnostic("the file is cut off: %2 numbers should follow, but only %n {byte is|bytes are} left",
                     scanner_.remaining(), numbers));
  }
  void requireRoom(std::uint64_t count) const { requireRoom(count, count); }

  /// Binary data begin in the line behind the words that announce them.
  std::string_view binaryData(std::uint64_t count, Scalar type) {
    scanner_.line();
    const std::uint64_t bytes = saturatedProduct(count, sizeOf(type));
    requireRoom(bytes, count);
    const std::string_view data = scanner_.rest().substr(0, static_cast<std::size_t>(bytes));
    scanner_.moveTo(scanner_.position() + data.size());
    return data;
  }

  template <class Number>
  std::vector<Number> readValues(std::uint64_t count, Scalar type,
                                 Number (*load)(const char*, Scalar, std::endian),
                                 Number (TextScanner::*next)(std::string_view), std::string_view part) {
    std::vector<Number> values;
    if (binary_) {
      const std::string_view data = binaryData(count, type);
      values.reserve(static_cast<std::size_t>(count));
      for (std::size_t at = 0; at < data.size(); at += sizeOf(type))
        values.push_back(load(data.data() + at, type, std::endian::big));
      return values;
    }
    requireRoom(count);
    values.reserve(static_cast<std::size_t>(count));
    for (std::uint64_t i = 0; i < count; ++i)
      values.push_back((scanner_.*next)(part));
    return values;
  }

  std::vector<double> readNumbers(std::uint64_t count, const Type& type) {
    if (!type)
      scanner_.fail(diagnostic("it has text in place of numbers"));
    return readValues(count, *type, loadDouble, &TextScanner::coordinate, "a number");
  }

  /// Channels of colours; what is no number is 0.
  std::vector<double> readChannels(std::uint64_t count, Scalar type) {
    if (binary_)
      return readNumbers(count, type);
    requireRoom(count);
    std::vector<double> values;
    for (std::uint64_t i = 0; i < count; ++i) {
      std::string form(nextOfAnyForm());
      std::replace(form.begin(), form.end(), ',', '.');
      values.push_back(parseNumber(form).value_or(0.0));
    }
    return values;
  }

  /// The next word of an array that is not the shape.
  std::string_view nextOfAnyForm() {
    const std::string_view word = scanner_.word();
    if (word.empty())
      scanner_.failAtEnd("a number");
    if (!isNumberOfAnyForm(word))
      scanner_.fail(diagnostic("expected %2, found %1", inQuotes(word), "a number"));
    return word;
  }

  std::vector<std::int64_t> readIntegers(std::uint64_t count, const Type& type) {
    if (!type || !isWhole(*type))
      scanner_.fail(diagnostic("point numbers are of a type that is not whole"));
    return readValues(count, *type, loadInteger, &TextScanner::integer, "a point's number");
  }

  void readPoints() {
    if (!raw_.coordinates.empty())
      scanner_.fail(diagnostic("there is a second list of points"));
    const std::uint64_t count = scanner_.count("the number of points", 3);
    raw_.coordinates = readNumbers(saturatedProduct(count, 3), readType());
  }

  void readCells(const std::string& keyword) {
    const std::uint64_t count = scanner_.count("the number of cells", 0);
    const std::uint64_t size = scanner_.count("the size of the cells", 1);
    if (offsetsApart_)
      readCellsByOffsets(keyword, count, size);
    else
      readCellsBySizes(keyword, count, readIntegers(size, Scalar::int32));
  }

  void readCellsBySizes(const std::string& keyword, std::uint64_t count,
                        const std::vector<std::int64_t>& list) {
    std::uint64_t cells = 0;
    for (std::size_t at = 0; at < list.size(); ++cells) {
      const std::int64_t size = list[at++];
      if (size < 0 || static_cast<std::uint64_t>(size) > list.size() - at)
        scanner_.fail(
            diagnostic("cell %1 claims %2 points, but %3 numbers are left", cells, size, list.size() - at));
      addCell(keyword, std::span(list).subspan(at, static_cast<std::size_t>(size)));
      at += static_cast<std::size_t>(size);
    }
    if (cells != count)
      scanner_.fail(diagnostic("%1 cells were announced, but there are %2", count, cells));
  }

  void readCellsByOffsets(const std::string& keyword, std::uint64_t count, std::uint64_t size) {
    if (count == 0)
      return;
    requireWord("offsets");
    const std::vector<std::int64_t> offsets = readIntegers(count, readType());
    requireWord("connectivity");
    const std::vector<std::int64_t> list = readIntegers(size, readType());
    if (offsets.front() != 0 || offsets.back() != static_cast<std::int64_t>(list.size()) ||
        !std::is_sorted(offsets.begin(), offsets.end()))
      scanner_.fail(diagnostic("the cells' offsets do not fit their points"));
    for (std::size_t cell = 0; cell + 1 < offsets.size(); ++cell)
      addCell(keyword, std::span(list).subspan(static_cast<std::size_t>(offsets[cell]),
                                               static_cast<std::size_t>(offsets[cell + 1] - offsets[cell])));
  }

  void requireWord(std::string_view expected) {
    const std::string_view word = scanner_.word();
    if (lowered(word) != expected)
      scanner_.fail(diagnostic("expected %2, found %1", inQuotes(word), inQuotes(expected)));
  }

  void addCell(const std::string& keyword, std::span<const std::int64_t> cell) {
    if (keyword == "polygons") {
      raw_.addPolygon(cell);
    } else if (keyword == "triangle_strips") {
      raw_.addStrip(cell);
    } else if (keyword == "cells") {
      cellPoints_.insert(cellPoints_.end(), cell.begin(), cell.end());
      cellEnds_.push_back(cellPoints_.size());
    } else {
      ++raw_.ignoredCells;
    }
  }

  /// Runs to the next empty line.
  void skipMetadata() {
    scanner_.line();
    while (scanner_.remaining() > 0 && !trimmed(scanner_.line()).empty()) {
    }
  }

  void beginAttributes(bool ofPoints) {
    attributes_ = true;
    ofPoints_ = ofPoints;
    elements_ = scanner_.count("the number of values", 0);
    if (ofPoints && elements_ != raw_.pointCount())
      scanner_.fail(diagnostic("there are values for %n {point|points}, but the surface has %2", elements_,
                               raw_.pointCount()));
  }

  /// False for a keyword that is none.
  bool readAttribute(const std::string& keyword) {
    if (const auto fixed = lookUp(kFixedAttributes, keyword)) {
      scanner_.word();
      const Type type = readType();
      skipValues(saturatedProduct(elements_, *fixed), type);
    } else if (keyword == "scalars") {
      readScalars();
    } else if (keyword == "color_scalars") {
      scanner_.word();
      const std::uint64_t components = scanner_.count("the number of colour channels", 0);
      // Colours in text go from 0 to 1.
      readColors(elements_, components, binary_ ? Scalar::uint8 : Scalar::float32, binary_ ? 1.0 : 255.0);
    } else if (keyword == "lookup_table") {
      scanner_.word();
      skipValues(saturatedProduct(scanner_.count("the size of a colour table", 0), 4), Scalar::uint8);
    } else if (keyword == "texture_coordinates") {
      scanner_.word();
      const std::uint64_t components = scanner_.count("the number of texture axes", 0);
      const Type type = readType();
      skipValues(saturatedProduct(elements_, components), type);
    } else {
      return false;
    }
    return true;
  }

  void readScalars() {
    const std::string_view name = scanner_.word();
    const Type type = readType();
    const std::size_t behindType = scanner_.position();
    const std::optional<std::int64_t> components = parseInteger(scanner_.word());
    if (!components)
      scanner_.moveTo(behindType);
    const std::size_t behindComponents = scanner_.position();
    if (lowered(scanner_.word()) == "lookup_table")
      scanner_.word();
    else
      scanner_.moveTo(behindComponents);
    if (components.value_or(1) < 1)
      scanner_.fail(diagnostic("the number of components is not positive"));
    readArray(name, elements_, static_cast<std::uint64_t>(components.value_or(1)), type);
  }

  /// Keeps what can be colours of points or numbers of regions.
  void readArray(std::string_view name, std::uint64_t tuples, std::uint64_t components, const Type& type) {
    const bool numbers = isGrid_ && !ofPoints_ && components == 1 && type && numbersRegions(name);
    if (numbers && regions_.empty())
      regions_ = wholeNumbers(readNumbers(tuples, type));
    else
      readColors(tuples, components, type, 1.0);
  }

  /// Keeps values that can be colours of points: three or four bytes each.
  void readColors(std::uint64_t tuples, std::uint64_t components, const Type& type, double scale) {
    const std::uint64_t count = saturatedProduct(tuples, components);
    const bool bytes = type == Scalar::uint8 || scale != 1.0;
    if (!ofPoints_ || !bytes || components < 3 || components > 4 || !raw_.colors.empty() ||
        tuples != raw_.pointCount()) {
      skipValues(count, type);
      return;
    }
    const std::vector<double> values = readChannels(count, *type);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (i % components < 3)
        raw_.addChannel(values[i] * scale);
  }

  void readField() {
    scanner_.word();
    const std::uint64_t arrays = scanner_.count("the number of arrays", 1);
    for (std::uint64_t i = 0; i < arrays; ++i) {
      std::string_view name = scanner_.word();
      while (lowered(name) == "metadata") {
        skipMetadata();
        name = scanner_.word();
      }
      if (name.empty())
        scanner_.failAtEnd("an array's name");
      if (name == "NULL_ARRAY")
        continue;
      const std::uint64_t components = scanner_.count("the number of components", 0);
      const std::uint64_t tuples = scanner_.count("the number of values", 0);
      const Type type = readType();
      if (!type && !bits_)
        readTexts(name, saturatedProduct(components, tuples));
      else if (attributes_)
        readArray(name, tuples, components, type);
      else
        skipValues(saturatedProduct(components, tuples), type);
    }
  }

  void skipValues(std::uint64_t count, const Type& type) {
    if (!type && !bits_)
      return readTexts({}, count);
    if (binary_) {
      binaryData(type ? count : count / 8 + (count % 8 > 0 ? 1 : 0), type.value_or(Scalar::uint8));
      return;
    }
    requireRoom(count);
    for (std::uint64_t i = 0; i < count; ++i)
      nextOfAnyForm();
  }

  void readTexts(std::string_view array, std::uint64_t count) {
    scanner_.line();
    requireRoom(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::string_view text = binary_ ? binaryText() : scanner_.line();
      if (array == "SPACE" && !raw_.space)
        raw_.space = findSpace("SPACE=" + std::string(text), raw_.warnings);
    }
  }

  /// The two highest bits of a text's length say how many bytes the length has.
  std::string_view binaryText() {
    requireRoom(1);
    const auto first = static_cast<unsigned char>(scanner_.rest().front());
    const std::size_t lengthBytes = std::size_t{8} >> (first >> 6U);
    requireRoom(lengthBytes);
    std::uint64_t length = first & 0x3FU;
    for (std::size_t i = 1; i < lengthBytes; ++i)
      length = length << 8U | static_cast<unsigned char>(scanner_.rest()[i]);
    scanner_.moveTo(scanner_.position() + lengthBytes);
    requireRoom(length);
    const std::string_view text = scanner_.rest().substr(0, static_cast<std::size_t>(length));
    scanner_.moveTo(scanner_.position() + text.size());
    return text;
  }

  const FileBytes& file_;
  TextScanner scanner_;
  RawSurface raw_;
  bool binary_ = false;
  bool offsetsApart_ = false; ///< Since version 5 cells have an array of offsets instead of their sizes.
  bool attributes_ = false;
  bool ofPoints_ = false;
  bool bits_ = false; ///< The type last read is one of single bits, eight in a byte.
  std::uint64_t elements_ = 0;
  // The cells of an unstructured grid.
  bool isGrid_ = false;
  std::vector<std::int64_t> cellPoints_;
  std::vector<std::size_t> cellEnds_;
  std::vector<std::int64_t> cellTypes_;
  std::vector<std::int64_t> regions_;
};

template <class Value>
void appendBigEndian(std::string& bytes, Value value) {
  appendValue(bytes, value);
  std::reverse(bytes.end() - sizeof(Value), bytes.end());
}

} // namespace

RawSurface readLegacyVtk(const FileBytes& file) {
  LegacyVtkReader reader(file);
  reader.run();
  return reader.isGrid() ? boundaryOf(reader.takeCells(), file) : reader.takeSurface();
}

CellMesh readLegacyVtkCells(const FileBytes& file) {
  LegacyVtkReader reader(file);
  reader.run();
  return reader.isGrid() ? reader.takeCells() : CellMesh();
}

std::vector<RawOrgan> readLegacyVtkOrgans(const FileBytes& file) {
  LegacyVtkReader reader(file);
  reader.run();
  if (reader.isGrid())
    return boundaryOrgansOf(reader.takeCells(), file);
  std::vector<RawOrgan> one(1);
  one.front().surface = reader.takeSurface();
  return one;
}

/// Version 4.2: what follows cannot be read by programs of before 2020.
void writeLegacyVtk(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options) {
  const std::string points = std::to_string(mesh.points.rows());
  std::string bytes = "# vtk DataFile Version 4.2\n" + writtenComment(options) +
                      "\nBINARY\nDATASET POLYDATA\nPOINTS " + points + " double\n";
  for (const double coordinate : mesh.points.reshaped<Eigen::RowMajor>())
    appendBigEndian(bytes, coordinate);
  bytes += "\nPOLYGONS " + std::to_string(mesh.triangles.rows()) + ' ' +
           std::to_string(4 * mesh.triangles.rows()) + '\n';
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    appendBigEndian(bytes, std::int32_t{3});
    for (int k = 0; k < 3; ++k)
      appendBigEndian(bytes, mesh.triangles(t, k));
  }
  bytes += '\n';
  if (mesh.colors.rows() > 0) {
    bytes += "POINT_DATA " + points + "\nCOLOR_SCALARS Colors 3\n";
    bytes.append(reinterpret_cast<const char*>(mesh.colors.data()),
                 static_cast<std::size_t>(mesh.colors.size()));
    bytes += '\n';
  }
  out << bytes;
}

} // namespace viscera::medical_io
