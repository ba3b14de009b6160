#include "viscera/scene/region_hulls.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "before_render.h"
#include "blended_actor.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {

/// Logical pixels.
constexpr double kEdgeWidth = 1.6;
constexpr double kThickWidth = 4;
constexpr double kHullDotSize = 10;
constexpr double kEdgeOpacity = 0.75;
/// The factor of opacity for edges behind an organ.
constexpr double kEdgesBehind = 0.35;
/// Neighbouring faces whose normals agree so far (1 minus the cosine) are one face: no edge between them.
constexpr double kOneFace = 1e-6;

using Kind = coordinates::SpacePart::Kind;

const Vec3 kNoGroup(0.62, 0.66, 0.70);
const Vec3 kZone(0.90, 0.22, 0.20);
const Vec3 kSuperRegion(0.95, 0.85, 0.25);
constexpr double kRegionOpacity = 0.12;
constexpr double kZoneOpacity = 0.30;
constexpr double kSuperRegionOpacity = 0.05;

bool isShown(const LayoutParts& shown, Kind kind) {
  switch (kind) {
  case Kind::region:
    return shown.regions;
  case Kind::zone:
    return shown.zones;
  case Kind::superRegion:
    return shown.superRegions;
  }
  return false;
}

/// Some cells of one kind with a colour each.
struct Cells {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<BlendedActor> actor;

  Cells() {
    mapper->SetInputData(data);
    mapper->SetScalarModeToUseCellData();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
  }
};

std::array<std::uint8_t, 4> bytes(const Vec3& color, double opacity) {
  const auto byte = [](double part) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
  };
  return {byte(color[0]), byte(color[1]), byte(color[2]), byte(opacity)};
}

Vec3 normalOf(const RegionHull& hull, Eigen::Index triangle) {
  const auto corner = [&](int k) -> Vec3 {
    return hull.vertices.row(hull.triangles(triangle, k)).transpose();
  };
  return (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
}

/// The edges without those that only divide a flat face into triangles.
std::vector<std::array<int, 2>> sharpEdges(const RegionHull& hull) {
  std::map<std::pair<int, int>, std::vector<Vec3>> normals;
  for (Eigen::Index t = 0; t < hull.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = hull.triangles(t, k), b = hull.triangles(t, (k + 1) % 3);
      normals[{std::min(a, b), std::max(a, b)}].push_back(normalOf(hull, t));
    }
  std::vector<std::array<int, 2>> sharp;
  for (const auto& edge : hull.edges) {
    const auto found = normals.find({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])});
    if (found == normals.end() || found->second.size() != 2 ||
        1 - found->second[0].dot(found->second[1]) > kOneFace)
      sharp.push_back(edge);
  }
  return sharp;
}

struct Face {
  vtkIdType corners[3];
  std::array<std::uint8_t, 4> color;
  Vec3 center;
};

} // namespace

std::vector<RegionHull> layoutHulls(const coordinates::SpaceLayout& layout,
                                    const std::vector<Vec3>& groupColors, const LayoutParts& shown) {
  std::vector<RegionHull> hulls;
  for (const coordinates::SpacePart& part : layout.parts) {
    if (!isShown(shown, part.kind))
      continue;
    RegionHull hull{part.vertices, part.triangles, part.edges, kNoGroup, kRegionOpacity};
    if (part.kind == Kind::zone) {
      hull.color = kZone;
      hull.opacity = kZoneOpacity;
    } else if (part.kind == Kind::superRegion) {
      hull.color = kSuperRegion;
      hull.opacity = kSuperRegionOpacity;
    } else if (!part.groups.empty() && static_cast<std::size_t>(part.groups.front()) < groupColors.size()) {
      hull.color = groupColors[static_cast<std::size_t>(part.groups.front())];
    }
    hulls.push_back(std::move(hull));
  }
  return hulls;
}

RegionHull cageHull(const Points& handles, const Triangles& cage) {
  std::set<std::array<int, 2>> edges;
  for (Eigen::Index t = 0; t < cage.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = cage(t, k), b = cage(t, (k + 1) % 3);
      edges.insert({std::min(a, b), std::max(a, b)});
    }
  return {handles, cage, {edges.begin(), edges.end()}, kNoGroup, kRegionOpacity};
}

struct RegionHulls::Parts {
  std::vector<RegionHull> hulls;
  std::vector<Face> faces;
  Vec3 sortedFrom = Vec3::Zero();
  vtkNew<vtkPoints> points;
  Cells glass;
  Cells lines;
  Cells linesBehind; ///< The same lines where an organ is in front of them.
  Cells thick;       ///< Bodies without faces: edges and points in which regions touch.
  BeforeRender beforeRender{[this] { follow(); }};

