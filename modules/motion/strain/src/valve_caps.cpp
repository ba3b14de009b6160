#include "viscera/strain/valve_caps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <Eigen/Eigenvalues>

#include "viscera/core/disjoint_sets.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::strain {
namespace {

using geometry::TriangleMesh;

constexpr Eigen::Index kFewestTriangles = 4;
/// A fan around a hole of fewer edges might be any vertex of a mesh.
constexpr int kFewestRimEdges = 7;
/// How far the middle of a fan lies from a mean of its rim, as a part of the fan's radius.
constexpr double kFanTolerance = 1e-4;
/// Smaller fans close no valve: a part of the surface's area.
constexpr double kSmallestCap = 0.007;
/// The cosine of the angle between the normal of a triangle of a flat cap and the direction of the base.
constexpr double kCapCosine = 0.766;
/// A flat cap lies within this part of the cavity's extent from its end.
constexpr double kCapDepth = 0.3;
/// Part of the length at both ends, where the flatter one is looked for.
constexpr double kEndDepth = 0.2;

struct Facets {
  Points middles;
  Points normals; ///< Times area.
};

Facets facetsOf(const TriangleMesh& mesh) {
  Facets facets{Points(mesh.triangles.rows(), 3), Points(mesh.triangles.rows(), 3)};
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto [a, b, c] = geometry::cornersOf(mesh.points, mesh.triangles, t);
    facets.middles.row(t) = (a + b + c).transpose() / 3;
    facets.normals.row(t) = (b - a).cross(c - a).transpose() / 2;
  }
  return facets;
}

/// The vertices around one, when its triangles make a whole fan.
std::set<std::int32_t> rimAround(const TriangleMesh& mesh, const geometry::VertexTriangles& around,
                                 std::size_t vertex) {
  std::set<std::int32_t> rim;
  for (std::int32_t i = around.first[vertex]; i < around.first[vertex + 1]; ++i)
    for (const std::int32_t corner : mesh.triangles.row(around.items[static_cast<std::size_t>(i)]))
      if (static_cast<std::size_t>(corner) != vertex)
        rim.insert(corner);
  return rim;
}

/// The mean of a fan's rim, weighted by the lengths of its edges, as `geometry::closeHoles` takes it.
Vec3 meanByEdges(const TriangleMesh& mesh, const geometry::VertexTriangles& around, std::size_t vertex) {
  Vec3 sum = Vec3::Zero();
  double length = 0;
  for (std::int32_t i = around.first[vertex]; i < around.first[vertex + 1]; ++i) {
    const auto triangle = mesh.triangles.row(around.items[static_cast<std::size_t>(i)]);
    for (int k = 0; k < 3; ++k) {
      const std::int32_t from = triangle[k], to = triangle[(k + 1) % 3];
      if (static_cast<std::size_t>(from) == vertex || static_cast<std::size_t>(to) == vertex)
        continue;
      const double edge = (mesh.points.row(to) - mesh.points.row(from)).norm();
      sum += edge * (mesh.points.row(from) + mesh.points.row(to)).transpose() / 2;
      length += edge;
    }
  }
  return length > 0 ? Vec3(sum / length) : sum;
}

ValveCaps fanCaps(const TriangleMesh& mesh, const Facets& facets) {
  ValveCaps caps;
  caps.triangles.assign(static_cast<std::size_t>(mesh.triangles.rows()), false);
  const geometry::VertexTriangles around = geometry::vertexTriangles(mesh.points.rows(), mesh.triangles);
  const double total = facets.normals.rowwise().norm().sum();
  double largest = 0;
  for (std::size_t vertex = 0; vertex + 1 < around.first.size(); ++vertex) {
    const int edges = around.first[vertex + 1] - around.first[vertex];
    if (edges < kFewestRimEdges)
      continue;
    const std::set<std::int32_t> rim = rimAround(mesh, around, vertex);
    if (static_cast<int>(rim.size()) != edges)
      continue;
    Vec3 mean = Vec3::Zero();
    for (const std::int32_t point : rim)
      mean += mesh.points.row(point).transpose() / static_cast<double>(rim.size());
    const Vec3 middle = mesh.points.row(static_cast<Eigen::Index>(vertex)).transpose();
    double radius = 0;
    for (const std::int32_t point : rim)
      radius = std::max(radius, (mesh.points.row(point).transpose() - mean).norm());
    if ((middle - mean).norm() > kFanTolerance * radius &&
        (middle - meanByEdges(mesh, around, vertex)).norm() > kFanTolerance * radius)
      continue;
    Vec3 area = Vec3::Zero();
    for (std::int32_t i = around.first[vertex]; i < around.first[vertex + 1]; ++i)
      area += facets.normals.row(around.items[static_cast<std::size_t>(i)]).transpose();
    if (area.norm() < kSmallestCap * total)
      continue; // A vertex of a smooth, flat place.
    for (std::int32_t i = around.first[vertex]; i < around.first[vertex + 1]; ++i)
      caps.triangles[static_cast<std::size_t>(around.items[static_cast<std::size_t>(i)])] = true;
    ++caps.caps;
    if (area.norm() > largest) {
      largest = area.norm();
      caps.largestMiddle = mean;
      caps.largestNormal = area.normalized();
    }
  }
  return caps;
}

