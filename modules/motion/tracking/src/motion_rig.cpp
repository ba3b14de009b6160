#include "viscera/tracking/motion_rig.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/QR>

#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/geometry/normals.h"
#include "viscera/geometry/volume.h"
#include "viscera/tracking/surface_series.h"

namespace viscera::tracking {
namespace {

constexpr int kCorners = 8;
constexpr int kFewestOfASurface = 4;
constexpr int kHandlesOfOne = 60, kHandlesOfSeveral = 120;
constexpr double kOuterShare = 0.4;
constexpr double kOffsetOfDiagonal = 0.025;
/// Part of the offset: no two handles are nearer to each other.
constexpr double kClearance = 0.25;

/// How many handles each surface gets.
std::vector<int> sharesOf(std::size_t surfaces, std::size_t outer, int handles) {
  const int free = handles - kCorners;
  if (free < kFewestOfASurface * static_cast<int>(surfaces))
    throw DataError(phrase("%2 handles are too few for %n {surface|surfaces}", surfaces, handles), "handles",
                    phrase("ask for at least %1", kCorners + kFewestOfASurface * static_cast<int>(surfaces)));
  if (surfaces == 1)
    return {free};
  std::vector<int> counts(surfaces);
  int left = free;
  for (std::size_t i = 0; i < surfaces; ++i) {
    const double part = i == outer ? kOuterShare : (1 - kOuterShare) / static_cast<double>(surfaces - 1);
    counts[i] = std::max(kFewestOfASurface, static_cast<int>(std::lround(part * free)));
    left -= counts[i];
  }
  counts[outer] += left; // The remainder from rounding.
  return counts;
}

/// Farthest points of one surface, moved off the wall; appended to `handles` behind its first `placed` rows.
void placeOn(const geometry::TriangleMesh& mesh, int count, double offset, Points& handles,
             Eigen::Index& placed) {
  const geometry::Normals normals = geometry::vertexNormals(mesh);
  const Eigen::RowVector3d middle = mesh.points.colwise().mean();
  Values nearest = (mesh.points.rowwise() - middle).rowwise().squaredNorm();
  bool first = true;
  for (int done = 0; done < count;) {
    Eigen::Index vertex = 0;
    if (!(nearest.maxCoeff(&vertex) > 0))
      throw DataError(phrase("the surface has room for %1 of %2 handles", done, count), "handles",
                      "ask for fewer");
    const Eigen::RowVector3d at = mesh.points.row(vertex);
    const Eigen::RowVector3d handle = at + offset * normals.row(vertex).cast<double>();
    const double clearance =
        placed == 0
            ? std::numeric_limits<double>::infinity()
            : std::sqrt((handles.topRows(placed).rowwise() - handle).rowwise().squaredNorm().minCoeff());
    if (clearance < kClearance * std::abs(offset)) {
      nearest[vertex] = 0; // Its handle would stand on another one.
      continue;
    }
    handles.row(placed++) = handle;
    ++done;
    const Values distance = (mesh.points.rowwise() - at).rowwise().squaredNorm();
    nearest = first ? distance : Values(nearest.cwiseMin(distance));
    first = false;
  }
}

/// The projector onto what is no affine map of the handles.
Eigen::MatrixXd bendingOf(const Points& handles) {
  const Eigen::Index n = handles.rows();
  Eigen::MatrixXd affine(n, 4);
  affine.col(0).setOnes();
  affine.rightCols<3>() = handles.rowwise() - handles.colwise().mean();
  affine.rightCols<3>() /= std::max(affine.rightCols<3>().cwiseAbs().maxCoeff(), 1e-12);
  // I - Q Q^T with [1, h] = Q R: affine motions of the handles, which are combinations of these four columns,
  // cost nothing.
  const Eigen::MatrixXd q =
      Eigen::HouseholderQR<Eigen::MatrixXd>(affine).householderQ() * Eigen::MatrixXd::Identity(n, 4);
  return Eigen::MatrixXd::Identity(n, n) - q * q.transpose();
}

} // namespace

RigHandles placeMotionHandles(const std::vector<geometry::TriangleMesh>& surfaces, std::size_t outer,
                              const RigOptions& options) {
  const int count = options.handles > 0   ? options.handles
                    : surfaces.size() > 1 ? kHandlesOfSeveral
                                          : kHandlesOfOne;
  const std::vector<int> shares = sharesOf(surfaces.size(), outer, count);
  Eigen::Index points = 0;
  for (const geometry::TriangleMesh& surface : surfaces)
    points += surface.points.rows();
  Points all(points, 3);
  points = 0;
  for (const geometry::TriangleMesh& surface : surfaces) {
    all.middleRows(points, surface.points.rows()) = surface.points;
    points += surface.points.rows();
  }
  const double offset = options.offsetMm > 0
                            ? options.offsetMm
                            : kOffsetOfDiagonal * boundsOf(surfaces[outer].points).diagonal();
  RigHandles rig{Points(count, 3), std::vector<int>(kCorners, -1)};
  rig.rest.topRows(kCorners) = deformation::enclosingHandles(all);
  Eigen::Index placed = kCorners;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    placeOn(surfaces[i], shares[i], i == outer ? offset : -offset, rig.rest, placed);
    rig.ofSurface.resize(static_cast<std::size_t>(placed), static_cast<int>(i));
  }
  return rig;
}

