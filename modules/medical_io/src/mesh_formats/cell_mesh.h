#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "file_bytes.h"
#include "raw_surface.h"
#include "surface_parts.h"
#include "viscera/deformation/witness_mesh.h"

namespace viscera::medical_io {

/// A cell with a volume. Its corners have VTK's and gmsh's order: the base first, then what is above it.
enum class SolidShape : std::uint8_t { tetrahedron, pyramid, wedge, hexahedron };

std::size_t cornerCountOf(SolidShape shape);

/// The corners of a face by their places in the cell; the last one is -1 for a triangle. A cell that stands
/// on its first face has its faces outward.
using FaceCorners = std::array<int, 4>;
std::span<const FaceCorners> facesOf(SolidShape shape);

/// Six times the volume below a triangle or quadrilateral, seen from `origin`. The latter counts by both of
/// its divisions, so that neighbours agree.
double sixVolumesBelow(std::span<const Vec3> polygon, const Vec3& origin);
/// The volume of a cell, whose corners are numbers of points in `coordinates`; negative when it is turned
/// inside out.
double volumeOf(SolidShape shape, std::span<const std::int64_t> corners,
                const std::vector<double>& coordinates);

/// A mesh of cells as a file holds it, unchecked.
struct CellMesh {
  RawSurface surface; ///< The points of all cells, name, axes and warnings; its polygons are the flat cells.
  std::vector<SolidShape> shapes;                  ///< One for each cell with a volume.
  std::vector<std::int64_t> corners;               ///< The point numbers of those, from 0.
  std::vector<std::int64_t> regions;               ///< One for each of those.
  std::vector<std::int64_t> flatRegions;           ///< One for each polygon.
  std::map<std::int64_t, std::string> regionNames; ///< Of regions that have one.
  std::uint64_t curvedCells = 0;                   ///< Cells of higher order, of which the corners are kept.

  /// Adds a cell of which `points` has the corners first. It has as many points as `shape` corners, or more.
  void addSolid(SolidShape shape, std::span<const std::int64_t> points, std::int64_t region);
  /// Adds a polygon, of which the first `corners` points are the corners.
  void addFlat(std::size_t corners, std::span<const std::int64_t> points, std::int64_t region);
};

/// A kind of cell of a file format: what to do with it.
struct CellKind {
  enum class Use : std::uint8_t { ignore, flat, solid };
  Use use = Use::ignore;
  SolidShape shape = SolidShape::tetrahedron; ///< Of a solid.
  std::size_t points = 0;                     ///< Corners and others.
  std::size_t corners = 0;                    ///< Of a flat cell.
};

/// Adds a cell of that kind; lines and points are only counted. `points` is at least as long as `kind` says.
void addCell(CellMesh& mesh, const CellKind& kind, std::span<const std::int64_t> points, std::int64_t region);

/// Whether the name of an array of values at the cells says that they number regions: "Material",
/// "gmsh:physical".
bool numbersRegions(std::string_view arrayName);

/// The surface around all cells: the outer one and, turned inward, those of cavities, so that its volume is
/// that of the cells. The flat cells where no cell has a volume. Equal points are merged before, and cells of
/// equal corners are taken once. Warns of regions, cavities, and cells that were left out. Throws `DataError`
/// that names `file` when a cell refers to a point that is not there. O(n log n).
RawSurface boundaryOf(CellMesh&& mesh, const FileBytes& file);

/// The same as several organs: the outer surface first, then each cavity, which faces outward. Cavities below
/// a ten thousandth of the outer volume are left out with a warning.
std::vector<RawOrgan> boundaryOrgansOf(CellMesh&& mesh, const FileBytes& file);

/// The cells as tetrahedra, mm in LPS: the corners inside are witness points, those on the surface or on a
/// cavity's wall close the solid. None when no corner is inside. Throws as `boundaryOf`. O(n log n).
std::optional<deformation::WitnessMesh> witnessMeshOf(CellMesh&& mesh, const FileBytes& file);

/// A reader of surfaces from a reader of cells.
template <CellMesh (*readCells)(const FileBytes&)>
RawSurface readBoundary(const FileBytes& file) {
  return boundaryOf(readCells(file), file);
}
template <CellMesh (*readCells)(const FileBytes&)>
std::vector<RawOrgan> readBoundaryOrgans(const FileBytes& file) {
  return boundaryOrgansOf(readCells(file), file);
}

/// The surface of a legacy VTK file; of an unstructured grid the outer one and its cavities.
std::vector<RawOrgan> readLegacyVtkOrgans(const FileBytes& file);
/// The cells of a legacy VTK file; none of one that holds no unstructured grid.
CellMesh readLegacyVtkCells(const FileBytes& file);
/// VTK XML unstructured grids.
CellMesh readVtuCells(const FileBytes& file);
/// gmsh's MSH, versions 2 and 4, text and binary.
CellMesh readGmshCells(const FileBytes& file);
/// medit's and Inria's MESH, text and binary.
CellMesh readMeditCells(const FileBytes& file);
/// openCARP: elements or points, with the other file beside it.
CellMesh readOpenCarpCells(const FileBytes& file);

} // namespace viscera::medical_io
