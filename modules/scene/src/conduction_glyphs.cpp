#include "viscera/scene/conduction_glyphs.h"

#include <utility>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

namespace viscera::scene {
namespace {

/// Atlases paint the conduction system so; excited, it is told from muscle, blood and valves.
const Vec3 kResting(0.80, 0.66, 0.22);
const Vec3 kExcited(1.00, 1.00, 0.55);
constexpr const char* kTubeRadii = "radii";
constexpr const char* kColors = "colors";
constexpr int kSides = 8;
constexpr double kAmbient = 0.45;

} // namespace

struct ConductionGlyphs::Parts {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkTubeFilter> tubes;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  vtkRenderer* renderer = nullptr;
};

ConductionGlyphs::ConductionGlyphs() : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  p.tubes->SetInputData(p.data);
  p.tubes->SetVaryRadiusToVaryRadiusByAbsoluteScalar();
  p.tubes->SetNumberOfSides(kSides);
  p.tubes->CappingOn();
  p.mapper->SetInputConnection(p.tubes->GetOutputPort());
  p.mapper->SetScalarModeToUsePointFieldData();
  p.mapper->SelectColorArray(kColors);
  p.actor->SetMapper(p.mapper);
  p.actor->PickableOff();
  p.actor->GetProperty()->SetAmbient(kAmbient);
  p.actor->SetVisibility(false);
}

ConductionGlyphs::~ConductionGlyphs() {
  setRenderer(nullptr);
}

void ConductionGlyphs::setRenderer(vtkRenderer* renderer) {
  Parts& p = *parts_;
  if (p.renderer)
    p.renderer->RemoveActor(p.actor);
  if (renderer)
    renderer->AddActor(p.actor);
  p.renderer = renderer;
}

void ConductionGlyphs::set(std::vector<ConductionLine> lines) {
  lines_ = std::move(lines);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkDoubleArray> radii;
  vtkNew<vtkUnsignedCharArray> colors;
  radii->SetName(kTubeRadii);
  colors->SetName(kColors);
  colors->SetNumberOfComponents(3);
  for (const ConductionLine& line : lines_) {
    cells->InsertNextCell(static_cast<int>(line.points.rows()));
    for (Eigen::Index i = 0; i < line.points.rows(); ++i) {
      cells->InsertCellPoint(
          points->InsertNextPoint(line.points(i, 0), line.points(i, 1), line.points(i, 2)));
      radii->InsertNextValue(line.radiusMm);
      const Vec3 color = 255 * (kResting + line.lit[i] * (kExcited - kResting));
      colors->InsertNextTuple(color.data());
    }
  }
  Parts& p = *parts_;
  p.data->SetPoints(points);
  p.data->SetLines(cells);
  p.data->GetPointData()->SetScalars(radii);
  p.data->GetPointData()->AddArray(colors);
  p.data->Modified();
  p.actor->SetVisibility(!lines_.empty());
}

} // namespace viscera::scene
