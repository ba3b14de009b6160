#include "viscera/scene/valve_glyphs.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

#include "blended_actor.h"

namespace viscera::scene {
namespace {

const Vec3 kLeafletColor(0.95, 0.90, 0.78);
const Vec3 kRimColor(0.86, 0.76, 0.56);
constexpr double kRimRadius = 0.9; ///< mm
constexpr double kEdgeRadius = 0.4;
/// Tendons: paler than the leaflets.
const Vec3 kChordColor(0.86, 0.87, 0.84);
constexpr double kChordRadius = 0.4;
constexpr int kRingSides = 20;
constexpr double kNeverSharp = 180; ///< Degrees.
constexpr double kShortest = 0.5;   ///< Of arrows, mm.
constexpr double kTipWidth = 2.1;   ///< Of the shaft's.
constexpr double kTipLength = 3.2;  ///< Of the shaft's radius, but of no more than the part below.
constexpr double kLongestTip = 0.45;

/// A surface that is filled anew and shaded smoothly where it is not sharper than `sharp` degrees.
class Solid {
public:
  explicit Solid(double sharp) {
    data_->SetPoints(points_);
    normals_->SetInputData(data_);
    normals_->SetFeatureAngle(sharp);
    normals_->SetSplitting(sharp < kNeverSharp);
    normals_->ConsistencyOff();
    mapper_->SetInputConnection(normals_->GetOutputPort());
    mapper_->SetScalarModeToUsePointData();
    actor_->SetMapper(mapper_);
    actor_->PickableOff();
    actor_->GetProperty()->SetAmbient(0.3);
    actor_->GetProperty()->SetDiffuse(0.75);
    actor_->GetProperty()->SetSpecular(0.15);
    actor_->GetProperty()->SetSpecularPower(20);
  }

  vtkActor* actor() const { return actor_; }

  void clear() {
    points_->Reset();
    cells_ = vtkSmartPointer<vtkCellArray>::New();
    colors_ = nullptr;
  }
  vtkIdType add(const Vec3& point) { return points_->InsertNextPoint(point.data()); }
  void paint(const Vec3& color) {
    if (!colors_) {
      colors_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
      colors_->SetNumberOfComponents(3);
    }
    const Vec3 scaled = 255 * color;
    while (colors_->GetNumberOfTuples() < points_->GetNumberOfPoints())
      colors_->InsertNextTuple(scaled.data());
  }
  void triangle(vtkIdType a, vtkIdType b, vtkIdType c) {
    const std::array<vtkIdType, 3> ids = {a, b, c};
    cells_->InsertNextCell(3, ids.data());
  }
  void finish() {
    data_->SetPolys(cells_);
    data_->GetPointData()->SetScalars(colors_);
    points_->Modified();
    data_->Modified();
    actor_->SetVisibility(cells_->GetNumberOfCells() > 0);
  }

private:
  vtkNew<vtkPoints> points_;
  vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
  vtkSmartPointer<vtkUnsignedCharArray> colors_;
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkPolyDataNormals> normals_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

/// Lines as thick as a cord.
class Cords {
public:
  Cords(double radius, const Vec3& color) {
    data_->SetPoints(points_);
    tubes_->SetInputData(data_);
    tubes_->SetRadius(radius);
    tubes_->SetNumberOfSides(8);
    tubes_->CappingOn();
    mapper_->SetInputConnection(tubes_->GetOutputPort());
    actor_->SetMapper(mapper_);
    actor_->PickableOff();
    setColor(actor_, color);
    actor_->GetProperty()->SetAmbient(0.25);
  }

  vtkActor* actor() const { return actor_; }