/// Along the longest principal axis, towards the end where more of the surface looks along it.
Vec3 baseDirection(const Facets& facets) {
  const Values areas = facets.normals.rowwise().norm();
  const Eigen::RowVector3d center = (areas.transpose() * facets.middles) / areas.sum();
  const Points from = facets.middles.rowwise() - center;
  const Eigen::Matrix3d spread = from.transpose() * areas.asDiagonal() * from;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Vec3 axis = solver.eigenvectors().col(2);
  const Values along = from * axis;
  const double low = along.minCoeff(), high = along.maxCoeff(), deep = kEndDepth * (high - low);
  double lowArea = 0, highArea = 0;
  for (Eigen::Index t = 0; t < along.size(); ++t) {
    const double looks = facets.normals.row(t).dot(axis);
    if (along[t] < low + deep && looks < -kCapCosine * areas[t])
      lowArea -= looks;
    if (along[t] > high - deep && looks > kCapCosine * areas[t])
      highArea += looks;
  }
  return highArea >= lowArea ? axis : Vec3(-axis);
}

ValveCaps flatCap(const TriangleMesh& mesh, const Facets& facets, const Vec3& towardsBase) {
  const auto count = static_cast<std::size_t>(mesh.triangles.rows());
  const Values along = facets.middles * towardsBase;
  const double high = along.maxCoeff(), deepest = high - kCapDepth * (high - along.minCoeff());
  std::vector<bool> looks(count);
  for (std::size_t t = 0; t < count; ++t) {
    const auto row = static_cast<Eigen::Index>(t);
    looks[t] = along[row] > deepest &&
               facets.normals.row(row).dot(towardsBase) > kCapCosine * facets.normals.row(row).norm();
  }
  DisjointSets pieces(static_cast<std::size_t>(mesh.points.rows()));
  const auto corner = [&mesh](std::size_t t, int k) {
    return static_cast<std::size_t>(mesh.triangles(static_cast<Eigen::Index>(t), k));
  };
  for (std::size_t t = 0; t < count; ++t)
    if (looks[t])
      for (int k = 1; k < 3; ++k)
        pieces.join(corner(t, 0), corner(t, k));
  std::map<std::size_t, double> areas;
  for (std::size_t t = 0; t < count; ++t)
    if (looks[t])
      areas[pieces.root(corner(t, 0))] += facets.normals.row(static_cast<Eigen::Index>(t)).norm();
  ValveCaps caps;
  caps.triangles.assign(count, false);
  if (areas.empty())
    return caps;
  const std::size_t largest = std::max_element(areas.begin(), areas.end(), [](const auto& a, const auto& b) {
                                return a.second < b.second;
                              })->first;
  Vec3 middle = Vec3::Zero(), normal = Vec3::Zero();
  double area = 0;
  for (std::size_t t = 0; t < count; ++t) {
    const auto row = static_cast<Eigen::Index>(t);
    if (!looks[t] || pieces.root(corner(t, 0)) != largest)
      continue;
    caps.triangles[t] = true;
    const double own = facets.normals.row(row).norm();
    middle += own * facets.middles.row(row).transpose();
    normal += facets.normals.row(row).transpose();
    area += own;
  }
  caps.caps = 1;
  caps.largestMiddle = middle / area;
  caps.largestNormal = normal.normalized();
  return caps;
}

} // namespace

ValveCaps valveCaps(const TriangleMesh& cavity, const std::optional<Vec3>& towardsBase) {
  const Facets facets = facetsOf(cavity);
  if (cavity.triangles.rows() < kFewestTriangles || !(facets.normals.rowwise().norm().sum() > 0))
    throw DataError("The surface encloses nothing", "heart", "choose the surface of its cavity");
  ValveCaps fans = fanCaps(cavity, facets);
  if (fans.caps > 0)
    return fans;
  Vec3 direction = towardsBase ? towardsBase->normalized() : baseDirection(facets);
  ValveCaps flat = flatCap(cavity, facets, direction);
  if (flat.caps == 0) {
    // A round end: the outermost vertex is its middle.
    Eigen::Index top = 0;
    (cavity.points * direction).maxCoeff(&top);
    flat.largestMiddle = cavity.points.row(top).transpose();
    flat.largestNormal = direction;
  } else if (!towardsBase) {
    // The long axis starts at the cap and ends at the farthest point, which need not be the principal axis.
    Eigen::Index tip = 0;
    (cavity.points.rowwise() - flat.largestMiddle.transpose()).rowwise().squaredNorm().maxCoeff(&tip);
    direction = (flat.largestMiddle - cavity.points.row(tip).transpose()).normalized();
    if (ValveCaps again = flatCap(cavity, facets, direction); again.caps > 0)
      flat = std::move(again);
  }
  return flat;
}

} // namespace viscera::strain
