#include "viscera/geometry/convex_hull.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

// Qhull's reentrant C interface; its header checks that it is compiled as C where it must be.
extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <Eigen/Eigenvalues>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::geometry {
namespace {

/// Owns Qhull's state and its memory. Qhull reports by longjmp inside `qh_new_qhull`, which returns a code to
/// us.
class Qhull {
public:
  Qhull() { qh_zero(&state_, stderr); }
  ~Qhull() {
    qh_freeqhull(&state_, !qh_ALL);
    int curlong = 0, totlong = 0;
    qh_memfreeshort(&state_, &curlong, &totlong);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  bool run(Points& points, std::string command) {
    // Qhull's diagnostics go nowhere: our own message says what a user can do about it.
    std::FILE* silent = std::fopen("/dev/null", "w");
    const int code = qh_new_qhull(&state_, 3, static_cast<int>(points.rows()), points.data(), False,
                                  command.data(), nullptr, silent);
    if (silent != nullptr)
      std::fclose(silent);
    return code == 0;
  }
  qhT* state() { return &state_; }

  /// The first `count` corners of a facet.
  template <int Count>
  Eigen::Matrix<int, Count, 1> cornersOf(const facetT* facet) {
    Eigen::Matrix<int, Count, 1> corners = Eigen::Matrix<int, Count, 1>::Zero();
    int k = 0;
    vertexT *vertex = nullptr, **vertexp = nullptr;
    FOREACHvertex_(facet->vertices) {
      if (k < Count)
        corners[k++] = qh_pointid(&state_, vertex->point);
    }
    return corners;
  }

private:
  qhT state_;
};

constexpr double kFlat = 1e-9;

void requireUsable(const Points& points) {
  if (points.rows() < 4)
    throw DataError(misuse("a convex hull needs at least 4 points, there are %1", points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (!points.row(i).allFinite())
      throw DataError(diagnostic("point %1 has a coordinate that is not a finite number", i));
  // The extent along the direction in which the points are thinnest.
  const Points centered = points.rowwise() - points.colwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(centered.transpose() * centered);
  const double thickness = (centered * axes.eigenvectors().col(0)).cwiseAbs().maxCoeff();
  if (thickness <= kFlat * boundsOf(points).diagonal())
    throw DataError("all points lie in one plane", {}, "move one out of the plane");
}

} // namespace

std::optional<HullFacets> hullFacets(const Points& points) {
  Points copy = points;
  Qhull qhull;
  if (!qhull.run(copy, "qhull Qt Pp"))
    return std::nullopt;
  qhT* qh = qhull.state();
  HullFacets facets;
  facets.triangles.resize(qh->num_facets, 3);
  facets.planes.resize(qh->num_facets, 4);
  Eigen::Index next = 0;
  facetT* facet = nullptr;
  FORALLfacets {
    const Vec3 normal(facet->normal[0], facet->normal[1], facet->normal[2]);
    Eigen::Vector3i corners = qhull.cornersOf<3>(facet);
    const Vec3 a = points.row(corners[0]).transpose(), b = points.row(corners[1]).transpose(),
               c = points.row(corners[2]).transpose();
    if ((b - a).cross(c - a).dot(normal) < 0)
      std::swap(corners[1], corners[2]);
    facets.triangles.row(next) = corners.transpose();
    facets.planes.row(next++) << normal.transpose(), facet->offset;
  }
  return facets;
}

Tetrahedra delaunayTetrahedra(const Points& points) {
  // About the centre: Qhull's own tolerances grow with the largest coordinate.
  Points local = points.rowwise() - boundsOf(points).center().transpose();
  Qhull qhull;
  std::vector<Eigen::Vector4i> found;
  if (qhull.run(local, "qhull d Qt Qbb Qc Qz Pp")) {
    qhT* qh = qhull.state();
    facetT* facet = nullptr;
    FORALLfacets {
      if (!facet->upperdelaunay)
        found.push_back(qhull.cornersOf<4>(facet));
    }
  }
  if (found.empty())
    throw DataError(phrase("the Delaunay tetrahedra of %1 points cannot be computed", points.rows()), {},
                    "points that coincide or are almost flat cause this");
  Tetrahedra tetrahedra(static_cast<Eigen::Index>(found.size()), 4);
  for (std::size_t i = 0; i < found.size(); ++i)
    tetrahedra.row(static_cast<Eigen::Index>(i)) = found[i].transpose();
  return tetrahedra;
}

ConvexHull::ConvexHull(const Points& points) : diagonal_(boundsOf(points).diagonal()) {
  requireUsable(points);
  // About the centre: Qhull's own tolerances grow with the largest coordinate.
  const Vec3 center = boundsOf(points).center();
  const auto facets = hullFacets(points.rowwise() - center.transpose());
  if (!facets)
    throw DataError(phrase("the convex hull of %1 points cannot be computed", points.rows()), {},
                    "points that coincide or are almost flat cause this");
  triangles_ = facets->triangles;
  std::vector<Eigen::Vector4d> planes;
  for (Eigen::Index facet = 0; facet < facets->planes.rows(); ++facet) {
    Eigen::Vector4d plane = facets->planes.row(facet).transpose();
    plane[3] -= plane.head<3>().dot(center);
    const bool known = std::any_of(planes.begin(), planes.end(), [&](const Eigen::Vector4d& p) {
      return (p.head<3>() - plane.head<3>()).norm() < kFlat && std::abs(p[3] - plane[3]) < kFlat * diagonal_;
    });
    if (!known)
      planes.push_back(plane);
  }
  planes_.resize(static_cast<Eigen::Index>(planes.size()), 4);
  for (std::size_t i = 0; i < planes.size(); ++i)
    planes_.row(static_cast<Eigen::Index>(i)) = planes[i].transpose();
}

double ConvexHull::signedDistance(const Vec3& point) const {
  return (planes_.leftCols<3>() * point + planes_.col(3)).maxCoeff();
}

std::vector<int> ConvexHull::outside(const Points& points, double margin) const {
  std::vector<int> list;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (signedDistance(points.row(i).transpose()) > margin)
      list.push_back(static_cast<int>(i));
  return list;
}

} // namespace viscera::geometry
