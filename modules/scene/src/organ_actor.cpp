#include "viscera/scene/organ_actor.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/volume.h"

#include "borrowed_array.h"
#include "moving_triangles.h"
#include "wall_actor.h"

namespace viscera::scene {
namespace {

constexpr double kSpecular = 0.25;
constexpr double kSpecularPower = 28;
constexpr double kSelectedAmbient = 0.22;
/// Colours that mean numbers are lit more evenly and shine less, so that they can be read off the legend.
constexpr double kScalarsAmbient = 0.42;
constexpr double kScalarsDiffuse = 0.7;
constexpr double kScalarsSpecular = 0.06;
constexpr double kEdgeShade = 0.12; ///< Dark on the colours that organs have.
constexpr const char* kColorsName = "colors";
constexpr const char* kScalarsName = "values";

bool isDrawn(SurfaceRole role) {
  return role == SurfaceRole::whole || role == SurfaceRole::picture || role == SurfaceRole::filling;
}

/// Cells that look at triangles which live longer.
vtkSmartPointer<vtkCellArray> cellsOf(const Triangles& triangles) {
  vtkNew<vtkTypeInt32Array> corners;
  look(corners.Get(), triangles.data(), triangles.size());
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(3, corners);
  return cells;
}

/// Whether every edge has one triangle on each side, run through in opposite directions, and the inside is
/// inside.
bool isClosedOutward(const geometry::TriangleMesh& mesh, const geometry::VertexTriangles& around) {
  const auto hasEdge = [&](std::int32_t from, std::int32_t to) {
    int found = 0;
    for (auto k = around.first[std::size_t(from)]; k < around.first[std::size_t(from) + 1]; ++k) {
      const auto corners = mesh.triangles.row(around.items[std::size_t(k)]);
      for (int c = 0; c < 3; ++c)
        found += corners[c] == from && corners[(c + 1) % 3] == to;
    }
    return found == 1;
  };
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c)
      if (!hasEdge(mesh.triangles(t, (c + 1) % 3), mesh.triangles(t, c)))
        return false;
  return geometry::volume(mesh.points, mesh.triangles) > 0;
}

} // namespace

struct OrganActor::Parts {
  std::shared_ptr<const geometry::TriangleMesh> mesh;
  std::shared_ptr<const Points> points;
  std::shared_ptr<const Values> values;
  geometry::VertexTriangles around;
  geometry::Normals normals; ///< Of all triangles.
  bool normalsDue = true;    ///< They are of earlier points.
  Threads threads;
  bool vertexColors = false;
  bool selected = false;
  bool closed = false;
  SurfaceRole role = SurfaceRole::whole;

  int coarsePart = 1; ///< One in so many vertices is a corner of `coarse`.
  Triangles coarse;
  geometry::VertexTriangles aroundCoarse;
  geometry::Normals coarseNormals; ///< Of `coarse`; zero at vertices that are no corners of it.
  bool coarseNormalsDue = true;
  vtkSmartPointer<vtkCellArray> cells;
  vtkSmartPointer<vtkCellArray> coarseCells;

  vtkNew<vtkPolyData> data;
  vtkNew<vtkDoubleArray> pointArray;
  vtkNew<vtkFloatArray> normalArray;
  vtkNew<vtkUnsignedCharArray> colorArray;
  vtkNew<vtkDoubleArray> valueArray;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<WallActor> actor;

  void buildData();
  const geometry::Normals& wholeNormals();
  void drawNormals();
  void chooseColoring();
  void chooseLook();
};

void OrganActor::Parts::buildData() {
  pointArray->SetNumberOfComponents(3);
  normalArray->SetNumberOfComponents(3);
  normalArray->SetName("normals");
  vtkNew<vtkPoints> vtkPointsOfData;
  vtkPointsOfData->SetData(pointArray);
  data->SetPoints(vtkPointsOfData);
  data->GetPointData()->SetNormals(normalArray);

  cells = cellsOf(mesh->triangles);
  data->SetPolys(cells);

  if (mesh->colors.rows() == mesh->points.rows() && mesh->colors.rows() > 0) {
    colorArray->SetNumberOfComponents(3);
    colorArray->SetName(kColorsName);
    look(colorArray.Get(), mesh->colors.data(), mesh->colors.size());
    data->GetPointData()->AddArray(colorArray);
    vertexColors = true;
  }
}

const geometry::Normals& OrganActor::Parts::wholeNormals() {
  if (std::exchange(normalsDue, false))
    geometry::vertexNormals(*points, mesh->triangles, around, normals, threads);
  return normals;
}

