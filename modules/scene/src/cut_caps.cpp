#include "viscera/scene/cut_caps.h"

#include <algorithm>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkContourTriangulator.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWeakPointer.h>

namespace viscera::scene {
namespace {

constexpr double kLargestByte = 255;
/// A face is lit evenly: it is a plate to be read, not a shape.
constexpr double kCapAmbient = 0.5;
constexpr double kCapDiffuse = 0.6;

/// Appends the closed lines of a cut; those of a cavity the other way round, so that they bound a hole.
void addLines(const geometry::PlaneCut& cut, bool hole, vtkPoints* points, vtkCellArray* lines) {
  for (std::size_t line = 0; line < cut.lines(); ++line) {
    if (!cut.closed[line])
      continue;
    const std::int32_t first = cut.first[line], end = cut.first[line + 1];
    const vtkIdType begin = points->GetNumberOfPoints();
    for (std::int32_t i = first; i < end; ++i)
      points->InsertNextPoint(cut.points.row(hole ? first + end - 1 - i : i).data());
    const vtkIdType count = end - first;
    lines->InsertNextCell(static_cast<int>(count) + 1);
    for (vtkIdType i = 0; i <= count; ++i)
      lines->InsertCellPoint(begin + i % count);
  }
}

} // namespace

struct CutCaps::Parts {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkUnsignedCharArray> colors;
  vtkNew<vtkFloatArray> normals;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  vtkWeakPointer<vtkRenderer> renderer;

  void clear();
  void add(const Face& face, const Vec3& towards);
};

void CutCaps::Parts::clear() {
  points->Reset();
  triangles->Reset();
  colors->Reset();
  normals->Reset();
}

void CutCaps::Parts::add(const Face& face, const Vec3& towards) {
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  addLines(face.outer, false, corners, lines);
  if (corners->GetNumberOfPoints() == 0)
    return;
  for (const geometry::PlaneCut& cavity : face.cavities)
    addLines(cavity, true, corners, lines);
  vtkNew<vtkPolyData> outline;
  outline->SetPoints(corners);
  outline->SetLines(lines);
  vtkNew<vtkContourTriangulator> triangulator;
  triangulator->SetInputData(outline);
  triangulator->Update();
  vtkPolyData* filled = triangulator->GetOutput();
  const vtkIdType before = points->GetNumberOfPoints();
  points->InsertPoints(before, filled->GetNumberOfPoints(), 0, filled->GetPoints());
  triangles->Append(filled->GetPolys(), before);
  const Vec3 color = kLargestByte * face.color.cwiseMin(1).cwiseMax(0);
  for (vtkIdType i = 0; i < filled->GetNumberOfPoints(); ++i) {
    colors->InsertNextTuple(color.data());
    normals->InsertNextTuple(towards.data());
  }
}

CutCaps::CutCaps() : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  p.points->SetDataTypeToDouble();
  p.colors->SetNumberOfComponents(3);
  p.normals->SetNumberOfComponents(3);
  p.data->SetPoints(p.points);
  p.data->SetPolys(p.triangles);
  p.data->GetPointData()->SetScalars(p.colors);
  p.data->GetPointData()->SetNormals(p.normals);
  p.mapper->SetInputData(p.data);
  p.actor->SetMapper(p.mapper);
  p.actor->PickableOff();
  p.actor->GetProperty()->SetAmbient(kCapAmbient);
  p.actor->GetProperty()->SetDiffuse(kCapDiffuse);
  p.actor->VisibilityOff();
}

CutCaps::~CutCaps() {
  setRenderer(nullptr);
}

void CutCaps::setRenderer(vtkRenderer* renderer) {
  if (parts_->renderer)
    parts_->renderer->RemoveActor(parts_->actor);
  parts_->renderer = renderer;
  if (renderer)
    renderer->AddActor(parts_->actor);
}

void CutCaps::setFaces(const std::vector<Face>& faces, const Vec3& towards) {
  Parts& p = *parts_;
  p.clear();
  for (const Face& face : faces)
    p.add(face, towards);
  p.points->Modified();
  p.triangles->Modified();
  p.colors->Modified();
  p.normals->Modified();
  p.data->Modified();
  p.actor->SetVisibility(p.triangles->GetNumberOfCells() > 0);
}

double CutCaps::areaMm2() const {
  const Parts& p = *parts_;
  double area = 0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < p.triangles->GetNumberOfCells(); ++cell) {
    p.triangles->GetCellAtId(cell, corners);
    const Vec3 a(p.points->GetPoint(corners->GetId(0)));
    for (vtkIdType i = 2; i < corners->GetNumberOfIds(); ++i) {
      const Vec3 b(p.points->GetPoint(corners->GetId(i - 1))), c(p.points->GetPoint(corners->GetId(i)));
      area += (b - a).cross(c - a).norm() / 2;
    }
  }
  return area;
}

} // namespace viscera::scene
