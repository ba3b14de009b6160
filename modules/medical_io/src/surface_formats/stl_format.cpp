#include <array>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>

#include "space_tag.h"
#include "surface_formats.h"
#include "surface_parts.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/triangle_mesh.h"

// Own reader: VTK's takes the triangle count of a damaged header at its word, returns the part that is left
// of a file that was cut off, and does not give the header of a binary file, in which 3D Slicer writes the
// axes.
namespace viscera::medical_io {
namespace {

constexpr std::size_t kStlHeaderBytes = 80;
constexpr std::size_t kPrefixBytes = kStlHeaderBytes + 4;
constexpr std::size_t kFacetBytes = 50;

bool isAscii(const FileBytes& file) {
  TextScanner scanner(file, file.view());
  if (lowered(scanner.word()) != "solid")
    return false;
  scanner.line();
  const std::string next = lowered(scanner.word());
  return next == "facet" || next == "endsolid" || next.empty();
}

std::optional<std::uint64_t> binaryCount(const FileBytes& file) {
  if (file.bytes.size() < kPrefixBytes)
    return std::nullopt;
  return loadValue<std::uint32_t>(file.bytes.data() + kStlHeaderBytes, std::endian::little);
}

bool hasBinarySize(const FileBytes& file) {
  const std::optional<std::uint64_t> count = binaryCount(file);
  return count && *count > 0 && kPrefixBytes + *count * kFacetBytes == file.bytes.size();
}

std::uint64_t requireBinaryCount(const FileBytes& file, RawSurface& raw) {
  const std::optional<std::uint64_t> count = binaryCount(file);
  if (!count)
    file.fail(diagnostic("It is too short for an STL file: %n {byte|bytes}", file.bytes.size()));
  const std::uint64_t expected = kPrefixBytes + *count * kFacetBytes;
  const std::uint64_t size = file.bytes.size();
  if (expected > size)
    file.fail(
        diagnostic("the file is cut off, or is not an STL file: its header promises %n {triangle|triangles} "
                   "(%2 bytes), but it has %3 bytes",
                   *count, expected, size));
  if (size - expected >= kFacetBytes)
    file.fail(diagnostic(
        "its header promises %n {triangle|triangles}, but there is room for %2: the file is damaged", *count,
        (size - kPrefixBytes) / kFacetBytes));
  if (size > expected)
    raw.warnings.push_back(phrase("%n {byte|bytes} after the last triangle ignored", size - expected));
  return *count;
}

RawSurface readBinary(const FileBytes& file) {
  RawSurface raw;
  raw.pointsAreShared = false;
  const std::uint64_t count = requireBinaryCount(file, raw);
  const std::string_view header = std::string_view(file.bytes).substr(0, kStlHeaderBytes);
  const std::string_view text = header.substr(0, header.find('\0'));
  raw.takeComment(text);
  raw.coordinates.reserve(count * 9);
  raw.corners.reserve(count * 3);
  raw.ends.reserve(count);
  const char* facet = file.bytes.data() + kPrefixBytes;
  for (std::uint64_t t = 0; t < count; ++t, facet += kFacetBytes) {
    // The normal comes first; it follows from the corners.
    for (std::size_t k = 3; k < 12; ++k)
      raw.coordinates.push_back(static_cast<double>(loadValue<float>(facet + 4 * k, std::endian::little)));
    const auto first = static_cast<std::int64_t>(3 * t);
    raw.addTriangle(first, first + 1, first + 2);
  }
  return raw;
}

/// Reads one solid behind the word "solid" up to its "endsolid". Solids of one name are different ones.
void readSolid(TextScanner& scanner, RawSurface& raw, PartList& parts) {
  const std::string_view title = trimmed(scanner.line());
  if (!raw.space)
    raw.space = findSpace(title, raw.warnings);
  const std::string written = nameInComment(title);
  const std::string name =
      written.empty() && title.find("SPACE=") == title.npos ? std::string(title) : written;
  parts.begin(parts.add(name), raw.polygonCount());
  for (;;) {
    const std::string word = lowered(scanner.word());
    if (word == "vertex") {
      const double x = scanner.coordinate("a coordinate");
      const double y = scanner.coordinate("a coordinate");
      raw.addPoint(x, y, scanner.coordinate("a coordinate"));
      raw.corners.push_back(static_cast<std::int64_t>(raw.pointCount()) - 1);
    } else if (word == "endloop") {
      raw.endPolygon();
    } else if (word == "endsolid") {
      scanner.line();
      return;
    } else if (word.empty()) {
      scanner.failAtEnd("\"endsolid\"");
    } else if (word == "normal") {
      for (int axis = 0; axis < 3; ++axis)
        scanner.word();
    } else if (word != "facet" && word != "outer" && word != "loop" && word != "endfacet") {
      if (scanner.atEnd())
        scanner.failAtEnd("\"endsolid\"");
      scanner.fail(diagnostic("%1 is not a word of an STL file", inQuotes(word)));
    }
  }
}

RawSurface readAscii(const FileBytes& file) {
  RawSurface raw;
  raw.pointsAreShared = false;
  TextScanner scanner(file, file.view());
  PartList parts;
  while (!scanner.atEnd()) {
    const std::string_view word = scanner.word();
    if (lowered(word) != "solid")
      scanner.fail(diagnostic("expected %2, found %1", inQuotes(word), inQuotes("solid")));
    readSolid(scanner, raw, parts);
  }
  if (parts.size() > 0)
    raw.name = parts.at(0).name;
  parts.moveTo(raw);
  scanner.finishCommas(raw.warnings);
  return raw;
}

} // namespace

RawSurface readStl(const FileBytes& file) {
  // Some programs begin the header of binary files with "solid" as well: the size decides first.
  if (!hasBinarySize(file) && isAscii(file))
    return readAscii(file);
  return readBinary(file);
}

void writeStl(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options) {
  std::string bytes = writtenComment(options, kStlHeaderBytes);
  bytes.resize(kStlHeaderBytes, '\0');
  bytes.reserve(kPrefixBytes + kFacetBytes * static_cast<std::size_t>(mesh.triangles.rows()));
  appendValue(bytes, static_cast<std::uint32_t>(mesh.triangles.rows()));
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    std::array<Vec3, 3> corners;
    for (int k = 0; k < 3; ++k)
      corners[static_cast<std::size_t>(k)] = mesh.points.row(mesh.triangles(t, k));
    // `normalized` leaves the zero vector of a triangle without area as it is.
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    for (int axis = 0; axis < 3; ++axis)
      appendValue(bytes, static_cast<float>(normal[axis]));
    for (const Vec3& corner : corners)
      for (int axis = 0; axis < 3; ++axis)
        appendValue(bytes, static_cast<float>(corner[axis]));
    appendValue(bytes, std::uint16_t{0});
  }
  out << bytes;
}

} // namespace viscera::medical_io