/// Has VTK draw the normals of the triangles that it draws. It lights a triangle on the side from which it is
/// seen, and takes its normals to be of that side: those of the whole surface may be of the other one where a
/// coarse triangle lies across a fold, which was black then.
void OrganActor::Parts::drawNormals() {
  const bool few = data->GetPolys() == coarseCells.Get();
  if (few && std::exchange(coarseNormalsDue, false))
    geometry::vertexNormals(*points, coarse, aroundCoarse, coarseNormals, threads);
  const geometry::Normals& drawn = few ? coarseNormals : wholeNormals();
  look(normalArray.Get(), drawn.data(), drawn.size());
}

void OrganActor::Parts::chooseColoring() {
  mapper->SetScalarVisibility(values || vertexColors);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(values ? kScalarsName : kColorsName);
  // Numbers are interpolated before they become colours; colours have nothing to look up.
  mapper->SetInterpolateScalarsBeforeMapping(values ? 1 : 0);
  if (values)
    mapper->SetColorModeToMapScalars();
  else
    mapper->SetColorModeToDirectScalars();
  chooseLook();
}

void OrganActor::Parts::chooseLook() {
  auto* property = actor->GetProperty();
  property->SetAmbient((values ? kScalarsAmbient : 0) + (selected ? kSelectedAmbient : 0));
  property->SetDiffuse(values ? kScalarsDiffuse : 1);
  property->SetSpecular(values ? kScalarsSpecular : kSpecular);
}

OrganActor::OrganActor(std::shared_ptr<const geometry::TriangleMesh> mesh, Threads threads)
    : parts_(std::make_unique<Parts>()) {
  auto& p = *parts_;
  p.mesh = std::move(mesh);
  p.threads = threads;
  p.around = geometry::vertexTriangles(p.mesh->points.rows(), p.mesh->triangles);
  p.closed = isClosedOutward(*p.mesh, p.around);
  p.buildData();
  p.mapper->SetInputData(p.data);
  p.mapper->UseLookupTableScalarRangeOn();
  p.actor->SetMapper(p.mapper);
  auto* look = p.actor->GetProperty();
  look->SetInterpolationToPhong();
  look->SetSpecularPower(kSpecularPower);
  look->SetEdgeColor(kEdgeShade, kEdgeShade, kEdgeShade);
  look->SetColor(0.8, 0.45, 0.4);
  p.chooseColoring();
  setPoints(nullptr);
}

OrganActor::~OrganActor() = default;

const geometry::TriangleMesh& OrganActor::mesh() const {
  return *parts_->mesh;
}

void OrganActor::setPoints(std::shared_ptr<const Points> points) {
  if (!points)
    points = std::shared_ptr<const Points>(parts_->mesh, &parts_->mesh->points);
  if (points->rows() != parts_->mesh->points.rows())
    throw UsageError(
        misuse("the points to show are %1, the surface has %2", points->rows(), parts_->mesh->points.rows()));
  parts_->points = std::move(points);
  pointsChanged();
}

const Points& OrganActor::points() const {
  return *parts_->points;
}

void OrganActor::pointsChanged() {
  auto& p = *parts_;
  p.normalsDue = p.coarseNormalsDue = true;
  look(p.pointArray.Get(), p.points->data(), p.points->size());
  p.drawNormals();
  p.data->GetPoints()->Modified();
  p.data->Modified();
}

const geometry::Normals& OrganActor::normals() const {
  return parts_->wholeNormals();
}

Bounds OrganActor::bounds() const {
  return boundsOf(*parts_->points);
}

void OrganActor::setColor(const Vec3& color) {
  parts_->actor->GetProperty()->SetColor(color.x(), color.y(), color.z());
}

Vec3 OrganActor::color() const {
  return Vec3(parts_->actor->GetProperty()->GetColor());
}

void OrganActor::setVertexColorsShown(bool shown) {
  parts_->vertexColors = shown && parts_->colorArray->GetNumberOfTuples() > 0;
  parts_->chooseColoring();
}

void OrganActor::setOpacity(double opacity) {
  parts_->actor->GetProperty()->SetOpacity(opacity);
}
double OrganActor::opacity() const {
  return parts_->actor->GetProperty()->GetOpacity();
}
void OrganActor::setVisible(bool visible) {
  parts_->actor->SetVisibility(visible);
}
bool OrganActor::visible() const {
  return parts_->actor->GetVisibility() != 0;
}

