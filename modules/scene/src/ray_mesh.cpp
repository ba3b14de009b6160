#include "ray_mesh.h"

#include <cmath>
#include <mutex>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDoubleArray.h>
#include <vtkMapper.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace viscera::scene {
namespace {

/// Half a millisecond of work: for less, waking another thread does not pay.
constexpr Eigen::Index kTrianglesPerBlock = 65536;

/// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997,
/// DOI 10.1080/10867651.1997.10487468.
bool meets(const Ray& ray, const MeshView& mesh, Eigen::Index triangle, double farthest, RayHit& hit) {
  // o + t d = a + u ab + v ac by Cramer's rule, with the determinant ab . (d x ac): u = (o - a) . (d x ac),
  // v = d . ((o - a) x ab) and t = ac . ((o - a) x ab), each over it.
  const Vec3 a = mesh.point(triangle, 0);
  const Vec3 ab = mesh.point(triangle, 1) - a, ac = mesh.point(triangle, 2) - a;
  const Vec3 across = ray.direction.cross(ac);
  const double determinant = ab.dot(across);
  if (determinant == 0)
    return false;
  const Vec3 fromA = ray.origin - a;
  const double u = fromA.dot(across) / determinant;
  if (u < 0 || u > 1)
    return false;
  const Vec3 along = fromA.cross(ab);
  const double v = ray.direction.dot(along) / determinant;
  if (v < 0 || u + v > 1)
    return false;
  const double distance = ac.dot(along) / determinant;
  if (!(distance > 0) || !(distance < farthest))
    return false;
  const Vec3 point = ray.origin + distance * ray.direction;
  for (const auto& clip : mesh.clips)
    if (!clip.holds(point))
      return false;
  hit = {triangle, distance, u, v};
  return true;
}

} // namespace

std::optional<RayHit> nearestHit(const Ray& ray, const MeshView& mesh, double farthest, Threads threads) {
  std::optional<RayHit> nearest;
  std::mutex mutex;
  parallelRanges(mesh.triangleCount, kTrianglesPerBlock, threads, [&](Eigen::Index begin, Eigen::Index end) {
    RayHit best;
    double limit = farthest;
    for (Eigen::Index t = begin; t < end; ++t)
      if (meets(ray, mesh, t, limit, best))
        limit = best.distance;
    if (best.triangle < 0)
      return;
    const std::scoped_lock lock(mutex);
    if (!nearest || best.distance < nearest->distance ||
        (best.distance == nearest->distance && best.triangle < nearest->triangle))
      nearest = best;
  });
  return nearest;
}

ActorMesh::ActorMesh(vtkActor* actor) {
  auto* data = vtkPolyData::SafeDownCast(actor->GetMapper() ? actor->GetMapper()->GetInput() : nullptr);
  if (!data || !data->GetPoints() || !data->GetPolys())
    return;
  if (auto* doubles = vtkDoubleArray::FastDownCast(data->GetPoints()->GetData())) {
    view_.points = doubles->GetPointer(0);
  } else {
    points_.resize(std::size_t(3 * data->GetNumberOfPoints()));
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
      data->GetPoint(i, &points_[std::size_t(3 * i)]);
    view_.points = points_.data();
  }
  auto* polys = data->GetPolys();
  if (!polys->IsStorage64Bit() && polys->IsHomogeneous() == 3) {
    view_.triangles = polys->GetConnectivityArray32()->GetPointer(0);
    view_.triangleCount = polys->GetNumberOfCells();
  } else {
    auto cell = vtk::TakeSmartPointer(polys->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cell->GetCurrentCell(count, ids);
      for (vtkIdType k = 2; k < count; ++k)
        for (const vtkIdType id : {ids[0], ids[k - 1], ids[k]})
          triangles_.push_back(static_cast<std::int32_t>(id));
    }
    view_.triangles = triangles_.data();
    view_.triangleCount = static_cast<Eigen::Index>(triangles_.size() / 3);
  }
  if (auto* planes = actor->GetMapper()->GetClippingPlanes())
    for (int i = 0; i < planes->GetNumberOfItems(); ++i) {
      const Vec3 normal(planes->GetItem(i)->GetNormal());
      view_.clips.push_back({normal, normal.dot(Vec3(planes->GetItem(i)->GetOrigin()))});
    }
}

} // namespace viscera::scene