double softnessFor(const Points& handles, Eigen::Index corners, double spacings) {
  const Eigen::Index count = handles.rows() - corners;
  if (count < 2)
    return 0;
  std::vector<double> nearest;
  const auto own = handles.bottomRows(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    Values distances = (own.rowwise() - own.row(i)).rowwise().norm();
    distances[i] = std::numeric_limits<double>::infinity();
    nearest.push_back(distances.minCoeff());
  }
  std::sort(nearest.begin(), nearest.end());
  const std::size_t half = nearest.size() / 2;
  const double median = nearest.size() % 2 == 1 ? nearest[half] : (nearest[half - 1] + nearest[half]) / 2;
  return spacings * median;
}

MotionRig::MotionRig(std::vector<geometry::TriangleMesh> surfaces, Points handles, double locality,
                     double softnessMm, Progress& progress, Threads threads)
    : surfaces_(std::move(surfaces)), rest_(std::move(handles)), locality_(locality),
      softnessMm_(softnessMm) {
  Eigen::Index rows = 0;
  for (const geometry::TriangleMesh& surface : surfaces_) {
    first_.push_back(rows);
    rows += surface.points.rows();
  }
  Points points(rows, 3);
  shares_.resize(rows);
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    points.middleRows(first_[i], this->rows(i)) = surfaces_[i].points;
    const Values areas = vertexAreas(surfaces_[i].points, surfaces_[i].triangles);
    shares_.segment(first_[i], this->rows(i)) = areas / (areas.sum() * static_cast<double>(surfaces_.size()));
  }
  coordinates::BindOptions options;
  options.parameters.set("locality", locality);
  options.parameters.set("softness", softnessMm);
  options.threads = threads;
  coordinates::HandleSet set;
  set.positions = rest_;
  const auto binding = deformation::bindOrgan(*coordinates::sCelestial(), set, points, options, progress);
  weights_.resize(rows, rest_.rows());
  for (Eigen::Index handle = 0; handle < rest_.rows(); ++handle)
    weights_.col(handle) = binding->influence(static_cast<int>(handle));
  bending_ = bendingOf(rest_);
}

Points MotionRig::vertices(const Points& pose, std::size_t surface) const {
  return weights_.middleRows(first_[surface], rows(surface)) * pose;
}

Values MotionRig::volumesMl(const Points& vertices) const {
  Values volumes(static_cast<Eigen::Index>(surfaces_.size()));
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    volumes[static_cast<Eigen::Index>(i)] =
        geometry::volume(vertices.middleRows(first_[i], rows(i)), surfaces_[i].triangles, Threads{1}) /
        kMm3PerMl;
  return volumes;
}

} // namespace viscera::tracking
