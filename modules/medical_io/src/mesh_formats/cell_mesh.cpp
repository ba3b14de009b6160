#include "mesh_formats/cell_mesh.h"

#include <algorithm>
#include <array>

#include <Eigen/Geometry>

namespace viscera::medical_io {

std::size_t cornerCountOf(SolidShape shape) {
  constexpr std::array<std::size_t, 4> kCorners = {4, 5, 6, 8};
  return kCorners[static_cast<std::size_t>(shape)];
}

std::span<const FaceCorners> facesOf(SolidShape shape) {
  static constexpr std::array<FaceCorners, 4> kTetrahedron = {
      {{0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {0, 3, 2, -1}}};
  static constexpr std::array<FaceCorners, 5> kPyramid = {
      {{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}};
  static constexpr std::array<FaceCorners, 5> kWedge = {
      {{0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
  static constexpr std::array<FaceCorners, 6> kHexahedron = {
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  switch (shape) {
  case SolidShape::tetrahedron:
    return kTetrahedron;
  case SolidShape::pyramid:
    return kPyramid;
  case SolidShape::wedge:
    return kWedge;
  case SolidShape::hexahedron:
    break;
  }
  return kHexahedron;
}

double sixVolumesBelow(std::span<const Vec3> polygon, const Vec3& origin) {
  const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
    return (polygon[a] - origin).dot((polygon[b] - origin).cross(polygon[c] - origin));
  };
  if (polygon.size() == 3)
    return triangle(0, 1, 2);
  if (polygon.size() == 4)
    return (triangle(0, 1, 2) + triangle(0, 2, 3) + triangle(1, 2, 3) + triangle(1, 3, 0)) / 2;
  return 0;
}

double volumeOf(SolidShape shape, std::span<const std::int64_t> corners,
                const std::vector<double>& coordinates) {
  const auto point = [&](int local) -> Vec3 {
    const auto number = static_cast<std::size_t>(corners[static_cast<std::size_t>(local)]);
    return Eigen::Map<const Vec3>(coordinates.data() + 3 * number);
  };
  double volume = 0;
  for (const FaceCorners& face : facesOf(shape)) {
    std::array<Vec3, 4> points;
    const std::size_t count = face[3] < 0 ? 3 : 4;
    for (std::size_t k = 0; k < count; ++k)
      points[k] = point(face[k]);
    volume += sixVolumesBelow(std::span(points).first(count), point(0)) / 6;
  }
  return volume;
}

void CellMesh::addSolid(SolidShape shape, std::span<const std::int64_t> points, std::int64_t region) {
  const auto own = points.first(cornerCountOf(shape));
  shapes.push_back(shape);
  corners.insert(corners.end(), own.begin(), own.end());
  regions.push_back(region);
  if (points.size() > own.size())
    ++curvedCells;
}

void CellMesh::addFlat(std::size_t cornerCount, std::span<const std::int64_t> points, std::int64_t region) {
  surface.addPolygon(points.first(cornerCount));
  flatRegions.push_back(region);
  if (points.size() > cornerCount)
    ++curvedCells;
}

void addCell(CellMesh& mesh, const CellKind& kind, std::span<const std::int64_t> points,
             std::int64_t region) {
  switch (kind.use) {
  case CellKind::Use::flat:
    mesh.addFlat(kind.corners, points.first(kind.points), region);
    break;
  case CellKind::Use::solid:
    mesh.addSolid(kind.shape, points.first(kind.points), region);
    break;
  case CellKind::Use::ignore:
    ++mesh.surface.ignoredCells;
    break;
  }
}

bool numbersRegions(std::string_view arrayName) {
  constexpr std::array<std::string_view, 11> kWords = {"region", "material",  "tag",   "physical",
                                                       "label",  "medit",     "group", "cellentityids",
                                                       "domain", "attribute", "tissue"};
  const std::string name = lowered(arrayName);
  return std::any_of(kWords.begin(), kWords.end(),
                     [&](std::string_view word) { return name.find(word) != name.npos; });
}

} // namespace viscera::medical_io