void OrganActor::setRole(SurfaceRole role) {
  parts_->role = role;
  parts_->actor->setDrawn(isDrawn(role));
}

SurfaceRole OrganActor::role() const {
  return parts_->role;
}

bool OrganActor::drawn() const {
  return visible() && isDrawn(parts_->role);
}

bool OrganActor::met() const {
  return visible() && parts_->role != SurfaceRole::picture && parts_->role != SurfaceRole::filling;
}

void OrganActor::setSelected(bool selected) {
  parts_->selected = selected;
  parts_->chooseLook();
}

bool OrganActor::selected() const {
  return parts_->selected;
}

void OrganActor::setClipPlane(const Vec3& origin, const Vec3& normal) {
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin.data());
  plane->SetNormal(normal.normalized().eval().data());
  clearClipPlane();
  parts_->mapper->AddClippingPlane(plane);
}

void OrganActor::clearClipPlane() {
  parts_->mapper->RemoveAllClippingPlanes();
}

bool OrganActor::isCut() const {
  vtkPlaneCollection* planes = parts_->mapper->GetClippingPlanes();
  return planes && planes->GetNumberOfItems() > 0;
}

bool OrganActor::cutsAway(const Vec3& place) const {
  return behindCut(place) < 0;
}

double OrganActor::behindCut(const Vec3& place) const {
  if (!isCut())
    return std::numeric_limits<double>::infinity();
  vtkPlane* plane = parts_->mapper->GetClippingPlanes()->GetItem(0);
  Vec3 at = place;
  return plane->EvaluateFunction(at.data()) / Vec3(plane->GetNormal()).norm();
}

void OrganActor::showScalars(std::shared_ptr<const Values> values, const ColorMap& map, ValueRange range) {
  auto& p = *parts_;
  if (values->size() != p.mesh->points.rows())
    throw UsageError(misuse("the values to show are %1, the surface has %2 vertices", values->size(),
                            p.mesh->points.rows()));
  p.values = std::move(values);
  p.valueArray->SetName(kScalarsName);
  p.data->GetPointData()->AddArray(p.valueArray);
  p.mapper->SetLookupTable(lookupTable(map, range));
  p.chooseColoring();
  scalarsChanged();
}

void OrganActor::scalarsChanged() {
  auto& p = *parts_;
  if (!p.values)
    return;
  look(p.valueArray.Get(), p.values->data(), p.values->size());
  p.data->Modified();
}

void OrganActor::hideScalars() {
  auto& p = *parts_;
  p.values.reset();
  p.data->GetPointData()->RemoveArray(kScalarsName);
  p.chooseColoring();
}

void OrganActor::cullBackFaces(const Vec3& eye) {
  auto& p = *parts_;
  const double* b = p.data->GetBounds();
  const bool outside = eye.x() < b[0] || eye.x() > b[1] || eye.y() < b[2] || eye.y() > b[3] ||
                       eye.z() < b[4] || eye.z() > b[5];
  p.actor->GetProperty()->SetBackfaceCulling(p.closed && outside && !isCut() && opacity() >= 1);
}

void OrganActor::setDrawnWithoutPeeling(bool unpeeled) {
  parts_->actor->setDrawnWithoutPeeling(unpeeled && opacity() < 1);
}

void OrganActor::setMeshLook(const MeshLook& look) {
  auto* property = parts_->actor->GetProperty();
  property->SetEdgeVisibility(look.edges);
  property->SetInterpolation(look.flat ? VTK_FLAT : VTK_PHONG);
}

void OrganActor::setCoarse(int part) {
  auto& p = *parts_;
  if (part > 1 && part != p.coarsePart) {
    p.coarsePart = part;
    p.coarse = movingTriangles(*p.mesh, part);
    p.coarseCells = cellsOf(p.coarse);
    p.aroundCoarse = geometry::vertexTriangles(p.mesh->points.rows(), p.coarse);
    p.coarseNormalsDue = true;
  }
  vtkCellArray* wanted = part > 1 ? p.coarseCells : p.cells;
  if (p.data->GetPolys() == wanted)
    return;
  p.data->SetPolys(wanted);
  p.drawNormals();
}

bool OrganActor::scalarsShown() const {
  return parts_->values != nullptr;
}

vtkActor* OrganActor::actor() const {
  return parts_->actor;
}
vtkPolyData* OrganActor::polyData() const {
  return parts_->data;
}

} // namespace viscera::scene
