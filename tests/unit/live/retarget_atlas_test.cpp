#include <array>
#include <filesystem>
#include <memory>

#include <gtest/gtest.h>
#include <vtkCleanPolyData.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageConstantPad.h>
#include <vtkImageData.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkImageThreshold.h>
#include <vtkNew.h>
#include <vtkNrrdReader.h>
#include <vtkPolyData.h>
#include <vtkPolyDataConnectivityFilter.h>

#include "build_paths.h"
#include "self_intersections.h"
#include "sequence_scene.h"
#include "viscera/geometry/convex_hull.h"
#include "viscera/live/retarget.h"

/// A real stomach: that of the abdominal atlas, collapsed, folded, with its whole duodenum.
namespace viscera::live {
namespace {

constexpr int kStomachAndDuodenum = 13;

/// The smoothed surface of one label.
geometry::TriangleMesh surfaceOfLabel(const std::filesystem::path& file, int label) {
  vtkNew<vtkNrrdReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  std::array<int, 6> extent{};
  reader->GetOutput()->GetExtent(extent.data());
  vtkNew<vtkImageThreshold> mask;
  mask->SetInputConnection(reader->GetOutputPort());
  mask->ThresholdBetween(label, label);
  mask->SetInValue(100);
  mask->SetOutValue(0);
  mask->SetOutputScalarTypeToFloat();
  vtkNew<vtkImageConstantPad> pad;
  pad->SetInputConnection(mask->GetOutputPort());
  pad->SetOutputWholeExtent(extent[0] - 3, extent[1] + 3, extent[2] - 3, extent[3] + 3, extent[4] - 3,
                            extent[5] + 3);
  pad->SetConstant(0);
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputConnection(pad->GetOutputPort());
  smooth->SetStandardDeviations(1.2, 1.2, 0.75);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputConnection(smooth->GetOutputPort());
  contour->SetValue(0, 50);
  contour->ComputeNormalsOff();
  vtkNew<vtkPolyDataConnectivityFilter> largest;
  largest->SetInputConnection(contour->GetOutputPort());
  largest->SetExtractionModeToLargestRegion();
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(largest->GetOutputPort());
  clean->Update();
  vtkPolyData* data = clean->GetOutput();
  geometry::TriangleMesh mesh;
  mesh.points.resize(data->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    data->GetPoint(i, mesh.points.row(i).data());
  mesh.triangles.resize(data->GetNumberOfCells(), 3);
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < data->GetNumberOfCells(); ++t) {
    data->GetCellPoints(t, corners);
    for (int k = 0; k < 3; ++k)
      mesh.triangles(t, k) = static_cast<std::int32_t>(corners->GetId(k));
  }
  return mesh;
}

TEST(RetargetAtlas, peristalsisRunsDownARealStomachAndKeepsItsVolume) {
  const std::filesystem::path file = std::filesystem::path(VISCERA_SHARED_ORGANS) / "abdomen_seg.nrrd";
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << "there is no " << file;
  const document::Organ organ = document::makeOrgan("stomach", surfaceOfLabel(file, kStomachAndDuodenum));
  ASSERT_TRUE(organ.closed());
  const int atRest = tests::selfIntersections(*organ.mesh);
  Progress progress;
  const RetargetedSequence fitted = retargetSequence("peristalsis", organ, {}, progress);
  EXPECT_FALSE(fitted.warnings.empty()) << "the atlas is not life-sized, which has to be said";
  coordinates::HandleSet handles;
  handles.positions = fitted.sequence->restHandles();
  EXPECT_TRUE(geometry::ConvexHull(handles.positions).outside(organ.mesh->points).empty());
  std::shared_ptr<const coordinates::Binding> binding;
  for (const auto& system : coordinates::builtInSystems())
    if (system->id() == fitted.system.id)
      binding = deformation::bindOrgan(*system, handles, organ.mesh->points, {fitted.system.parameters, {}},
                                       progress);
  // The fundus lies to the patient's left of the pylorus, as in people.
  EXPECT_GT(fitted.landmarks.find("fundus")->position.x(), fitted.landmarks.find("pylorus")->position.x());
  double moved = 0;
  constexpr int kFrames = 20;
  for (int frame = 0; frame < kFrames; ++frame) {
    Points pose, points;
    fitted.sequence->poseAt(frame, 3, pose);
    binding->deform(pose, points);
    EXPECT_NEAR(geometry::volume(points, organ.mesh->triangles), organ.restVolumeMm3,
                1e-6 * organ.restVolumeMm3);
    EXPECT_EQ(tests::selfIntersections({points, organ.mesh->triangles, {}}), atRest)
        << "after " << frame << " s";
    moved = std::max(moved, (points - organ.mesh->points).rowwise().norm().maxCoeff());
  }
  EXPECT_GT(moved, 4 * fitted.scale) << "the waves are seen";
}

} // namespace
} // namespace viscera::live
