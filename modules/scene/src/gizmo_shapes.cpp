#include "gizmo_shapes.h"

#include <vtkAppendPolyData.h>
#include <vtkCubeSource.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkRegularPolygonSource.h>

#include "viscera/core/arrays.h"

namespace viscera::scene {
namespace {

constexpr int kSides = 96;
/// The arms begin beside the cube in the middle.
constexpr double kGap = 12;

vtkSmartPointer<vtkPolyData> cube(const Vec3& at) {
  vtkNew<vtkCubeSource> source;
  source->SetXLength(2 * kGizmoCube);
  source->SetYLength(2 * kGizmoCube);
  source->SetZLength(2 * kGizmoCube);
  source->SetCenter(at.x(), at.y(), at.z());
  source->Update();
  return source->GetOutput();
}

} // namespace

vtkSmartPointer<vtkPolyData> gizmoRing(int axis) {
  const Vec3 normal = Vec3::Unit(axis);
  vtkNew<vtkRegularPolygonSource> source;
  source->SetNumberOfSides(kSides);
  source->SetRadius(kGizmoRadius);
  source->SetNormal(normal.x(), normal.y(), normal.z());
  source->GeneratePolygonOff();
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> gizmoArm(int axis) {
  const Vec3 end = kGizmoArm * Vec3::Unit(axis), begin = kGap * Vec3::Unit(axis);
  vtkNew<vtkLineSource> line;
  line->SetPoint1(begin.x(), begin.y(), begin.z());
  line->SetPoint2(end.x(), end.y(), end.z());
  vtkNew<vtkAppendPolyData> both;
  line->Update();
  both->AddInputData(line->GetOutput());
  both->AddInputData(cube(end));
  both->Update();
  return both->GetOutput();
}

vtkSmartPointer<vtkPolyData> gizmoMiddle() {
  return cube(Vec3::Zero());
}

} // namespace viscera::scene
