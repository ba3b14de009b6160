#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "byte_cursor.h"
#include "scalar.h"
#include "space_tag.h"
#include "surface_formats.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

// Own reader: VTK's keeps single precision, allocates what the header promises and reads on behind the end of
// a file that was cut off.
namespace viscera::medical_io {
namespace {

struct ValueType {
  std::array<std::string_view, 2> names;
  Scalar scalar;
  double fullColor; ///< The value of a colour channel at its brightest.
};

constexpr std::array<ValueType, 8> kPlyTypes = {{{{"char", "int8"}, Scalar::int8, 127},
                                                 {{"uchar", "uint8"}, Scalar::uint8, 255},
                                                 {{"short", "int16"}, Scalar::int16, 32767},
                                                 {{"ushort", "uint16"}, Scalar::uint16, 65535},
                                                 {{"int", "int32"}, Scalar::int32, 255},
                                                 {{"uint", "uint32"}, Scalar::uint32, 255},
                                                 {{"float", "float32"}, Scalar::float32, 1},
                                                 {{"double", "float64"}, Scalar::float64, 1}}};

struct Property {
  std::string name;
  const ValueType* type = nullptr;
  const ValueType* listCount = nullptr; ///< Null: a single value.
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;

  std::optional<std::size_t> find(std::string_view name1, std::string_view name2 = {}) const {
    for (std::size_t i = 0; i < properties.size(); ++i)
      if (properties[i].name == name1 || (!name2.empty() && properties[i].name == name2))
        return i;
    return std::nullopt;
  }
  /// The fewest bytes of one such element in a binary file.
  std::uint64_t leastBytes() const {
    std::uint64_t bytes = 0;
    for (const Property& p : properties)
      bytes += sizeOf((p.listCount != nullptr ? p.listCount : p.type)->scalar);
    return bytes;
  }
};

/// The values read of an element: one number for each property, and the contents of one of its lists.
struct Row {
  std::vector<double> values;
  std::vector<std::int64_t> list;
};

class PlyReader {
public:
  explicit PlyReader(const FileBytes& file) : file_(file), text_(file, file.view()) {}

  RawSurface run() {
    readHeader();
    ByteCursor bytes(file_, text_.rest(), order_);
    for (const Element& element : elements_) {
      requireRoom(element, bytes);
      // Elements that the header gives no properties are not in the file, however many it claims.
      for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
        readRow(element, i, bytes);
        take(element);
      }
      if (element.name == "face" || element.name == "tristrips")
        haveFaces_ = true;
    }
    if (!haveFaces_)
      file_.fail("It holds points, but no faces", "export it as a surface of triangles");
    text_.finishCommas(raw_.warnings);
    return std::move(raw_);
  }

private:
  void readHeader() {
    if (trimmed(text_.line()) != "ply")
      file_.fail(diagnostic("It does not begin with \"ply\": it is not a PLY file"), "check its ending");
    for (;;) {
      if (text_.remaining() == 0)
        text_.failAtEnd("\"end_header\"");
      std::string_view line = text_.line();
      const std::string_view word = takeWord(line);
      if (word == "end_header")
        break;
      if (word == "format")
        readFormat(line);
      else if (word == "element")
        readElement(line);
      else if (word == "property")
        readProperty(line);
      else if (word == "comment" || word == "obj_info")
        raw_.takeComment(trimmed(line));
      else if (!word.empty())
        text_.fail(diagnostic("%1 is not a word of a PLY header", inQuotes(word)));
    }
    if (!formatKnown_)
      file_.fail(diagnostic("its header does not say its format"));
  }

  void readFormat(std::string_view line) {
    const std::string_view format = takeWord(line);
    binary_ = format != "ascii";
    order_ = format == "binary_big_endian" ? std::endian::big : std::endian::little;
    if (binary_ && format != "binary_big_endian" && format != "binary_little_endian")
      text_.fail(diagnostic("the format %1 is not known", inQuotes(format)));
    formatKnown_ = true;
  }

  void readElement(std::string_view line) {
    Element element;
    element.name = takeWord(line);
    const std::string_view number = takeWord(line);
    const std::optional<std::int64_t> count = parseInteger(number);
    if (!count || *count < 0)
      text_.fail(diagnostic("%1 is not a number of elements", inQuotes(number)));
    element.count = static_cast<std::uint64_t>(*count);
    elements_.push_back(std::move(element));
  }

  const ValueType& typeNamed(std::string_view name) const {
    for (const ValueType& type : kPlyTypes)
      if (type.names[0] == name || type.names[1] == name)
        return type;
    text_.fail(diagnostic("%1 is not a type of a PLY file", inQuotes(name)));
  }

  void readProperty(std::string_view line) {
    if (elements_.empty())
      text_.fail(diagnostic("a property stands before the first element"));
    Property property;
    std::string_view type = takeWord(line);
    if (type == "list") {
      property.listCount = &typeNamed(takeWord(line));
      type = takeWord(line);
    }
    property.type = &typeNamed(type);
    property.name = takeWord(line);
    elements_.back().properties.push_back(std::move(property));
  }

