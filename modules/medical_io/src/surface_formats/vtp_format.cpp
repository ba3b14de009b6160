#include <algorithm>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "space_tag.h"
#include "surface_formats.h"
#include "surface_formats/vtk_xml_document.h"
#include "surface_formats/vtk_xml_writer.h"
#include "surface_formats/vtp_data_array.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"
#include "xml_tree.h"

namespace viscera::medical_io {
namespace {

class VtpReader {
public:
  explicit VtpReader(const FileBytes& file) : file_(file), document_(file), storage_(document_.storage()) {}

  RawSurface run() {
    if (document_.type() != "PolyData")
      file_.fail(phrase("It holds %1, not %2", inQuotes(document_.type()), inQuotes("PolyData")),
                 "extract its surface first");
    const XmlElement* data = document_.data();
    if (data == nullptr)
      file_.fail("It holds no PolyData", "export it as a surface of triangles");
    document_.readFields(raw_);
    for (const XmlElement& child : data->children)
      if (child.name == "Piece")
        readPiece(child);
    if (!everyPieceHasColors_)
      raw_.colors.clear();
    return std::move(raw_);
  }

private:
  std::uint64_t count(const XmlElement& piece, std::string_view key) const {
    return document_.count(piece, key);
  }

  void readPiece(const XmlElement& piece) {
    const std::uint64_t points = count(piece, "NumberOfPoints");
    const std::uint64_t before = raw_.pointCount();
    if (points > 0)
      document_.readPoints(piece, points, raw_);
    readCells(piece, "Polys", count(piece, "NumberOfPolys"), before, points);
    readCells(piece, "Strips", count(piece, "NumberOfStrips"), before, points);
    raw_.ignoredCells += count(piece, "NumberOfLines") + count(piece, "NumberOfVerts");
    readColors(piece, points);
  }

  void readCells(const XmlElement& piece, std::string_view kind, std::uint64_t cells, std::uint64_t before,
                 std::uint64_t points) {
    if (cells == 0)
      return;
    const XmlElement* element = piece.child(kind);
    if (element == nullptr)
      file_.fail(diagnostic("It announces cells of the kind %1, but has none", kind));
    std::vector<std::int64_t> list = readVtpIntegers(storage_, document_.cellArray(*element, "connectivity"));
    const std::vector<std::int64_t> ends =
        readVtpIntegers(storage_, document_.cellArray(*element, "offsets"));
    if (ends.size() != cells || ends.front() < 0 || !std::is_sorted(ends.begin(), ends.end()) ||
        ends.back() != static_cast<std::int64_t>(list.size()))
      file_.fail(diagnostic("the offsets of its cells (%1) do not fit their points", kind));
    for (std::int64_t& point : list) {
      if (point < 0 || static_cast<std::uint64_t>(point) >= points)
        file_.fail(diagnostic("a cell refers to point %1, but there are %2 (counted from 0)", point, points));
      point += static_cast<std::int64_t>(before);
    }
    std::int64_t begin = 0;
    for (const std::int64_t end : ends) {
      const auto cell =
          std::span(list).subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
      begin = end;
      if (kind == "Strips")
        raw_.addStrip(cell);
      else
        raw_.addPolygon(cell);
    }
  }

  static bool holdsColors(const XmlElement& array) {
    const std::string_view components = array.attribute("NumberOfComponents");
    return array.attribute("type") == "UInt8" && (components == "3" || components == "4");
  }

  /// The active scalars when they can be colours, or else the first array that can.
  void readColors(const XmlElement& piece, std::uint64_t points) {
    const XmlElement* data = piece.child("PointData");
    const XmlElement* chosen = nullptr;
    for (std::size_t i = 0; data != nullptr && i < data->children.size(); ++i)
      if (const XmlElement& array = data->children[i];
          holdsColors(array) && (chosen == nullptr || array.attribute("Name") == data->attribute("Scalars")))
        chosen = &array;
    if (chosen == nullptr) {
      everyPieceHasColors_ = everyPieceHasColors_ && points == 0;
      return;
    }
    const std::uint64_t components = chosen->attribute("NumberOfComponents") == "3" ? 3 : 4;
    const std::vector<std::int64_t> values = readVtpIntegers(storage_, *chosen);
    if (values.size() != saturatedProduct(points, components))
      file_.fail(diagnostic("It has %1 colour values for %2 points", values.size(), points));
    for (std::size_t i = 0; i < values.size(); ++i)
      if (i % components < 3)
        raw_.colors.push_back(static_cast<std::uint8_t>(values[i]));
  }

  const FileBytes& file_;
  VtkXmlDocument document_;
  const VtpStorage& storage_;
  RawSurface raw_;
  bool everyPieceHasColors_ = true;
};

void addCells(VtkXmlWriter& writer, const char* kind, const std::vector<std::int64_t>& connectivity,
              const std::vector<std::int64_t>& offsets) {
  writer.open(kind);
  writer.array("connectivity", connectivity.data(), connectivity.size(), 1);
  writer.array("offsets", offsets.data(), offsets.size(), 1);
  writer.close();
}

void addTriangles(VtkXmlWriter& writer, const Triangles& triangles) {
  std::vector<std::int64_t> offsets(static_cast<std::size_t>(triangles.rows()));
  for (std::size_t t = 0; t < offsets.size(); ++t)
    offsets[t] = static_cast<std::int64_t>(3 * (t + 1));
  addCells(writer, "Polys", {triangles.data(), triangles.data() + triangles.size()}, offsets);
}

std::string pieceOf(const geometry::TriangleMesh& mesh) {
  return "Piece NumberOfPoints=\"" + std::to_string(mesh.points.rows()) +
         "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         std::to_string(mesh.triangles.rows()) + "\"";
}

void addPointData(VtkXmlWriter& writer, const geometry::TriangleMesh& mesh, const PointVectors* vectors) {
  const bool colored = mesh.colors.rows() > 0;
  writer.open(std::string("PointData") + (colored ? " Scalars=\"Colors\"" : "") +
              (vectors != nullptr ? " Vectors=\"" + xmlEscaped(vectors->name) + "\"" : ""));
  if (colored)
    writer.array("Colors", mesh.colors.data(), static_cast<std::size_t>(mesh.colors.size()), 3);
  if (vectors != nullptr)
    writer.array(vectors->name, vectors->values.data(), static_cast<std::size_t>(vectors->values.size()), 3);
  writer.close();
}

} // namespace

RawSurface readVtp(const FileBytes& file) {
  return VtpReader(file).run();
}

void writeVtp(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options) {
  writeVtp(out, mesh, options, nullptr);
}

void writeVtp(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options,
              const PointVectors* vectors) {
  VtkXmlWriter writer("PolyData", VtkAppended::base64);
  writer.open("FieldData");
  writer.text("SPACE", std::string(spaceName(options.space)));
  if (!options.name.empty())
    writer.text("Name", options.name);
  writer.close();
  writer.open(pieceOf(mesh));
  addPointData(writer, mesh, vectors);
  writer.open("Points");
  writer.array("Points", mesh.points.data(), static_cast<std::size_t>(mesh.points.size()), 3);
  writer.close();
  for (const char* kind : {"Verts", "Lines", "Strips"}) // VTK's reader asks for them.
    addCells(writer, kind, {}, {});
  addTriangles(writer, mesh.triangles);
  writer.write(out);
}

} // namespace viscera::medical_io