  void clear() {
    points_->Reset();
    cells_ = vtkSmartPointer<vtkCellArray>::New();
  }
  void add(const Points& line) {
    cells_->InsertNextCell(static_cast<int>(line.rows()));
    for (Eigen::Index i = 0; i < line.rows(); ++i)
      cells_->InsertCellPoint(points_->InsertNextPoint(line(i, 0), line(i, 1), line(i, 2)));
  }
  void finish() {
    data_->SetLines(cells_);
    points_->Modified();
    data_->Modified();
    actor_->SetVisibility(count() > 0);
  }
  int count() const { return static_cast<int>(cells_->GetNumberOfCells()); }

private:
  vtkNew<vtkPoints> points_;
  vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkTubeFilter> tubes_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

/// A shaft with a tip, turned on a lathe.
void addArrow(Solid& solid, const FlowArrow& arrow) {
  const Vec3 along = arrow.head - arrow.tail;
  const double length = along.norm();
  const Vec3 axis = along / length;
  const Vec3 across = axis.unitOrthogonal(), other = axis.cross(across);
  const double neck = length - std::min(kTipLength * arrow.radius, kLongestTip * length);
  const std::array<std::pair<double, double>, 5> profile = {
      {{0, 0}, {0, arrow.radius}, {neck, arrow.radius}, {neck, kTipWidth * arrow.radius}, {length, 0}}};
  vtkIdType before = 0;
  for (std::size_t ring = 0; ring < profile.size(); ++ring) {
    vtkIdType first = 0;
    for (int side = 0; side < kRingSides; ++side) {
      const double angle = 2 * std::numbers::pi * side / kRingSides;
      const vtkIdType id =
          solid.add(arrow.tail + profile[ring].first * axis +
                    profile[ring].second * (std::cos(angle) * across + std::sin(angle) * other));
      if (side == 0)
        first = id;
    }
    for (int side = 0; ring > 0 && side < kRingSides; ++side) {
      const int next = (side + 1) % kRingSides;
      solid.triangle(before + side, before + next, first + next);
      solid.triangle(before + side, first + next, first + side);
    }
    before = first;
  }
  solid.paint(arrow.color);
}

} // namespace

struct ValveGlyphs::Parts {
  Solid leaflets{kNeverSharp};
  Solid flow{40};
  Cords rims{kRimRadius, kRimColor}, edges{kEdgeRadius, kRimColor}, chords{kChordRadius, kChordColor};
  vtkRenderer* renderer = nullptr;
  int valves = 0, arrows = 0;

  std::array<vtkActor*, 5> actors() const {
    return {leaflets.actor(), rims.actor(), edges.actor(), chords.actor(), flow.actor()};
  }
};

ValveGlyphs::ValveGlyphs() : parts_(std::make_unique<Parts>()) {
  setColor(parts_->leaflets.actor(), kLeafletColor);
  for (vtkActor* actor : parts_->actors())
    actor->SetVisibility(false);
}

ValveGlyphs::~ValveGlyphs() {
  setRenderer(nullptr);
}

void ValveGlyphs::setRenderer(vtkRenderer* renderer) {
  for (vtkActor* actor : parts_->actors()) {
    if (parts_->renderer)
      parts_->renderer->RemoveActor(actor);
    if (renderer)
      renderer->AddActor(actor);
  }
  parts_->renderer = renderer;
}

void ValveGlyphs::set(const std::vector<ValveGlyph>& valves, const std::vector<FlowArrow>& arrows) {
  Parts& p = *parts_;
  p.leaflets.clear();
  p.rims.clear();
  p.edges.clear();
  p.chords.clear();
  p.flow.clear();
  for (const ValveGlyph& valve : valves) {
    vtkIdType first = 0;
    for (Eigen::Index i = 0; i < valve.points.rows(); ++i)
      if (const vtkIdType id = p.leaflets.add(valve.points.row(i).transpose()); i == 0)
        first = id;
    for (const auto& t : valve.triangles.rowwise())
      p.leaflets.triangle(first + t[0], first + t[1], first + t[2]);
    for (const Points& line : valve.rims)
      p.rims.add(line);
    for (const Points& line : valve.edges)
      p.edges.add(line);
    for (const Points& line : valve.chords)
      p.chords.add(line);
  }
  p.arrows = 0;
  for (const FlowArrow& arrow : arrows)
    if ((arrow.head - arrow.tail).norm() > kShortest) {
      addArrow(p.flow, arrow);
      ++p.arrows;
    }
  p.valves = static_cast<int>(valves.size());
  p.leaflets.finish();
  p.rims.finish();
  p.edges.finish();
  p.chords.finish();
  p.flow.finish();
}

int ValveGlyphs::valves() const {
  return parts_->valves;
}

int ValveGlyphs::arrows() const {
  return parts_->arrows;
}

int ValveGlyphs::chords() const {
  return parts_->chords.count();
}

} // namespace viscera::scene
