#include "viscera/phantom/phantom_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/phantom/tissue.h"

namespace viscera::phantom {
namespace {

/// A surface of a sample organ and where the phantom has it, mm from its place in the definition.
struct Placed {
  const char* tissue;
  const char* organ;
  const char* surface;
  Vec3 shift;
};

/// Below the heart, so that the dome of the liver is under its diaphragmatic side.
const Vec3 kAbdomen(0, 0, -189);

const std::vector<Placed>& placedOrgans() {
  static const std::vector<Placed> list = {
      {"liver", "digestive_system", "liver", kAbdomen},
      {"spleen", "digestive_system", "spleen", kAbdomen},
      {"pancreas", "digestive_system", "pancreas", kAbdomen},
      {"stomach", "stomach", "outer", kAbdomen},
      {"right kidney", "kidney_right", "outer", Vec3(-62, 78, -225)},
      {"left kidney", "kidney_left", "outer", Vec3(62, 82, -205)},
      {"myocardium", "heart", "outer", Vec3::Zero()},
      {"right atrium", "heart", "ra", Vec3::Zero()},
      {"left atrium", "heart", "la", Vec3::Zero()},
      {"right ventricle", "heart", "rv", Vec3::Zero()},
      {"left ventricle", "heart", "lv", Vec3::Zero()},
  };
  return list;
}

/// |x/a|^n + |y/b|^n + |z/c|^n = 1.
struct Shape {
  const char* tissue;
  Vec3 center, radii;
  double power;
  bool still;
};

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> list = {
      {"body", {0, 15, -75}, {185, 125, 235}, 3.2, true},
      {"fat", {0, 13, -75}, {160, 104, 218}, 3.2, true},
      {"right lung", {-88, 14, 40}, {58, 78, 112}, 2.6, false},
      {"left lung", {92, 16, 48}, {52, 74, 104}, 2.6, false},
      {"spine", {0, 112, -75}, {19, 17, 225}, 4, true},
  };
  return list;
}

constexpr int kAround = 72, kAlong = 48;

double powered(double value, double exponent) {
  return std::copysign(std::pow(std::abs(value), exponent), value);
}

/// A globe of triangles, drawn out to the shape.
geometry::TriangleMesh meshOf(const Shape& shape) {
  constexpr double kPi = std::numbers::pi;
  geometry::TriangleMesh mesh;
  mesh.points.resize(kAround * (kAlong - 1) + 2, 3);
  const auto put = [&](Eigen::Index row, const Vec3& unit) {
    mesh.points.row(row) = (shape.center + shape.radii.cwiseProduct(unit)).transpose();
  };
  const double exponent = 2 / shape.power;
  for (int ring = 1; ring < kAlong; ++ring)
    for (int step = 0; step < kAround; ++step) {
      const double polar = kPi * ring / kAlong, turn = 2 * kPi * step / kAround;
      const double across = powered(std::sin(polar), exponent);
      put((ring - 1) * kAround + step,
          {across * powered(std::cos(turn), exponent), across * powered(std::sin(turn), exponent),
           powered(std::cos(polar), exponent)});
    }
  const int top = kAround * (kAlong - 1), bottom = top + 1;
  put(top, Vec3::UnitZ());
  put(bottom, -Vec3::UnitZ());
  std::vector<Eigen::Vector3i> triangles;
  for (int step = 0; step < kAround; ++step) {
    const int next = (step + 1) % kAround, last = (kAlong - 2) * kAround;
    triangles.emplace_back(top, step, next);
    triangles.emplace_back(bottom, last + next, last + step);
    for (int ring = 0; ring + 2 < kAlong; ++ring) {
      const int upper = ring * kAround, lower = upper + kAround;
      triangles.emplace_back(upper + step, lower + step, lower + next);
      triangles.emplace_back(upper + step, lower + next, upper + next);
    }
  }
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    mesh.triangles.row(static_cast<Eigen::Index>(t)) = triangles[t].transpose();
  return mesh;
}

/// The vertex that lies farthest in a direction.
Vec3 farthest(const geometry::TriangleMesh& mesh, const Vec3& way) {
  Eigen::Index row = 0;
  (mesh.points * way).maxCoeff(&row);
  return mesh.points.row(row).transpose();
}

std::vector<Landmark> landmarksOf(const PhantomBody& body) {
  const auto mesh = [&](const char* tissue) -> const geometry::TriangleMesh& {
    return body.surfaceOf(tissue).mesh;
  };
  const Vec3 apex = body.heart.towardsApex();
  std::vector<Landmark> list = {
      {"Apex of the left ventricle's cavity", farthest(mesh("left ventricle"), apex)},
      {"Apex of the right ventricle's cavity", farthest(mesh("right ventricle"), apex)},
      {"Dome of the liver", farthest(mesh("liver"), Vec3::UnitZ())},
      {"Lower edge of the liver", farthest(mesh("liver"), -Vec3::UnitZ())},
      {"Lower edge of the spleen", farthest(mesh("spleen"), -Vec3::UnitZ())},
      {"Upper pole of the right kidney", farthest(mesh("right kidney"), Vec3::UnitZ())},
      {"Upper pole of the left kidney", farthest(mesh("left kidney"), Vec3::UnitZ())},
      {"Lowest point of the stomach", farthest(mesh("stomach"), -Vec3::UnitZ())}};
  return list;
}

} // namespace

const BodySurface& PhantomBody::surfaceOf(const std::string& tissue) const {
  for (const BodySurface& surface : surfaces)
    if (surface.tissue == tissue)
      return surface;
  throw UsageError(misuse("the phantom has no tissue \"%1\"", tissue));
}

Bounds PhantomBody::bounds() const {
  return boundsOf(surfaceOf("body").mesh.points);
}

std::vector<PaintedSurface> PhantomBody::painted(const std::vector<Points>& points) const {
  std::vector<PaintedSurface> list;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    list.push_back({&points[s], &surfaces[s].mesh.triangles, tissueNamed(surfaces[s].tissue).label});
  return list;
}

PhantomBody phantomBody(const sample_organs::SampleLibrary& library, sample_organs::Resolution resolution,
                        Progress& progress, Threads threads) {
  PhantomBody body;
  body.heart = heart::sampleHeartFrame();
  for (const Shape& shape : shapes())
    body.surfaces.push_back({shape.tissue, meshOf(shape), shape.still});
  std::vector<Landmark> valves;
  const auto count = static_cast<double>(placedOrgans().size());
  for (const Placed& placed : placedOrgans()) {
    const double done = static_cast<double>(body.surfaces.size() - shapes().size()) / count;
    runPart(progress, done, done + 1 / count, [&](Progress& part) {
      const sample_organs::SampleSurface surface =
          sample_organs::sampleSurface(library, placed.organ, placed.surface, resolution, part, threads);
      BodySurface moved{placed.tissue, *surface.mesh, false};
      moved.mesh.points.rowwise() += placed.shift.transpose();
      body.surfaces.push_back(std::move(moved));
      for (const geometry::NamedPlace& place : surface.places)
        if (place.ringMm > 0)
          valves.push_back({place.name, place.at + placed.shift});
    });
  }
  std::sort(body.surfaces.begin(), body.surfaces.end(), [](const BodySurface& a, const BodySurface& b) {
    return tissueNamed(a.tissue).label < tissueNamed(b.tissue).label;
  });
  body.landmarks = landmarksOf(body);
  body.landmarks.insert(body.landmarks.end(), valves.begin(), valves.end());
  return body;
}

} // namespace viscera::phantom
