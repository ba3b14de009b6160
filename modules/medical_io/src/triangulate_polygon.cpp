#include "triangulate_polygon.h"

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolygon.h>

#include "quiet_vtk.h"

namespace viscera::medical_io {
namespace {

constexpr std::size_t kLargestEarCut = 2000;

Vec3 normalOf(const Points& points, std::int32_t a, std::int32_t b, std::int32_t c) {
  const Vec3 pa = points.row(a);
  const Vec3 pb = points.row(b);
  const Vec3 pc = points.row(c);
  return (pb - pa).cross(pc - pa);
}

void cutQuadrilateral(std::span<const std::int32_t> q, const Points& points,
                      std::vector<std::array<std::int32_t, 3>>& out) {
  const bool straight = normalOf(points, q[0], q[1], q[2]).dot(normalOf(points, q[0], q[2], q[3])) > 0;
  const bool crossed = normalOf(points, q[1], q[2], q[3]).dot(normalOf(points, q[1], q[3], q[0])) > 0;
  const double firstDiagonal = (points.row(q[0]) - points.row(q[2])).squaredNorm();
  const double secondDiagonal = (points.row(q[1]) - points.row(q[3])).squaredNorm();
  if (straight != crossed ? straight : firstDiagonal <= secondDiagonal) {
    out.push_back({q[0], q[1], q[2]});
    out.push_back({q[0], q[2], q[3]});
  } else {
    out.push_back({q[1], q[2], q[3]});
    out.push_back({q[1], q[3], q[0]});
  }
}

bool cutEars(std::span<const std::int32_t> polygon, const Points& points,
             std::vector<std::array<std::int32_t, 3>>& out) {
  vtkNew<vtkPolygon> cutter;
  const QuietVtk quiet(cutter);
  cutter->GetPoints()->SetDataTypeToDouble();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    cutter->GetPoints()->InsertNextPoint(points.row(polygon[k]).data());
    cutter->GetPointIds()->InsertNextId(static_cast<vtkIdType>(k));
  }
  vtkNew<vtkIdList> ears;
  const bool cut = cutter->Triangulate(ears) != 0;
  if (!cut || static_cast<std::size_t>(ears->GetNumberOfIds()) != 3 * (polygon.size() - 2))
    return false;
  for (vtkIdType i = 0; i < ears->GetNumberOfIds(); i += 3)
    out.push_back({polygon[static_cast<std::size_t>(ears->GetId(i))],
                   polygon[static_cast<std::size_t>(ears->GetId(i + 1))],
                   polygon[static_cast<std::size_t>(ears->GetId(i + 2))]});
  return true;
}

} // namespace

bool triangulatePolygon(std::span<const std::int32_t> polygon, const Points& points,
                        std::vector<std::array<std::int32_t, 3>>& out) {
  if (polygon.size() == 3) {
    out.push_back({polygon[0], polygon[1], polygon[2]});
    return true;
  }
  if (polygon.size() == 4) {
    cutQuadrilateral(polygon, points, out);
    return true;
  }
  if (polygon.size() <= kLargestEarCut && cutEars(polygon, points, out))
    return true;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    out.push_back({polygon[0], polygon[k], polygon[k + 1]});
  return false;
}

} // namespace viscera::medical_io
