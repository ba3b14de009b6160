#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "byte_cursor.h"
#include "mesh_formats/cell_mesh.h"
#include "scalar.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

// The text (.mesh) and the binary form (.meshb) of Inria's programs: medit, Mmg, TetGen, gmsh, FreeFEM.
namespace viscera::medical_io {
namespace {

/// A list of cells. Each line has the points, from 1, and a reference, which is the number of a region.
struct MeditCells {
  std::string_view keyword; ///< In lower case.
  std::int32_t code;        ///< Of the binary form.
  CellKind kind;
};

constexpr CellKind kEdge = {CellKind::Use::ignore, SolidShape::tetrahedron, 2, 0};

constexpr CellKind flatCell(std::size_t corners, std::size_t points) {
  return {CellKind::Use::flat, SolidShape::tetrahedron, points, corners};
}
constexpr CellKind solidCell(SolidShape shape, std::size_t points) {
  return {CellKind::Use::solid, shape, points, 0};
}

constexpr std::array<MeditCells, 13> kMeditCells = {
    {{"edges", 5, kEdge},
     {"triangles", 6, flatCell(3, 3)},
     {"quadrilaterals", 7, flatCell(4, 4)},
     {"tetrahedra", 8, solidCell(SolidShape::tetrahedron, 4)},
     {"prisms", 9, solidCell(SolidShape::wedge, 6)},
     {"pentahedra", 9, solidCell(SolidShape::wedge, 6)},
     {"hexahedra", 10, solidCell(SolidShape::hexahedron, 8)},
     {"hexaedra", 10, solidCell(SolidShape::hexahedron, 8)},
     {"pyramids", 49, solidCell(SolidShape::pyramid, 5)},
     {"trianglesp2", 24, flatCell(3, 6)},
     {"quadrilateralsq2", 27, flatCell(4, 9)},
     {"tetrahedrap2", 30, solidCell(SolidShape::tetrahedron, 10)},
     {"hexahedraq2", 33, solidCell(SolidShape::hexahedron, 27)}}};

const MeditCells* cellsNamed(std::string_view keyword) {
  const auto* found = std::find_if(kMeditCells.begin(), kMeditCells.end(),
                                   [&](const MeditCells& cells) { return cells.keyword == keyword; });
  return found == kMeditCells.end() ? nullptr : found;
}

const MeditCells* cellsOfCode(std::int32_t code) {
  const auto* found = std::find_if(kMeditCells.begin(), kMeditCells.end(),
                                   [&](const MeditCells& cells) { return cells.code == code; });
  return found == kMeditCells.end() ? nullptr : found;
}

[[noreturn]] void failAsPlane(const FileBytes& file) {
  file.fail("It is a plane mesh, of two dimensions", "export a mesh of three dimensions");
}

/// Point numbers are counted from 1.
std::int64_t fromZero(std::int64_t point) {
  return point > 0 ? point - 1 : -1;
}

class MeditTextReader {
public:
  explicit MeditTextReader(const FileBytes& file) : file_(file), scanner_(file, file.view()) {}

  CellMesh run() {
    while (!atEnd()) {
      const std::string_view word = scanner_.word();
      const std::string keyword = lowered(word);
      if (keyword == "end")
        break;
      if (keyword == "meshversionformatted") {
        integer("the version of the format");
        started_ = true;
      } else if (!started_) {
        file_.fail(diagnostic("It does not begin with \"MeshVersionFormatted\": it is not a medit file"),
                   "check its ending");
      } else if (keyword == "dimension") {
        if (integer("the dimension") != 3)
          failAsPlane(file_);
      } else if (keyword == "vertices") {
        readVertices();
      } else if (const MeditCells* cells = cellsNamed(keyword)) {
        readCells(*cells);
      } else {
        skipSection(word);
      }
    }
    return std::move(mesh_);
  }

private:
  /// Comments run from # to the line's end.
  bool atEnd() {
    while (!scanner_.atEnd()) {
      if (!scanner_.rest().starts_with('#'))
        return false;
      scanner_.line();
    }
    return true;
  }

  std::int64_t integer(std::string_view part) {
    atEnd();
    return scanner_.integer(part);
  }

  double number(std::string_view part) {
    atEnd();
    return scanner_.number(part);
  }

  std::uint64_t count(std::string_view part, std::uint64_t bytesEach) {
    atEnd();
    return scanner_.count(part, bytesEach);
  }

  void readVertices() {
    if (mesh_.surface.pointCount() > 0)
      scanner_.fail(diagnostic("there is a second list of points"));
    const std::uint64_t points = count("the number of points", 8);
    for (std::uint64_t i = 0; i < points; ++i) {
      const double x = number("a coordinate"), y = number("a coordinate");
      mesh_.surface.addPoint(x, y, number("a coordinate"));
      number("a reference");
    }
  }

