#include "viscera/scene/tissue_actor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTypeInt32Array.h>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

#include "before_render.h"
#include "blended_actor.h"
#include "borrowed_array.h"
#include "ray_mesh.h"
#include "tetra_surfaces.h"

namespace viscera::scene {
namespace {

/// Colours that mean numbers are lit evenly, so that they can be read off the legend.
constexpr double kTissueAmbient = 0.45;
constexpr double kTissueDiffuse = 0.65;
constexpr double kTissueGhostOpacity = 0.13;
constexpr const char* kValues = "values";

/// Triangles over points, coloured by numbers; refers to memory that it does not own.
struct Sheet {
  vtkNew<vtkDoubleArray> points;
  vtkNew<vtkDoubleArray> values;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;

  Sheet() {
    points->SetNumberOfComponents(3);
    values->SetName(kValues);
    vtkNew<vtkPoints> holder;
    holder->SetData(points);
    data->SetPoints(holder);
    data->GetPointData()->AddArray(values);
    mapper->SetInputData(data);
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray(kValues);
    mapper->SetColorModeToMapScalars();
    mapper->SetInterpolateScalarsBeforeMapping(1);
    mapper->UseLookupTableScalarRangeOn();
    actor->SetMapper(mapper);
    actor->PickableOff();
    auto* property = actor->GetProperty();
    property->SetInterpolationToFlat();
    property->SetAmbient(kTissueAmbient);
    property->SetDiffuse(kTissueDiffuse);
    property->SetColor(0.82, 0.84, 0.86);
  }

  void checkPoints(const double* at, std::size_t count) {
    look(points.Get(), at, 3 * count);
    data->GetPoints()->Modified();
    data->Modified();
  }
  void checkValues(const double* at, std::size_t count) {
    look(values.Get(), at, count);
    data->Modified();
  }
  void checkTriangles(const std::vector<std::int32_t>& corners) {
    vtkNew<vtkTypeInt32Array> array;
    look(array.Get(), corners.data(), corners.size());
    vtkNew<vtkCellArray> cells;
    cells->SetData(3, array);
    data->SetPolys(cells);
    data->Modified();
  }
};

} // namespace

struct TissueActor::Parts {
  std::shared_ptr<const Tetrahedra> tetrahedra;
  std::shared_ptr<const Points> points;
  std::shared_ptr<const Values> values;
  std::vector<TetraFace> allFaces;
  std::optional<CutPlane> plane;
  CutStyle style = CutStyle::smooth;
  std::optional<ValueRange> range;
  bool outside = true;
  bool visible = true;
  bool ghost = false;

  bool keptOld = true;  ///< The whole tetrahedra that a crinkle cut leaves have to be chosen anew.
  bool facesOld = true; ///< Which faces are drawn has to be found anew.
  bool cutOld = true;
  std::vector<char> kept;  ///< By the crinkle cut; empty: all.
  std::vector<char> shown; ///< Empty: all.
  int shownCount = 0;
  std::vector<std::int32_t> faceCorners;
  std::vector<std::int32_t> faceOwners; ///< The tetrahedron of each drawn face.
  PlaneCut section;

  Sheet faceSheet;
  Sheet cutSheet;
  vtkNew<BlendedActor> ghostActor;
  BeforeRender beforeRender{[this] { update(); }};

