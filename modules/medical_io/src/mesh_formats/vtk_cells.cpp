#include "mesh_formats/vtk_cells.h"

#include <array>
#include <cmath>
#include <optional>

#include "scalar.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

/// VTK's numbers of the types whose corners come first in their order. Those of higher order have more
/// points.
constexpr std::array<std::pair<std::int64_t, SolidShape>, 20> kVtkSolids = {
    {{10, SolidShape::tetrahedron}, {24, SolidShape::tetrahedron}, {71, SolidShape::tetrahedron},
     {78, SolidShape::tetrahedron}, {12, SolidShape::hexahedron},  {25, SolidShape::hexahedron},
     {29, SolidShape::hexahedron},  {33, SolidShape::hexahedron},  {72, SolidShape::hexahedron},
     {79, SolidShape::hexahedron},  {13, SolidShape::wedge},       {26, SolidShape::wedge},
     {31, SolidShape::wedge},       {32, SolidShape::wedge},       {73, SolidShape::wedge},
     {80, SolidShape::wedge},       {14, SolidShape::pyramid},     {27, SolidShape::pyramid},
     {37, SolidShape::pyramid},     {74, SolidShape::pyramid}}};

constexpr std::array<std::pair<std::int64_t, std::size_t>, 11> kVtkFlatCells = {
    {{5, 3}, {22, 3}, {34, 3}, {69, 3}, {76, 3}, {9, 4}, {23, 4}, {28, 4}, {30, 4}, {70, 4}, {77, 4}}};

/// Nothing, points and lines.
constexpr std::array<std::pair<std::int64_t, bool>, 9> kVtkThinCells = {
    {{0, true}, {1, true}, {2, true}, {3, true}, {4, true}, {21, true}, {35, true}, {68, true}, {75, true}}};

constexpr std::int64_t kVtkStrip = 6, kVtkPolygon = 7, kVtkPixel = 8, kVtkVoxel = 11,
                       kVtkQuadraticPolygon = 36, kVtkBezierPyramid = 81;

void requireCellPoints(std::span<const std::int64_t> points, std::size_t count, std::int64_t type,
                       const FileBytes& file) {
  if (points.size() < count)
    file.fail(diagnostic("a cell of type %1 has %2 points instead of %3", type, points.size(), count));
}

template <std::size_t count>
std::array<std::int64_t, count> reordered(std::span<const std::int64_t> points,
                                          const std::array<std::size_t, count>& order) {
  std::array<std::int64_t, count> result{};
  for (std::size_t k = 0; k < count; ++k)
    result[k] = points[order[k]];
  return result;
}

void addStripCell(CellMesh& mesh, std::span<const std::int64_t> points, std::int64_t region) {
  const std::size_t before = mesh.surface.polygonCount();
  mesh.surface.addStrip(points);
  mesh.flatRegions.insert(mesh.flatRegions.end(), mesh.surface.polygonCount() - before, region);
}

} // namespace

void addVtkCell(CellMesh& mesh, std::int64_t type, std::span<const std::int64_t> points, std::int64_t region,
                const FileBytes& file) {
  const auto solid =
      type == kVtkBezierPyramid ? std::optional(SolidShape::pyramid) : lookUp(kVtkSolids, type);
  if (solid) {
    requireCellPoints(points, cornerCountOf(*solid), type, file);
    mesh.addSolid(*solid, points, region);
  } else if (const auto corners = lookUp(kVtkFlatCells, type)) {
    requireCellPoints(points, *corners, type, file);
    mesh.addFlat(*corners, points, region);
  } else if (type == kVtkVoxel) {
    requireCellPoints(points, 8, type, file);
    mesh.addSolid(SolidShape::hexahedron, reordered<8>(points, {0, 1, 3, 2, 4, 5, 7, 6}), region);
  } else if (type == kVtkPixel) {
    requireCellPoints(points, 4, type, file);
    mesh.addFlat(4, reordered<4>(points, {0, 1, 3, 2}), region);
  } else if (type == kVtkPolygon) {
    mesh.addFlat(points.size(), points, region);
  } else if (type == kVtkQuadraticPolygon) {
    mesh.addFlat(points.size() / 2, points, region);
  } else if (type == kVtkStrip) {
    addStripCell(mesh, points, region);
  } else if (lookUp(kVtkThinCells, type)) {
    ++mesh.surface.ignoredCells;
  } else {
    file.fail(phrase("It has elements of the type %1, which Viscera does not read", type),
              "save the mesh as tetrahedra");
  }
}

std::vector<std::int64_t> wholeNumbers(const std::vector<double>& values) {
  constexpr double kLargestWhole = 9e15;
  std::vector<std::int64_t> numbers;
  numbers.reserve(values.size());
  for (const double value : values) {
    if (!(std::abs(value) < kLargestWhole) || value != std::round(value))
      return {};
    numbers.push_back(static_cast<std::int64_t>(value));
  }
  return numbers;
}

} // namespace viscera::medical_io
