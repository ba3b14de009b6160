#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "mesh_formats/cell_mesh.h"
#include "scalar.h"
#include "text_scanner.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

// A mesh of openCARP is two files of one name: the points (.pts) in micrometres, and the elements (.elem).
namespace viscera::medical_io {
namespace {

constexpr double kMmPerMicrometre = 1e-3;

constexpr std::array<std::pair<std::string_view, CellKind>, 8> kCarpKinds = {
    {{"Ln", {CellKind::Use::ignore, SolidShape::tetrahedron, 2, 0}},
     {"Cx", {CellKind::Use::ignore, SolidShape::tetrahedron, 2, 0}},
     {"Tr", {CellKind::Use::flat, SolidShape::tetrahedron, 3, 3}},
     {"Qd", {CellKind::Use::flat, SolidShape::tetrahedron, 4, 4}},
     {"Tt", {CellKind::Use::solid, SolidShape::tetrahedron, 4, 0}},
     {"Py", {CellKind::Use::solid, SolidShape::pyramid, 5, 0}},
     {"Pr", {CellKind::Use::solid, SolidShape::wedge, 6, 0}},
     {"Hx", {CellKind::Use::solid, SolidShape::hexahedron, 8, 0}}}};

class OpenCarpReader {
public:
  explicit OpenCarpReader(const FileBytes& file) : file_(file) {}

  CellMesh run() {
    const std::string extension = extensionOf(file_.file);
    if (extension == ".pts") {
      readPoints(file_);
      readElements(beside(".elem"));
    } else {
      readPoints(beside(".pts"));
      readElements(file_);
    }
    untwist();
    mesh_.surface.warnings.push_back(
        "openCARP states points in micrometres: its numbers were divided by 1,000");
    return std::move(mesh_);
  }

private:
  /// The other file. A surface may be called as a part of its mesh: heart.lv.surf is of heart.pts.
  FileBytes beside(const char* extension) const {
    std::filesystem::path base = file_.file;
    std::filesystem::path first;
    do {
      base.replace_extension();
      std::filesystem::path other = base;
      other += extension;
      if (first.empty())
        first = other;
      std::error_code ignored;
      if (std::filesystem::exists(other, ignored))
        return readWholeFile(other);
    } while (base.has_extension());
    file_.fail(phrase("the other file that belongs to it, %1, is not beside it",
                      inQuotes(first.filename().string())),
               "put both files into one folder");
  }

  void readPoints(const FileBytes& file) {
    TextScanner scanner(file, file.view());
    const std::uint64_t count = scanner.count("the number of points", 6);
    mesh_.surface.coordinates.reserve(static_cast<std::size_t>(3 * count));
    for (std::uint64_t i = 0; i < 3 * count; ++i)
      mesh_.surface.coordinates.push_back(kMmPerMicrometre * scanner.number("a coordinate"));
    if (!scanner.atEnd())
      mesh_.surface.warnings.push_back(
          phrase("%1 has more lines than the %2 points that it states; they were left out",
                 file.file.filename().string(), count));
  }

  /// The list of elements; a surface file may have several lists, each with its name behind the number.
  void readElements(const FileBytes& file) {
    TextScanner scanner(file, file.view());
    do {
      const std::uint64_t count = scanner.count("the number of elements", 6);
      scanner.line();
      for (std::uint64_t i = 0; i < count; ++i)
        readElement(file, scanner);
    } while (!scanner.atEnd());
  }

  void readElement(const FileBytes& file, TextScanner& scanner) {
    const std::string_view word = scanner.word();
    if (word.empty())
      scanner.failAtEnd("an element");
    const auto kind = lookUp(kCarpKinds, word);
    if (!kind)
      file.fail(phrase("It has elements of the type %1, which Viscera does not read", inQuotes(word)),
                "save the mesh as tetrahedra");
    std::vector<std::int64_t> points;
    for (std::size_t k = 0; k < kind->points; ++k)
      points.push_back(scanner.integer("a point's number"));
    const std::string_view tag = trimmed(scanner.line());
    const std::optional<double> region = tag.empty() ? std::optional(0.0) : parseNumber(tag);
    // Programs in between have written tags as "1.0".
    const bool whole = region && std::abs(*region) < 1e15;
    addCell(mesh_, *kind, points, whole ? static_cast<std::int64_t>(*region) : 0);
  }

  /// The upper corners of hexahedra and prisms run against the lower ones in openCARP, and with them in files
  /// that other programs wrote. The order of the larger volumes is right, because the other one is twisted.
  void untwist() {
    const std::int64_t points = static_cast<std::int64_t>(mesh_.surface.pointCount());
    double asWritten = 0, turned = 0;
    forEachTwistable([&](SolidShape shape, std::span<std::int64_t> corners) {
      if (std::any_of(corners.begin(), corners.end(),
                      [&](std::int64_t corner) { return corner < 0 || corner >= points; }))
        return; // An error that is found later.
      asWritten += std::abs(volumeOf(shape, corners, mesh_.surface.coordinates));
      turnTop(corners);
      turned += std::abs(volumeOf(shape, corners, mesh_.surface.coordinates));
      turnTop(corners);
    });
    if (turned > asWritten)
      forEachTwistable([&](SolidShape, std::span<std::int64_t> corners) { turnTop(corners); });
  }

  /// The first corner above stays.
  static void turnTop(std::span<std::int64_t> corners) {
    const auto top = corners.subspan(corners.size() / 2 + 1);
    std::reverse(top.begin(), top.end());
  }

  template <class Visit>
  void forEachTwistable(const Visit& visit) {
    std::size_t at = 0;
    for (const SolidShape shape : mesh_.shapes) {
      const std::size_t count = cornerCountOf(shape);
      if (shape == SolidShape::wedge || shape == SolidShape::hexahedron)
        visit(shape, std::span(mesh_.corners).subspan(at, count));
      at += count;
    }
  }

  const FileBytes& file_;
  CellMesh mesh_;
};

} // namespace

CellMesh readOpenCarpCells(const FileBytes& file) {
  return OpenCarpReader(file).run();
}

} // namespace viscera::medical_io
