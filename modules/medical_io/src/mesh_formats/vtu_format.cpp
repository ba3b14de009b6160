#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "mesh_formats/cell_mesh.h"
#include "mesh_formats/vtk_cells.h"
#include "surface_formats/vtk_xml_document.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

// Own reader: as for VTP, VTK's believes a damaged header.
namespace viscera::medical_io {
namespace {

/// Bits of VTK's array of ghost cells: another piece has the cell, or it is hidden.
constexpr std::int64_t kGhostBits = 1 | 32;

class VtuReader {
public:
  explicit VtuReader(const FileBytes& file) : file_(file), document_(file) {}

  CellMesh run() {
    const XmlElement* data = document_.type() == "UnstructuredGrid" ? document_.data() : nullptr;
    if (data == nullptr)
      file_.fail(phrase("It holds %1, not %2", inQuotes(document_.type()), inQuotes("UnstructuredGrid")),
                 "extract its surface first");
    document_.readFields(mesh_.surface);
    for (const XmlElement& child : data->children)
      if (child.name == "Piece")
        readPiece(child);
    return std::move(mesh_);
  }

private:
  void readPiece(const XmlElement& piece) {
    const std::uint64_t points = document_.count(piece, "NumberOfPoints");
    const std::uint64_t cells = document_.count(piece, "NumberOfCells");
    const std::uint64_t before = mesh_.surface.pointCount();
    if (points > 0)
      document_.readPoints(piece, points, mesh_.surface);
    if (cells > 0)
      readCells(piece, cells, before, points);
  }

  void readCells(const XmlElement& piece, std::uint64_t cells, std::uint64_t before, std::uint64_t points) {
    const XmlElement* element = piece.child("Cells");
    if (element == nullptr)
      file_.fail(diagnostic("It announces cells of the kind %1, but has none", "Cells"));
    const auto integers = [&](std::string_view name) {
      return readVtpIntegers(document_.storage(), document_.cellArray(*element, name));
    };
    std::vector<std::int64_t> list = integers("connectivity");
    const std::vector<std::int64_t> ends = integers("offsets");
    const std::vector<std::int64_t> types = integers("types");
    if (ends.size() != cells || types.size() != cells || ends.front() < 0 ||
        !std::is_sorted(ends.begin(), ends.end()) || ends.back() != static_cast<std::int64_t>(list.size()))
      file_.fail(diagnostic("the offsets of its cells (%1) do not fit their points", "Cells"));
    for (std::int64_t& point : list) {
      if (point < 0 || static_cast<std::uint64_t>(point) >= points)
        file_.fail(diagnostic("a cell refers to point %1, but there are %2 (counted from 0)", point, points));
      point += static_cast<std::int64_t>(before);
    }
    const std::vector<std::int64_t> regions = numbersOfCells(piece, cells, numbersRegions);
    const std::vector<std::int64_t> ghosts =
        numbersOfCells(piece, cells, [](std::string_view name) { return name == "vtkGhostType"; });
    std::int64_t begin = 0;
    for (std::size_t cell = 0; cell < ends.size(); ++cell) {
      const auto corners = std::span(list).subspan(static_cast<std::size_t>(begin),
                                                   static_cast<std::size_t>(ends[cell] - begin));
      begin = ends[cell];
      if (ghosts.empty() || (ghosts[cell] & kGhostBits) == 0)
        addVtkCell(mesh_, types[cell], corners, regions.empty() ? 0 : regions[cell], file_);
    }
  }

  /// The whole numbers of the first array at the cells whose name is accepted; none without it.
  template <class Accepted>
  std::vector<std::int64_t> numbersOfCells(const XmlElement& piece, std::uint64_t cells,
                                           const Accepted& accepted) const {
    const XmlElement* data = piece.child("CellData");
    if (data == nullptr)
      return {};
    for (const XmlElement& array : data->children) {
      const std::string_view components = array.attribute("NumberOfComponents");
      if (array.name != "DataArray" || !accepted(array.attribute("Name")) ||
          (!components.empty() && components != "1"))
        continue;
      std::vector<std::int64_t> numbers = wholeNumbers(readVtpNumbers(document_.storage(), array));
      if (numbers.size() == cells)
        return numbers;
    }
    return {};
  }

  const FileBytes& file_;
  VtkXmlDocument document_;
  CellMesh mesh_;
};

} // namespace

CellMesh readVtuCells(const FileBytes& file) {
  return VtuReader(file).run();
}

} // namespace viscera::medical_io