  void requireRoom(const Element& element, const ByteCursor& bytes) const {
    const std::uint64_t left = binary_ ? bytes.remaining() : text_.remaining() + 1;
    const std::uint64_t each = binary_ ? element.leastBytes() : 2 * element.properties.size();
    if (saturatedProduct(element.count, each) > left)
      file_.fail(
          diagnostic("the file is cut off: its header promises %2 of %3, more than the %n {byte|bytes} "
                     "that are left can hold",
                     left, element.count, inQuotes(element.name)));
  }

  double next(const ValueType& type, ByteCursor& bytes) {
    if (binary_)
      return loadDouble(bytes.takeBytes(sizeOf(type.scalar), "a value").data(), type.scalar, order_);
    return isWhole(type.scalar) ? text_.number("a value") : text_.coordinate("a value");
  }

  /// A number as an index. -1 ends a strip; what can be no index becomes -2, which is refused later.
  static std::int64_t asIndex(double value) {
    return value >= -1 && value < 9e15 && value == std::floor(value) ? static_cast<std::int64_t>(value) : -2;
  }

  void readRow(const Element& element, std::uint64_t number, ByteCursor& bytes) {
    const std::optional<std::size_t> wanted = element.find("vertex_indices", "vertex_index");
    row_.values.assign(element.properties.size(), 0.0);
    row_.list.clear();
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const Property& property = element.properties[p];
      if (property.listCount == nullptr) {
        row_.values[p] = next(*property.type, bytes);
        continue;
      }
      const double count = next(*property.listCount, bytes);
      const std::uint64_t left =
          binary_ ? bytes.remaining() / sizeOf(property.type->scalar) : text_.remaining();
      if (!(count >= 0 && count <= static_cast<double>(left)))
        file_.fail(diagnostic(
            "the file is cut off or damaged: a list of %1 %2 should have more values than are left",
            inQuotes(element.name), number));
      for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(count); ++i) {
        const double value = next(*property.type, bytes);
        if (p == wanted)
          row_.list.push_back(asIndex(value));
      }
    }
  }

  void take(const Element& element) {
    if (element.name == "vertex")
      takeVertex(element);
    else if (element.name == "face")
      takeFace(element);
    else if (element.name == "tristrips")
      takeStrips();
  }

  void takeVertex(const Element& element) {
    const auto x = element.find("x");
    const auto y = element.find("y");
    const auto z = element.find("z");
    if (!x || !y || !z)
      file_.fail(diagnostic("its points have no x, y and z"));
    raw_.addPoint(row_.values[*x], row_.values[*y], row_.values[*z]);
    const std::array channels = {element.find("red", "diffuse_red"), element.find("green", "diffuse_green"),
                                 element.find("blue", "diffuse_blue")};
    if (!channels[0] || !channels[1] || !channels[2])
      return;
    for (const auto& channel : channels)
      raw_.addChannel(row_.values[*channel] * 255.0 / element.properties[*channel].type->fullColor);
  }

  void takeFace(const Element& element) {
    if (!element.find("vertex_indices", "vertex_index"))
      file_.fail(diagnostic("its faces have no vertex_indices"));
    raw_.addPolygon(row_.list);
  }

  /// One list with all strips; -1 ends a strip.
  void takeStrips() {
    auto begin = row_.list.begin();
    while (begin != row_.list.end()) {
      const auto end = std::find(begin, row_.list.end(), -1);
      raw_.addStrip(std::span<const std::int64_t>(begin, end));
      begin = end == row_.list.end() ? end : end + 1;
    }
  }

  const FileBytes& file_;
  TextScanner text_;
  RawSurface raw_;
  std::vector<Element> elements_;
  Row row_;
  std::endian order_ = std::endian::little;
  bool binary_ = false;
  bool formatKnown_ = false;
  bool haveFaces_ = false;
};

} // namespace

RawSurface readPly(const FileBytes& file) {
  return PlyReader(file).run();
}

void writePly(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options) {
  const bool colored = mesh.colors.rows() > 0;
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment " + writtenComment(options) +
                      "\nelement vertex " + std::to_string(mesh.points.rows()) +
                      "\nproperty double x\nproperty double y\nproperty double z\n";
  if (colored)
    bytes += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  bytes += "element face " + std::to_string(mesh.triangles.rows()) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
    for (int axis = 0; axis < 3; ++axis)
      appendValue(bytes, mesh.points(v, axis));
    for (int k = 0; k < 3 && colored; ++k)
      appendValue(bytes, mesh.colors(v, k));
  }
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    appendValue(bytes, std::uint8_t{3});
    for (int k = 0; k < 3; ++k)
      appendValue(bytes, mesh.triangles(t, k));
  }
  out << bytes;
}

} // namespace viscera::medical_io