  std::array<vtkActor*, 4> actors() {
    return {linesBehind.actor.Get(), glass.actor.Get(), lines.actor.Get(), thick.actor.Get()};
  }
  void build();
  void addHull(const RegionHull& hull);
  void follow();
  void sortFaces(const Vec3& eye);
};

void RegionHulls::Parts::addHull(const RegionHull& hull) {
  const vtkIdType first = points->GetNumberOfPoints();
  for (const auto& vertex : hull.vertices.rowwise())
    points->InsertNextPoint(vertex[0], vertex[1], vertex[2]);
  for (Eigen::Index t = 0; t < hull.triangles.rows(); ++t) {
    const auto corners = hull.triangles.row(t);
    const Vec3 center =
        (hull.vertices.row(corners[0]) + hull.vertices.row(corners[1]) + hull.vertices.row(corners[2]))
            .transpose() /
        3;
    faces.push_back({{first + corners[0], first + corners[1], first + corners[2]},
                     bytes(hull.color, hull.opacity),
                     center});
  }
  const bool solid = hull.triangles.rows() > 0;
  const auto add = [&](Cells& cells, const std::array<int, 2>& edge, double opacity) {
    const vtkIdType ends[] = {first + edge[0], first + edge[1]};
    if (edge[0] == edge[1])
      cells.data->GetVerts()->InsertNextCell(1, ends);
    else
      cells.data->GetLines()->InsertNextCell(2, ends);
    const auto color = bytes(hull.color, opacity);
    static_cast<vtkUnsignedCharArray*>(cells.data->GetCellData()->GetScalars())
        ->InsertNextTypedTuple(color.data());
  };
  for (const auto& edge : sharpEdges(hull)) {
    add(solid ? lines : thick, edge, kEdgeOpacity);
    add(linesBehind, edge, kEdgesBehind * kEdgeOpacity);
  }
}

void RegionHulls::Parts::build() {
  points->Reset();
  points->SetDataTypeToDouble();
  faces.clear();
  sortedFrom = Vec3::Constant(std::nan(""));
  for (Cells* cells : {&glass, &lines, &linesBehind, &thick}) {
    cells->data->Initialize();
    cells->data->SetPoints(points);
    cells->data->SetVerts(vtkNew<vtkCellArray>());
    cells->data->SetLines(vtkNew<vtkCellArray>());
    cells->data->SetPolys(vtkNew<vtkCellArray>());
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(4);
    cells->data->GetCellData()->SetScalars(colors);
  }
  for (const RegionHull& hull : hulls)
    addHull(hull);
  points->Modified();
  for (Cells* cells : {&glass, &lines, &linesBehind, &thick}) {
    cells->data->Modified();
    cells->actor->SetVisibility(!hulls.empty());
  }
  glass.actor->SetVisibility(!faces.empty());
}

/// Far faces first: blending depends on the order.
void RegionHulls::Parts::sortFaces(const Vec3& eye) {
  if (eye == sortedFrom)
    return;
  sortedFrom = eye;
  std::stable_sort(faces.begin(), faces.end(), [&eye](const Face& a, const Face& b) {
    return (a.center - eye).squaredNorm() > (b.center - eye).squaredNorm();
  });
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (const Face& face : faces) {
    polys->InsertNextCell(3, face.corners);
    colors->InsertNextTypedTuple(face.color.data());
  }
  glass.data->SetPolys(polys);
  glass.data->GetCellData()->SetScalars(colors);
}

void RegionHulls::Parts::follow() {
  if (hulls.empty())
    return;
  const ViewGeometry view = viewGeometry(beforeRender.renderer());
  sortFaces(view.eye);
  for (const auto& [cells, width] :
       {std::pair{&lines, kEdgeWidth}, std::pair{&linesBehind, kEdgeWidth}, std::pair{&thick, kThickWidth}}) {
    cells->actor->GetProperty()->SetLineWidth(static_cast<float>(width * view.pixelRatio));
    cells->actor->GetProperty()->SetPointSize(static_cast<float>(kHullDotSize * view.pixelRatio));
  }
}

RegionHulls::RegionHulls() : parts_(std::make_unique<Parts>()) {
  parts_->linesBehind.actor->setBehindOnly(true);
  parts_->build();
}

RegionHulls::~RegionHulls() {
  setRenderer(nullptr);
}

void RegionHulls::setRenderer(vtkRenderer* renderer) {
  parts_->beforeRender.setRenderer(renderer, parts_->actors());
}

void RegionHulls::setHulls(std::vector<RegionHull> hulls) {
  parts_->hulls = std::move(hulls);
  parts_->build();
}

const std::vector<RegionHull>& RegionHulls::hulls() const {
  return parts_->hulls;
}

void RegionHulls::drawAfterOrgans() {
  if (auto* renderer = parts_->beforeRender.renderer())
    for (auto* actor : parts_->actors())
      drawLast(renderer, actor);
}

} // namespace viscera::scene
