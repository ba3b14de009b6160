#include <vector>

#include <benchmark/benchmark.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkMeanValueCoordinatesInterpolator.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include "bench_scenes.h"
#include "viscera/core/parallel.h"
#include "viscera/geometry/convex_hull.h"

/// VTK's mean value coordinates of the same vertices as in coordinates_bench.cpp, in the same run: the times
/// of both can then be set in relation.
namespace viscera::bench {
namespace {

/// 30 handles on an ellipsoid around the mesh: all of them are corners of their hull, the cage.
Points ellipsoidAround(const geometry::TriangleMesh& mesh, int count) {
  const Bounds box = boundsOf(mesh.points);
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  Points handles(count, 3);
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z);
    const Vec3 unit(r * std::cos(golden * i), r * std::sin(golden * i), z);
    handles.row(i) = (box.center() + 1.4 * unit.cwiseProduct(box.high - box.low)).transpose();
  }
  return handles;
}

/// Argument: threads. VTK's function is static, so the vertices are dealt out as our own are.
void bindVtkMeanValue(benchmark::State& state) {
  const geometry::TriangleMesh mesh = bunnyOrBlob();
  const Points handles = ellipsoidAround(mesh, 30);
  const Triangles cage = geometry::ConvexHull(handles).triangles();
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  for (Eigen::Index i = 0; i < handles.rows(); ++i)
    corners->InsertNextPoint(handles(i, 0), handles(i, 1), handles(i, 2));
  std::vector<vtkIdType> ids(cage.data(), cage.data() + cage.size());

  std::vector<double> weights(static_cast<std::size_t>(mesh.points.rows() * handles.rows()));
  for (auto _ : state)
    parallelRanges(mesh.points.rows(), 512, {static_cast<int>(state.range(0))},
                   [&](Eigen::Index begin, Eigen::Index end) {
                     vtkNew<vtkIdList> triangles;
                     triangles->SetNumberOfIds(static_cast<vtkIdType>(ids.size()));
                     std::copy(ids.begin(), ids.end(), triangles->GetPointer(0));
                     for (Eigen::Index i = begin; i < end; ++i)
                       vtkMeanValueCoordinatesInterpolator::ComputeInterpolationWeights(
                           mesh.points.data() + 3 * i, corners, triangles,
                           weights.data() + i * handles.rows());
                   });
  state.counters["per_vertex_handle"] =
      benchmark::Counter(static_cast<double>(mesh.points.rows() * handles.rows()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(bindVtkMeanValue)->Arg(1)->Arg(2)->ArgName("threads")->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace viscera::bench