  bool cutsSmoothly() const { return plane && style == CutStyle::smooth; }
  std::array<vtkActor*, 3> actors() {
    return {faceSheet.actor.Get(), cutSheet.actor.Get(), ghostActor.Get()};
  }
  void choose();
  void collectFaces();
  void updateCut();
  void update();
  void applyLook();
  double meanValue(Eigen::Index t) const;
  void finishPick(const Ray& ray, TissuePick& pick) const;
};

double TissueActor::Parts::meanValue(Eigen::Index t) const {
  double sum = 0;
  for (int c = 0; c < 4; ++c)
    sum += (*values)[(*tetrahedra)(t, c)];
  return sum / 4;
}

/// Chooses the tetrahedra that are drawn.
void TissueActor::Parts::choose() {
  const Eigen::Index count = tetrahedra->rows();
  if (keptOld) {
    keptOld = false;
    kept.clear();
    if (plane && style == CutStyle::crinkle) {
      const Eigen::VectorXd side = (*points * plane->normal).array() - plane->normal.dot(plane->origin);
      kept.resize(static_cast<std::size_t>(count));
      for (Eigen::Index t = 0; t < count; ++t) {
        bool any = false;
        for (int c = 0; c < 4; ++c)
          any = any || side[(*tetrahedra)(t, c)] >= 0;
        kept[static_cast<std::size_t>(t)] = any;
      }
    }
  }
  shown = kept;
  if (range && values) {
    shown.resize(static_cast<std::size_t>(count), 1);
    for (Eigen::Index t = 0; t < count; ++t) {
      const double mean = meanValue(t);
      // NaN is never left out.
      if (mean < range->low || mean > range->high)
        shown[static_cast<std::size_t>(t)] = 0;
    }
  }
  shownCount = static_cast<int>(shown.empty() ? count : std::count(shown.begin(), shown.end(), 1));
}

/// The faces between what is drawn and what is not.
void TissueActor::Parts::collectFaces() {
  faceCorners.clear();
  faceOwners.clear();
  const auto isShown = [this](std::int32_t t) {
    return t >= 0 && (shown.empty() || shown[static_cast<std::size_t>(t)] != 0);
  };
  for (const TetraFace& face : allFaces) {
    const bool first = isShown(face.first), second = isShown(face.second);
    if (first == second || (face.second < 0 && !outside))
      continue;
    const auto& c = face.corners;
    if (first)
      faceCorners.insert(faceCorners.end(), {c[0], c[1], c[2]});
    else
      faceCorners.insert(faceCorners.end(), {c[0], c[2], c[1]});
    faceOwners.push_back(first ? face.first : face.second);
  }
  faceSheet.checkTriangles(faceCorners);
}

void TissueActor::Parts::updateCut() {
  if (cutsSmoothly())
    section.make(*tetrahedra, *points, values.get(), shown, *plane);
  else
    section.clear();
  cutSheet.checkPoints(section.points.data(), section.points.size() / 3);
  cutSheet.checkValues(section.values.data(), section.values.size());
  cutSheet.checkTriangles(section.corners);
}

void TissueActor::Parts::update() {
  if (!visible)
    return;
  if (facesOld || keptOld) {
    facesOld = false;
    choose();
    collectFaces();
  }
  if (cutOld) {
    cutOld = false;
    updateCut();
  }
}

void TissueActor::Parts::applyLook() {
  for (Sheet* sheet : {&faceSheet, &cutSheet}) {
    sheet->mapper->SetScalarVisibility(values && !ghost);
    sheet->actor->SetVisibility(visible && !ghost);
  }
  ghostActor->SetVisibility(visible && ghost);
}

TissueActor::TissueActor(std::shared_ptr<const Tetrahedra> tetrahedra, std::shared_ptr<const Points> points)
    : parts_(std::make_unique<Parts>()) {
  auto& p = *parts_;
  if (tetrahedra->size() > 0 && (tetrahedra->minCoeff() < 0 || tetrahedra->maxCoeff() >= points->rows()))
    throw UsageError(misuse("a tetrahedron has a corner that is none of the %1 points", points->rows()));
  p.tetrahedra = std::move(tetrahedra);
  p.allFaces = tetraFaces(*p.tetrahedra, *points);
  p.ghostActor->SetMapper(p.faceSheet.mapper);
  auto* ghost = p.ghostActor->GetProperty();
  ghost->SetOpacity(kTissueGhostOpacity);
  ghost->SetColor(0.72, 0.76, 0.8);
  p.applyLook();
  setPoints(std::move(points));
}

TissueActor::~TissueActor() {
  setRenderer(nullptr);
}

const Tetrahedra& TissueActor::tetrahedra() const {
  return *parts_->tetrahedra;
}
const Points& TissueActor::points() const {
  return *parts_->points;
}

void TissueActor::setRenderer(vtkRenderer* renderer) {
  parts_->beforeRender.setRenderer(renderer, parts_->actors());
}

void TissueActor::setPoints(std::shared_ptr<const Points> points) {
  auto& p = *parts_;
  p.points = std::move(points);
  p.faceSheet.checkPoints(p.points->data(), static_cast<std::size_t>(p.points->rows()));
  p.cutOld = p.cutOld || p.cutsSmoothly();
}

void TissueActor::setValues(std::shared_ptr<const Values> values) {
  auto& p = *parts_;
  if (values->size() != p.points->rows())
    throw UsageError(
        misuse("the values to show are %1, the tissue has %2 points", values->size(), p.points->rows()));
  p.values = std::move(values);
  p.faceSheet.checkValues(p.values->data(), static_cast<std::size_t>(p.values->size()));
  p.facesOld = p.facesOld || p.range;
  p.cutOld = p.cutOld || p.cutsSmoothly();
  p.applyLook();
}

void TissueActor::setColors(const ColorMap& map, ValueRange range) {
  const auto table = lookupTable(map, range);
  parts_->faceSheet.mapper->SetLookupTable(table);
  parts_->cutSheet.mapper->SetLookupTable(table);
}

void TissueActor::setGhost(bool ghost) {
  parts_->ghost = ghost;
  parts_->applyLook();
}

void TissueActor::setCut(const CutPlane& plane, CutStyle style) {
  auto& p = *parts_;
  p.plane = plane;
  p.style = style;
  p.keptOld = p.cutOld = true;
  p.faceSheet.mapper->RemoveAllClippingPlanes();
  if (style == CutStyle::smooth) {
    vtkNew<vtkPlane> half;
    half->SetOrigin(plane.origin.data());
    half->SetNormal(plane.normal.data());
    p.faceSheet.mapper->AddClippingPlane(half);
  }
}

void TissueActor::clearCut() {
  auto& p = *parts_;
  p.plane.reset();
  p.keptOld = p.cutOld = true;
  p.faceSheet.mapper->RemoveAllClippingPlanes();
}

void TissueActor::setShownRange(ValueRange range) {
  auto& p = *parts_;
  if (p.range && p.range->low == range.low && p.range->high == range.high)
    return;
  p.range = range;
  p.facesOld = p.cutOld = true;
}

void TissueActor::clearShownRange() {
  if (!parts_->range)
    return;
  parts_->range.reset();
  parts_->facesOld = parts_->cutOld = true;
}

void TissueActor::setOutsideShown(bool shown) {
  parts_->facesOld = parts_->facesOld || shown != parts_->outside;
  parts_->outside = shown;
}

void TissueActor::setVisible(bool visible) {
  parts_->visible = visible;
  parts_->applyLook();
}

bool TissueActor::visible() const {
  return parts_->visible;
}

void TissueActor::update() {
  parts_->update();
}

int TissueActor::shownTetrahedra() const {
  return parts_->shownCount;
}
int TissueActor::cutTriangles() const {
  return static_cast<int>(parts_->section.owners.size());
}

/// The rest of a pick from its tetrahedron and position.
void TissueActor::Parts::finishPick(const Ray& ray, TissuePick& pick) const {
  pick.position = ray.origin + pick.distance * ray.direction;
  const auto corners = tetrahedra->row(pick.tetrahedron);
  Eigen::Matrix3d edges;
  for (int c = 0; c < 3; ++c)
    edges.col(c) = (points->row(corners[c + 1]) - points->row(corners[0])).transpose();
  const Vec3 inside =
      edges.fullPivLu().solve(pick.position - points->row(corners[0]).transpose()).cwiseMax(0).cwiseMin(1);
  pick.weights = {std::max(0.0, 1 - inside.sum()), inside.x(), inside.y(), inside.z()};
  double nearest = std::numeric_limits<double>::infinity();
  for (int c = 0; c < 4; ++c) {
    const double away = (points->row(corners[c]).transpose() - pick.position).norm();
    if (away < nearest) {
      nearest = away;
      pick.point = corners[c];
    }
  }
}

std::optional<TissuePick> TissueActor::pick(const Ray& ray) {
  auto& p = *parts_;
  if (!p.visible)
    return std::nullopt;
  p.update();
  std::optional<TissuePick> pick;
  double farthest = std::numeric_limits<double>::infinity();
  for (Sheet* sheet : {&p.faceSheet, &p.cutSheet}) {
    const ActorMesh mesh(sheet->actor);
    const auto hit = nearestHit(ray, mesh.view(), farthest);
    if (!hit)
      continue;
    farthest = hit->distance;
    const auto& owners = sheet == &p.faceSheet ? p.faceOwners : p.section.owners;
    pick.emplace();
    pick->tetrahedron = owners[static_cast<std::size_t>(hit->triangle)];
    pick->distance = hit->distance;
  }
  if (pick)
    p.finishPick(ray, *pick);
  return pick;
}

vtkActor* TissueActor::faces() const {
  return parts_->faceSheet.actor;
}
vtkActor* TissueActor::cut() const {
  return parts_->cutSheet.actor;
}

} // namespace viscera::scene
