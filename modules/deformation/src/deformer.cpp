#include "viscera/deformation/deformer.h"

#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

std::shared_ptr<const Points> withRow(const Points& pose, int handle, const Vec3& position) {
  auto moved = std::make_shared<Points>(pose);
  moved->row(handle) = position.transpose();
  return moved;
}

} // namespace

Deformer::Deformer(std::shared_ptr<const geometry::TriangleMesh> rest,
                   std::shared_ptr<const coordinates::Binding> binding, Points restHandles, Threads threads)
    : rest_(std::move(rest)), binding_(std::move(binding)),
      around_(geometry::vertexTriangles(rest_->points.rows(), rest_->triangles)),
      restHandles_(std::make_shared<const Points>(std::move(restHandles))), threads_(threads),
      pose_(restHandles_), points_(rest_->points),
      restVolume_(geometry::volume(rest_->points, rest_->triangles, threads)) {
  assert(binding_->pointCount() == rest_->points.rows());
  assert(binding_->handleCount() == restHandles_->rows());
}

void Deformer::requirePose(const Points& pose) const {
  if (pose.rows() != restHandles_->rows())
    throw DataError(misuse("the pose has %n {handle|handles}, the organ is bound to %2", pose.rows(),
                           restHandles_->rows()),
                    "pose", misuse("use a pose of the same handles"));
  for (Eigen::Index handle = 0; handle < pose.rows(); ++handle)
    if (!pose.row(handle).allFinite())
      throw DataError("the position is not finite", phrase("handle %1", handle), "place the handle again");
}

void Deformer::setPose(const Points& pose) {
  requirePose(pose);
  pose_ = std::make_shared<const Points>(pose);
  binding_->deform(*pose_, points_, threads_);
  changed();
}

/// Works as `setPose`, but the points follow in pieces.
PiecesOfWork Deformer::poseInPieces(std::shared_ptr<const Points> pose) {
  pose_ = std::move(pose);
  changed();
  return binding_->deformInPieces(*pose_, points_);
}

/// Works as `moveHandle` of each of these, but the points follow in pieces.
PiecesOfWork Deformer::moveInPieces(std::shared_ptr<const Points> pose, const std::vector<int>& moved) {
  std::vector<PiecesOfWork> works;
  std::shared_ptr<const Points> before = pose_;
  for (std::size_t k = 0; k < moved.size(); ++k) {
    const int handle = moved[k];
    PiecesOfWork work = binding_->moveHandleInPieces(
        *before, handle, (pose->row(handle) - before->row(handle)).transpose(), points_);
    works.push_back({work.count, [before, run = std::move(work.run)](Eigen::Index piece) { run(piece); }});
    if (k + 1 < moved.size())
      before = withRow(*before, handle, pose->row(handle).transpose());
  }
  pose_ = std::move(pose);
  changed();
  return inTurn(std::move(works));
}

void Deformer::moveHandle(int handle, const Vec3& position) {
  assert(handle >= 0 && handle < pose_->rows());
  if (!position.allFinite())
    throw DataError("the position is not finite", phrase("handle %1", handle), "place the handle again");
  const Vec3 delta = position - pose_->row(handle).transpose();
  binding_->moveHandle(*pose_, handle, delta, points_, threads_);
  pose_ = withRow(*pose_, handle, position);
  changed();
}

void Deformer::reset() {
  pose_ = restHandles_;
  points_ = rest_->points;
  changed();
}

const geometry::Normals& Deformer::normals() {
  if (!normalsValid_)
    geometry::vertexNormals(points_, rest_->triangles, around_, normals_, threads_);
  normalsValid_ = true;
  return normals_;
}

double Deformer::volumeMm3() {
  if (!volumeValid_)
    volume_ = geometry::volume(points_, rest_->triangles, threads_);
  volumeValid_ = true;
  return volume_;
}

const Points& Deformer::volumeGradient() {
  if (!gradientValid_) {
    geometry::volumeGradient(points_, rest_->triangles, around_, pointGradient_, threads_);
    binding_->pullBack(*pose_, pointGradient_, handleGradient_, threads_);
  }
  gradientValid_ = true;
  return handleGradient_;
}

double Deformer::maxDisplacementMm() const {
  return points_.rows() == 0 ? 0 : std::sqrt((points_ - rest_->points).rowwise().squaredNorm().maxCoeff());
}

void Deformer::changed() {
  normalsValid_ = volumeValid_ = gradientValid_ = false;
}

} // namespace viscera::deformation
