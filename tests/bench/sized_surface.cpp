#include "sized_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <queue>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkSmartPointer.h>

#include "viscera/geometry/surface_check.h"

namespace viscera::bench {
namespace {

/// What is left for the halving of edges to add.
constexpr double kDecimatedShare = 0.97;

vtkSmartPointer<vtkPolyData> asPolyData(const geometry::TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
    points->InsertNextPoint(mesh.points(i, 0), mesh.points(i, 1), mesh.points(i, 2));
  vtkNew<vtkCellArray> triangles;
  for (Eigen::Index i = 0; i < mesh.triangles.rows(); ++i)
    triangles->InsertNextCell({mesh.triangles(i, 0), mesh.triangles(i, 1), mesh.triangles(i, 2)});
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

geometry::TriangleMesh asMesh(vtkPolyData* data) {
  geometry::TriangleMesh mesh;
  mesh.points.resize(data->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    data->GetPoint(i, mesh.points.row(i).data());
  mesh.triangles.resize(data->GetNumberOfPolys(), 3);
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < data->GetNumberOfPolys(); ++i) {
    data->GetPolys()->GetCellAtId(i, corners);
    for (int corner = 0; corner < 3; ++corner)
      mesh.triangles(i, corner) = static_cast<int>(corners->GetId(corner));
  }
  return mesh;
}

geometry::TriangleMesh decimated(const geometry::TriangleMesh& mesh, double toVertices) {
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(asPolyData(mesh));
  decimation->SetTargetReduction(1 - toVertices / static_cast<double>(mesh.points.rows()));
  decimation->Update();
  return asMesh(decimation->GetOutput());
}

/// Halves edges of a closed surface, the longest first; each adds a vertex and two triangles.
class EdgeHalver {
public:
  explicit EdgeHalver(const geometry::TriangleMesh& mesh) {
    for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
      points_.emplace_back(mesh.points.row(i).transpose());
    triangles_.resize(static_cast<std::size_t>(mesh.triangles.rows()));
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      const auto row = mesh.triangles.row(static_cast<Eigen::Index>(i));
      set(i, {row[0], row[1], row[2]});
    }
  }

  void halveUntil(std::size_t vertices) {
    while (points_.size() < vertices) {
      const auto [length, a, b] = longest_.top();
      longest_.pop();
      if (triangleOf_.count({a, b}) > 0)
        halve(a, b);
    }
  }

  geometry::TriangleMesh mesh() const {
    geometry::TriangleMesh mesh;
    mesh.points.resize(static_cast<Eigen::Index>(points_.size()), 3);
    for (std::size_t i = 0; i < points_.size(); ++i)
      mesh.points.row(static_cast<Eigen::Index>(i)) = points_[i].transpose();
    mesh.triangles.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      mesh.triangles.row(static_cast<Eigen::Index>(i)) << triangles_[i][0], triangles_[i][1],
          triangles_[i][2];
    return mesh;
  }

private:
  using Triangle = std::array<int, 3>;

  void set(std::size_t triangle, const Triangle& corners) {
    triangles_[triangle] = corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = corners[i], to = corners[(i + 1) % 3];
      triangleOf_[{from, to}] = triangle;
      if (from < to)
        longest_.emplace(
            (points_[static_cast<std::size_t>(from)] - points_[static_cast<std::size_t>(to)]).norm(), from,
            to);
    }
  }

  /// The triangle on the left of the edge becomes two.
  void halveSide(int from, int to, int middle) {
    const auto found = triangleOf_.find({from, to});
    const std::size_t triangle = found->second;
    triangleOf_.erase(found);
    const Triangle& old = triangles_[triangle];
    const int third = old[0] + old[1] + old[2] - from - to;
    triangles_.push_back({});
    set(triangle, {from, middle, third});
    set(triangles_.size() - 1, {middle, to, third});
  }

  void halve(int a, int b) {
    const int middle = static_cast<int>(points_.size());
    points_.emplace_back((points_[static_cast<std::size_t>(a)] + points_[static_cast<std::size_t>(b)]) / 2);
    halveSide(a, b, middle);
    halveSide(b, a, middle);
  }

  std::vector<Vec3> points_;
  std::vector<Triangle> triangles_;
  std::map<std::pair<int, int>, std::size_t> triangleOf_; ///< By directed edge.
  std::priority_queue<std::tuple<double, int, int>> longest_;
};

/// Bits of a coordinate in the order below.
constexpr int kBits = 10;

/// Where a point comes along a Z-shaped curve through the box.
std::uint32_t placeOnCurve(const Vec3& inBox) {
  std::uint32_t place = 0;
  for (int bit = kBits - 1; bit >= 0; --bit)
    for (int axis = 0; axis < 3; ++axis)
      place = place << 1 | (static_cast<std::uint32_t>(inBox[axis] * ((1 << kBits) - 1)) >> bit & 1);
  return place;
}

/// Neighbours in space become neighbours in memory, as contour filters leave them.
geometry::TriangleMesh inOrder(const geometry::TriangleMesh& mesh) {
  const Bounds box = boundsOf(mesh.points);
  std::vector<std::pair<std::uint32_t, int>> order;
  for (int i = 0; i < static_cast<int>(mesh.points.rows()); ++i)
    order.emplace_back(
        placeOnCurve((mesh.points.row(i).transpose() - box.low).cwiseQuotient(box.high - box.low)), i);
  std::sort(order.begin(), order.end());
  geometry::TriangleMesh sorted = mesh;
  std::vector<int> placeOf(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    sorted.points.row(static_cast<Eigen::Index>(i)) = mesh.points.row(order[i].second);
    placeOf[static_cast<std::size_t>(order[i].second)] = static_cast<int>(i);
  }
  std::vector<std::array<int, 3>> triangles;
  for (const auto& row : mesh.triangles.rowwise())
    triangles.push_back({placeOf[static_cast<std::size_t>(row[0])], placeOf[static_cast<std::size_t>(row[1])],
                         placeOf[static_cast<std::size_t>(row[2])]});
  std::sort(triangles.begin(), triangles.end());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    sorted.triangles.row(static_cast<Eigen::Index>(i)) << triangles[i][0], triangles[i][1], triangles[i][2];
  return sorted;
}

} // namespace

geometry::TriangleMesh withVertices(const geometry::TriangleMesh& mesh, Eigen::Index vertices) {
  geometry::TriangleMesh start = mesh;
  if (mesh.points.rows() > vertices)
    start = decimated(mesh, kDecimatedShare * static_cast<double>(vertices));
  if (!geometry::checkSurface(start).closed() || start.points.rows() > vertices)
    throw std::runtime_error("the decimation did not leave a closed surface of the size wanted");
  EdgeHalver halver(start);
  halver.halveUntil(static_cast<std::size_t>(vertices));
  return inOrder(halver.mesh());
}

} // namespace viscera::bench
