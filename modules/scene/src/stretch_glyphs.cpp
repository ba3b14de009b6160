#include "viscera/scene/stretch_glyphs.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCubeSource.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "unit_ball.h"

namespace viscera::scene {
namespace {

constexpr int kEllipsoidSides = 14;
/// Half the thickness of a cross's bars, of its arms.
constexpr double kBar = 0.07;

vtkSmartPointer<vtkPolyData> cross() {
  vtkNew<vtkAppendPolyData> all;
  for (int axis = 0; axis < 3; ++axis) {
    vtkNew<vtkCubeSource> bar;
    bar->SetXLength(axis == 0 ? 2 : 2 * kBar);
    bar->SetYLength(axis == 1 ? 2 : 2 * kBar);
    bar->SetZLength(axis == 2 ? 2 : 2 * kBar);
    bar->Update();
    all->AddInputData(bar->GetOutput());
  }
  all->Update();
  return all->GetOutput();
}

} // namespace

struct StretchGlyphs::Parts {
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> values;
  vtkNew<vtkFloatArray> stretches;
  vtkNew<vtkFloatArray> turns;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkGlyph3DMapper> mapper;
  vtkNew<vtkActor> actor;
  vtkRenderer* renderer = nullptr;
};

StretchGlyphs::StretchGlyphs() : parts_(std::make_unique<Parts>()) {
  auto& p = *parts_;
  p.points->SetDataTypeToDouble();
  p.values->SetName("values");
  p.stretches->SetName("stretches");
  p.stretches->SetNumberOfComponents(3);
  p.turns->SetName("turns");
  p.turns->SetNumberOfComponents(4);
  p.data->SetPoints(p.points);
  p.data->GetPointData()->SetScalars(p.values);
  p.data->GetPointData()->AddArray(p.stretches);
  p.data->GetPointData()->AddArray(p.turns);
  p.mapper->SetInputData(p.data);
  p.mapper->SetScaling(true);
  p.mapper->SetScaleModeToScaleByVectorComponents();
  p.mapper->SetScaleArray("stretches");
  p.mapper->SetOrient(true);
  p.mapper->SetOrientationModeToQuaternion();
  p.mapper->SetOrientationArray("turns");
  p.mapper->SetScalarModeToUsePointData();
  p.mapper->SetColorModeToMapScalars();
  p.mapper->UseLookupTableScalarRangeOn();
  p.actor->SetMapper(p.mapper);
  p.actor->PickableOff();
  p.actor->GetProperty()->SetAmbient(0.25);
  p.actor->GetProperty()->SetDiffuse(0.85);
  p.actor->GetProperty()->SetSpecular(0.1);
  setShape(Shape::ellipsoids);
  setColors(viridis(), {0, 1});
  setVisible(false);
}

StretchGlyphs::~StretchGlyphs() {
  setRenderer(nullptr);
}

void StretchGlyphs::setRenderer(vtkRenderer* renderer) {
  auto& p = *parts_;
  if (p.renderer)
    p.renderer->RemoveActor(p.actor);
  p.renderer = renderer;
  if (renderer)
    renderer->AddActor(p.actor);
}

void StretchGlyphs::set(const std::vector<StretchGlyph>& glyphs) {
  auto& p = *parts_;
  const auto count = static_cast<vtkIdType>(glyphs.size());
  p.points->SetNumberOfPoints(count);
  p.values->SetNumberOfTuples(count);
  p.stretches->SetNumberOfTuples(count);
  p.turns->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i) {
    const StretchGlyph& glyph = glyphs[static_cast<std::size_t>(i)];
    p.points->SetPoint(i, glyph.position.data());
    p.values->SetValue(i, glyph.value);
    const Eigen::Vector3f stretches = glyph.stretches.cast<float>();
    p.stretches->SetTypedTuple(i, stretches.data());
    const auto turn = glyph.directions.cast<float>();
    const float wxyz[] = {turn.w(), turn.x(), turn.y(), turn.z()};
    p.turns->SetTypedTuple(i, wxyz);
  }
  p.points->Modified();
  p.values->Modified();
  p.stretches->Modified();
  p.turns->Modified();
  p.data->Modified();
  p.mapper->Update(); // The glyph mapper draws nothing when its input has changed since the last update.
}

int StretchGlyphs::count() const {
  return static_cast<int>(parts_->points->GetNumberOfPoints());
}

void StretchGlyphs::setShape(Shape shape) {
  parts_->mapper->SetSourceData(shape == Shape::ellipsoids ? unitBall(kEllipsoidSides) : cross());
  parts_->mapper->Update();
}

void StretchGlyphs::setRadius(double radius) {
  parts_->mapper->SetScaleFactor(radius);
}

void StretchGlyphs::setColors(const ColorMap& map, ValueRange range) {
  parts_->mapper->SetLookupTable(lookupTable(map, range));
}

void StretchGlyphs::setVisible(bool visible) {
  parts_->actor->SetVisibility(visible);
}

bool StretchGlyphs::visible() const {
  return parts_->actor->GetVisibility() != 0;
}

vtkActor* StretchGlyphs::actor() const {
  return parts_->actor;
}

} // namespace viscera::scene