  void readCells(const MeditCells& cells) {
    const std::uint64_t lines = count("the number of cells", 2 * (cells.kind.points + 1));
    std::vector<std::int64_t> points(cells.kind.points);
    for (std::uint64_t i = 0; i < lines; ++i) {
      for (std::int64_t& point : points)
        point = fromZero(integer("a point's number"));
      addCell(mesh_, cells.kind, points, integer("a reference"));
    }
  }

  /// Corners, ridges, normals and others: the numbers up to the next keyword.
  void skipSection(std::string_view word) {
    if (word.empty() || std::isalpha(static_cast<unsigned char>(word.front())) == 0)
      scanner_.fail(diagnostic("%1 is not a section of a medit file", inQuotes(word)));
    while (!atEnd() && parseNumber(scanner_.peek()))
      scanner_.word();
  }

  const FileBytes& file_;
  TextScanner scanner_;
  CellMesh mesh_;
  bool started_ = false;
};

class MeditBinaryReader {
public:
  explicit MeditBinaryReader(const FileBytes& file)
      : file_(file), order_(orderOf(file)), cursor_(file, file.view(), order_) {}

  CellMesh run() {
    cursor_.take<std::int32_t>("the mark of the format");
    version_ = cursor_.take<std::int32_t>("the version of the format");
    if (version_ < 1 || version_ > 4)
      file_.fail(diagnostic("it is of version %1 of the format, not of 1 to 4", version_));
    for (;;) {
      const auto code = cursor_.take<std::int32_t>("a section");
      if (code == kEnd)
        break;
      const std::int64_t next =
          version_ < 3 ? cursor_.take<std::int32_t>("a place") : cursor_.take<std::int64_t>("a place");
      readSection(code);
      if (next == 0)
        break;
      const std::uint64_t here = file_.bytes.size() - cursor_.remaining();
      if (next < 0 || static_cast<std::uint64_t>(next) < here)
        file_.fail(diagnostic("a section ends at %1, where %2 is read already", next, here));
      cursor_.takeBytes(static_cast<std::uint64_t>(next) - here, "a section");
    }
    return std::move(mesh_);
  }

private:
  static constexpr std::int32_t kDimension = 3, kVertices = 4, kEnd = 54;

  static std::endian orderOf(const FileBytes& file) {
    const bool little =
        file.bytes.size() >= 4 && loadValue<std::int32_t>(file.bytes.data(), std::endian::little) == 1;
    return little ? std::endian::little : std::endian::big;
  }

  void readSection(std::int32_t code) {
    if (code == kDimension) {
      if (cursor_.take<std::int32_t>("the dimension") != 3)
        failAsPlane(file_);
    } else if (code == kVertices) {
      readVertices();
    } else if (const MeditCells* cells = cellsOfCode(code)) {
      readCells(*cells);
    }
  }

  std::int64_t integer(std::string_view part) {
    return version_ < 4 ? cursor_.take<std::int32_t>(part) : cursor_.take<std::int64_t>(part);
  }

  double number() {
    return version_ == 1 ? static_cast<double>(cursor_.take<float>("a coordinate"))
                         : cursor_.take<double>("a coordinate");
  }

  std::uint64_t count(std::string_view part, std::uint64_t bytesEach) {
    const std::int64_t value = integer(part);
    if (value < 0 || saturatedProduct(static_cast<std::uint64_t>(value), bytesEach) > cursor_.remaining())
      file_.fail(diagnostic("%1 is %2, more than the %3 bytes that are left can hold", part, value,
                            cursor_.remaining()));
    return static_cast<std::uint64_t>(value);
  }

  void readVertices() {
    const std::uint64_t points = count("the number of points", 16);
    for (std::uint64_t i = 0; i < points; ++i) {
      const double x = number(), y = number();
      mesh_.surface.addPoint(x, y, number());
      integer("a reference");
    }
  }

  void readCells(const MeditCells& cells) {
    const std::uint64_t lines = count("the number of cells", 4 * (cells.kind.points + 1));
    std::vector<std::int64_t> points(cells.kind.points);
    for (std::uint64_t i = 0; i < lines; ++i) {
      for (std::int64_t& point : points)
        point = fromZero(integer("a point's number"));
      addCell(mesh_, cells.kind, points, integer("a reference"));
    }
  }

  const FileBytes& file_;
  std::endian order_;
  ByteCursor cursor_;
  CellMesh mesh_;
  std::int32_t version_ = 0;
};

} // namespace

CellMesh readMeditCells(const FileBytes& file) {
  const bool binary = file.bytes.size() >= 4 && file.bytes.find('\0') < 4;
  return binary ? MeditBinaryReader(file).run() : MeditTextReader(file).run();
}

} // namespace viscera::medical_io
