#include <algorithm>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "space_tag.h"
#include "surface_formats.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

// VTK 9.1 has no reader for OFF.
namespace viscera::medical_io {
namespace {

class OffReader {
public:
  explicit OffReader(const FileBytes& file) : file_(file), scanner_(file, file.view()) {}

  RawSurface run() {
    readHeader();
    for (std::uint64_t v = 0; v < points_; ++v)
      readPoint();
    for (std::uint64_t f = 0; f < faces_; ++f)
      readFace();
    scanner_.finishCommas(raw_.warnings);
    return std::move(raw_);
  }

private:
  /// The next line that is not empty; comments run from # to the line's end.
  std::string_view nextLine(std::string_view part) {
    while (scanner_.remaining() > 0) {
      std::string_view line = scanner_.line();
      const std::size_t comment = line.find('#');
      if (comment != line.npos)
        raw_.takeComment(trimmed(line.substr(comment + 1)));
      line = trimmed(line.substr(0, comment));
      if (!line.empty())
        return line;
    }
    scanner_.failAtEnd(part);
  }

  void readHeader() {
    std::string_view line = nextLine("\"OFF\"");
    const std::string_view word = takeWord(line);
    const std::string_view prefix = word.substr(0, word.size() - std::min<std::size_t>(3, word.size()));
    if (!word.ends_with("OFF") || prefix.find_first_not_of("STCN") != prefix.npos)
      file_.fail(prefix.find_first_of("4n") != prefix.npos
                     ? diagnostic("It holds a surface in a space of more than three dimensions")
                     : diagnostic("It does not begin with \"OFF\": it is not an OFF file"),
                 "check its ending");
    hasNormals_ = prefix.find('N') != prefix.npos;
    // The counts may stand in the line of the first word.
    if (trimmed(line).empty())
      line = nextLine("the number of points");
    if (trimmed(line) == "BINARY")
      file_.fail("It is a binary OFF file, which Viscera does not read", "export it as STL, OBJ, PLY or GLB");
    points_ = takeCount(line, "the number of points", 6);
    faces_ = takeCount(line, "the number of faces", 2);
  }

  std::uint64_t takeCount(std::string_view& line, std::string_view part, std::uint64_t bytesEach) {
    const std::string_view word = takeWord(line);
    const std::optional<std::int64_t> count = parseInteger(word);
    if (!count || *count < 0)
      scanner_.fail(diagnostic("expected %2, found %1", inQuotes(word), part));
    if (saturatedProduct(static_cast<std::uint64_t>(*count), bytesEach) > scanner_.remaining() + bytesEach)
      scanner_.fail(diagnostic("%1 is %2, more than the %3 bytes that are left can hold", part, *count,
                               scanner_.remaining()));
    return static_cast<std::uint64_t>(*count);
  }

  double takeCoordinate(std::string_view word) { return scanner_.coordinateFrom(word, "a number"); }

  /// A channel of a colour; with a decimal comma where the coordinates have it.
  double takeChannel(std::string_view word) const {
    std::string english(word);
    std::replace(english.begin(), english.end(), ',', '.');
    const std::optional<double> value = parseNumber(english);
    if (!value)
      scanner_.fail(diagnostic("expected %2, found %1", inQuotes(word), "a number"));
    return *value;
  }

  void readPoint() {
    std::string_view line = nextLine("a point");
    const double x = takeCoordinate(takeWord(line));
    const double y = takeCoordinate(takeWord(line));
    raw_.addPoint(x, y, takeCoordinate(takeWord(line)));
    for (int axis = 0; axis < 3 && hasNormals_; ++axis)
      takeWord(line);
    readColor(line);
  }

  /// Three or four numbers, from 0 to 255, or with a decimal point from 0 to 1.
  void readColor(std::string_view line) {
    std::vector<double> channels;
    bool fractions = false;
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
      fractions = fractions || word.find_first_of(".,") != word.npos;
      channels.push_back(takeChannel(word));
    }
    if (channels.size() != 3 && channels.size() != 4)
      return;
    for (std::size_t k = 0; k < 3; ++k)
      raw_.addChannel(channels[k] * (fractions ? 255.0 : 1.0));
  }

  void readFace() {
    std::string_view line = nextLine("a face");
    const std::string_view word = takeWord(line);
    const std::optional<std::int64_t> corners = parseInteger(word);
    if (!corners || *corners < 1)
      scanner_.fail(diagnostic("expected %2, found %1", inQuotes(word), "a face's number of corners"));
    for (std::int64_t k = 0; k < *corners; ++k) {
      const std::string_view corner = takeWord(line);
      const std::optional<std::int64_t> point = parseInteger(corner);
      if (!point)
        scanner_.fail(corner.empty()
                          ? diagnostic("a face has fewer corners than it claims")
                          : diagnostic("expected %2, found %1", inQuotes(corner), "a point's number"));
      raw_.corners.push_back(*point);
    }
    // Behind the corners stands the face's colour.
    raw_.endPolygon();
  }

  const FileBytes& file_;
  TextScanner scanner_;
  RawSurface raw_;
  std::uint64_t points_ = 0;
  std::uint64_t faces_ = 0;
  bool hasNormals_ = false;
};

} // namespace

RawSurface readOff(const FileBytes& file) {
  return OffReader(file).run();
}

void writeOff(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options) {
  const bool colored = mesh.colors.rows() > 0;
  std::string text = std::string(colored ? "COFF" : "OFF") + "\n# " + writtenComment(options) + "\n" +
                     std::to_string(mesh.points.rows()) + " " + std::to_string(mesh.triangles.rows()) +
                     " 0\n";
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
    for (int axis = 0; axis < 3; ++axis)
      appendNumber(axis == 0 ? text : text += ' ', mesh.points(v, axis));
    for (int k = 0; k < 3 && colored; ++k)
      appendNumber(text += ' ', std::int64_t{mesh.colors(v, k)});
    text += colored ? " 255\n" : "\n";
  }
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    text += '3';
    for (int k = 0; k < 3; ++k)
      appendNumber(text += ' ', std::int64_t{mesh.triangles(t, k)});
    text += '\n';
  }
  out << text;
}

} // namespace viscera::medical_io
