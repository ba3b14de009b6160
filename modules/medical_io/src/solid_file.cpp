#include "viscera/medical_io/solid_file.h"

#include <array>
#include <cstdint>
#include <ostream>
#include <utility>
#include <vector>

#include "surface_formats/vtk_xml_writer.h"
#include "text_scanner.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

constexpr std::uint8_t kVertexCell = 1, kTetrahedronCell = 10; ///< VTK's numbers of cells.

struct RowsOfArray {
  Eigen::Index operator()(const Values& values) const { return values.size(); }
  Eigen::Index operator()(const Points& vectors) const { return vectors.rows(); }
  Eigen::Index operator()(const std::vector<std::uint8_t>& flags) const {
    return static_cast<Eigen::Index>(flags.size());
  }
};

void addArray(VtkXmlWriter& writer, const SolidArray& array) {
  if (const auto* values = std::get_if<Values>(&array.values))
    writer.array(array.name, values->data(), static_cast<std::size_t>(values->size()), 1);
  else if (const auto* vectors = std::get_if<Points>(&array.values))
    writer.array(array.name, vectors->data(), static_cast<std::size_t>(vectors->size()), 3);
  else if (const auto* flags = std::get_if<std::vector<std::uint8_t>>(&array.values))
    writer.array(array.name, flags->data(), flags->size(), 1);
}

/// The cells of VTK's unstructured grid.
struct SolidCells {
  std::vector<std::int64_t> connectivity, offsets;
  std::vector<std::uint8_t> types;

  void endCell(std::uint8_t type) {
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    types.push_back(type);
  }
};

SolidCells cellsOf(const deformation::Tetrahedra& tetrahedra, Eigen::Index points) {
  std::vector<bool> used(static_cast<std::size_t>(points), false);
  SolidCells cells;
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t) {
    for (int k = 0; k < 4; ++k) {
      cells.connectivity.push_back(tetrahedra(t, k));
      used[static_cast<std::size_t>(tetrahedra(t, k))] = true;
    }
    cells.endCell(kTetrahedronCell);
  }
  for (Eigen::Index i = 0; i < points; ++i)
    if (!used[static_cast<std::size_t>(i)]) {
      cells.connectivity.push_back(i);
      cells.endCell(kVertexCell);
    }
  return cells;
}

VtkXmlWriter gridOf(const Points& points, const deformation::Tetrahedra& tetrahedra,
                    const std::vector<SolidArray>& arrays) {
  const SolidCells cells = cellsOf(tetrahedra, points.rows());
  VtkXmlWriter writer("UnstructuredGrid", VtkAppended::raw);
  writer.open("Piece NumberOfPoints=\"" + std::to_string(points.rows()) + "\" NumberOfCells=\"" +
              std::to_string(cells.types.size()) + "\"");
  writer.open(arrays.empty() ? "PointData" : "PointData Scalars=\"" + xmlEscaped(arrays.front().name) + "\"");
  for (const SolidArray& array : arrays)
    addArray(writer, array);
  writer.close();
  writer.open("Points");
  writer.array("Points", points.data(), static_cast<std::size_t>(points.size()), 3);
  writer.close();
  writer.open("Cells");
  writer.array("connectivity", cells.connectivity.data(), cells.connectivity.size(), 1);
  writer.array("offsets", cells.offsets.data(), cells.offsets.size(), 1);
  writer.array("types", cells.types.data(), cells.types.size(), 1);
  return writer;
}

} // namespace

void writeSolid(const std::filesystem::path& file, const Points& points,
                const deformation::Tetrahedra& tetrahedra, const std::vector<SolidArray>& arrays) {
  if (file.extension() != ".vtu")
    throw CannotCreateError(phrase("this cannot be written as %1", inQuotes(file.extension().string())),
                            file.string(), phrase("let its name end in %1", ".vtu"));
  for (const SolidArray& array : arrays)
    if (const Eigen::Index rows = std::visit(RowsOfArray(), array.values); rows != points.rows())
      throw DataError(misuse("the array %1 has %2 values for %3 points", array.name, rows, points.rows()),
                      file.string());
  VtkXmlWriter grid = gridOf(points, tetrahedra, arrays);
  writeAtomically(file, [&](std::ostream& out) { grid.write(out); });
}

} // namespace viscera::medical_io
