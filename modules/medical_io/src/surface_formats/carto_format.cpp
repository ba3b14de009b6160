#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "surface_formats.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

// The map of a chamber as Biosense Webster's CARTO exports it: sections with a line "number = values" for
// each vertex and triangle.
namespace viscera::medical_io {
namespace {

/// The group of vertices and triangles that a user of CARTO has cut away.
constexpr std::int64_t kCutAway = -1000000;

class CartoReader {
public:
  explicit CartoReader(const FileBytes& file) : file_(file), scanner_(file, file.view()) {}

  RawSurface run() {
    if (!scanner_.line().starts_with("#TriangulatedMesh"))
      file_.fail(diagnostic("It does not begin with \"#TriangulatedMeshVersion2.0\": it is not a CARTO file"),
                 "check its ending");
    while (scanner_.remaining() > 0)
      readLine(trimmed(scanner_.line()));
    requireCount(vertices_, raw_.pointCount(), "vertices");
    requireCount(triangles_, raw_.polygonCount() + cutAway_, "triangles");
    if (cutAway_ > 0)
      raw_.warnings.push_back(
          phrase("%n {triangle|triangles} that CARTO's user has cut away left out", cutAway_));
    return std::move(raw_);
  }

private:
  void readLine(std::string_view line) {
    if (line.empty() || line.starts_with(';'))
      return;
    if (line.starts_with('[')) {
      section_ = line;
      return;
    }
    const std::size_t sign = line.find('=');
    if (sign == line.npos)
      scanner_.fail(diagnostic("%1 is not a line of a CARTO file", inQuotes(line)));
    const std::string_view key = trimmed(line.substr(0, sign));
    const std::string_view value = trimmed(line.substr(sign + 1));
    if (section_ == "[GeneralAttributes]")
      readAttribute(key, value);
    else if (section_ == "[VerticesSection]")
      readVertex(value);
    else if (section_ == "[TrianglesSection]")
      readTriangle(value);
  }

  void readAttribute(std::string_view key, std::string_view value) {
    if (key == "MeshName")
      raw_.name = std::string(value);
    else if (key == "NumVertex")
      vertices_ = parseInteger(value);
    else if (key == "NumTriangle")
      triangles_ = parseInteger(value);
  }

  double takeNumber(std::string_view& values) const {
    const std::string_view word = takeWord(values);
    const std::optional<double> value = parseNumber(word);
    if (!value)
      scanner_.fail(diagnostic("expected %2, found %1", inQuotes(word), "a number"));
    return *value;
  }

  void readVertex(std::string_view values) {
    const double x = takeNumber(values), y = takeNumber(values);
    raw_.addPoint(x, y, takeNumber(values));
  }

  void readTriangle(std::string_view values) {
    std::array<std::int64_t, 3> corners{};
    for (std::int64_t& corner : corners) {
      const std::string_view word = takeWord(values);
      const std::optional<std::int64_t> number = parseInteger(word);
      if (!number)
        scanner_.fail(diagnostic("expected %2, found %1", inQuotes(word), "a point's number"));
      corner = *number;
    }
    for (int axis = 0; axis < 3; ++axis) // Of the normal.
      takeWord(values);
    if (parseInteger(takeWord(values)) == kCutAway)
      ++cutAway_;
    else
      raw_.addPolygon(corners);
  }

  void requireCount(const std::optional<std::int64_t>& stated, std::uint64_t found,
                    std::string_view things) const {
    if (stated && *stated >= 0 && static_cast<std::uint64_t>(*stated) != found)
      file_.fail(
          diagnostic("the file is cut off or damaged: it states %1 %2, but has %3", *stated, things, found));
  }

  const FileBytes& file_;
  TextScanner scanner_;
  RawSurface raw_;
  std::string_view section_;
  std::optional<std::int64_t> vertices_, triangles_;
  std::uint64_t cutAway_ = 0;
};

} // namespace

RawSurface readCarto(const FileBytes& file) {
  return CartoReader(file).run();
}

} // namespace viscera::medical_io
