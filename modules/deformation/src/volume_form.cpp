#include "viscera/deformation/volume_form.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>

#include <Eigen/Geometry>

#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Vertices whose rows are multiplied at once: they stay in the cache.
constexpr Eigen::Index kVerticesOfABlock = 256;
/// How far the form and the surface may differ in the trial pose, in units of the cube of its size.
constexpr double kAllowedDifference = 1e-11;
constexpr unsigned kTrialSeed = 20;

RowMatrix weightsOf(const coordinates::Binding& binding) {
  RowMatrix weights(binding.pointCount(), binding.handleCount());
  for (int handle = 0; handle < weights.cols(); ++handle)
    weights.col(handle) = binding.influence(handle);
  return weights;
}

/// `M(i, j) = sum a_i(p) a_j(q) a_k(r)` over the triangles, each in its three rotations (p, q, r); for
/// i, j < k.
Eigen::MatrixXd productsWith(Eigen::Index k, const RowMatrix& weights, const Triangles& triangles,
                             const geometry::VertexTriangles& around) {
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(k, k);
  RowMatrix rows(kVerticesOfABlock, k);
  for (Eigen::Index first = 0; first < weights.rows(); first += kVerticesOfABlock) {
    const Eigen::Index count = std::min(kVerticesOfABlock, weights.rows() - first);
    rows.topRows(count).setZero();
    for (Eigen::Index lane = 0; lane < count; ++lane)
      for (auto item = around.first[std::size_t(first + lane)];
           item < around.first[std::size_t(first + lane + 1)]; ++item) {
        const auto corners = triangles.row(around.items[std::size_t(item)]);
        const int corner = corners[0] == first + lane ? 0 : corners[1] == first + lane ? 1 : 2;
        const double weight = weights(corners[(corner + 2) % 3], k);
        if (weight != 0)
          rows.row(lane) += weight * weights.row(corners[(corner + 1) % 3]).head(k);
      }
    products.noalias() += weights.block(first, 0, count, k).transpose() * rows.topRows(count);
  }
  return products;
}

/// Positions about as large as the organ, relative to its middle.
Points trialPose(const geometry::TriangleMesh& rest, Eigen::Index handles) {
  const double size = boundsOf(rest.points).diagonal();
  std::mt19937 random(kTrialSeed);
  std::uniform_real_distribution<double> position(-size, size);
  Points pose(handles, 3);
  for (Eigen::Index i = 0; i < pose.size(); ++i)
    pose.data()[i] = position(random);
  return pose;
}

} // namespace

double VolumeForm::work(Eigen::Index points, Eigen::Index handles) {
  return 2.0 / 3 * static_cast<double>(points) * std::pow(static_cast<double>(handles), 3);
}

std::optional<VolumeForm> VolumeForm::of(const geometry::TriangleMesh& rest,
                                         const coordinates::Binding& binding, Threads threads) {
  Progress ignored;
  return of(rest, binding, threads, ignored);
}

std::optional<VolumeForm> VolumeForm::of(const geometry::TriangleMesh& rest,
                                         const coordinates::Binding& binding, Threads threads,
                                         Progress& progress) {
  const Eigen::Index count = binding.handleCount();
  assert(rest.points.rows() == binding.pointCount());
  progress.throwIfCancelled();
  const RowMatrix weights = weightsOf(binding);
  const auto around = geometry::vertexTriangles(rest.points.rows(), rest.triangles);
  std::vector<Eigen::MatrixXd> products(static_cast<std::size_t>(count));
  // The last handles first: they are the longest work.
  parallelRanges(count, 1, threads, [&](Eigen::Index begin, Eigen::Index) {
    progress.throwIfCancelled();
    const Eigen::Index k = count - 1 - begin;
    products[static_cast<std::size_t>(k)] = productsWith(k, weights, rest.triangles, around);
  });

  std::vector<Eigen::MatrixXd> slices(static_cast<std::size_t>(count), Eigen::MatrixXd::Zero(count, count));
  const auto slice = [&slices](Eigen::Index i) -> Eigen::MatrixXd& {
    return slices[static_cast<std::size_t>(i)];
  };
  // T_ijk = (M_k(i, j) - M_k(j, i)) / 6, the same for even and the opposite for odd orders of i, j, k.
  for (Eigen::Index k = 0; k < count; ++k)
    for (Eigen::Index j = 0; j < k; ++j)
      for (Eigen::Index i = 0; i < j; ++i) {
        const Eigen::MatrixXd& found = products[static_cast<std::size_t>(k)];
        const double value = (found(i, j) - found(j, i)) / 6;
        slice(i)(j, k) = slice(j)(k, i) = slice(k)(i, j) = value;
        slice(i)(k, j) = slice(j)(i, k) = slice(k)(j, i) = -value;
      }

  VolumeForm form(std::move(slices));
  const Points trial = trialPose(rest, count);
  Points points;
  binding.deform(trial, points, threads);
  const double size = boundsOf(rest.points).diagonal();
  const double difference = std::abs(form.volume(trial) - geometry::volume(points, rest.triangles, threads));
  if (!(difference <= kAllowedDifference * size * size * size))
    return std::nullopt;
  return form;
}

void VolumeForm::gradient(const Points& pose, Points& out) const {
  assert(pose.rows() == handles());
  // The volume does not change when all handles move together; about their middle the least is lost.
  const Points centered = pose.rowwise() - pose.colwise().mean();
  // dV / dv_i = 1/2 sum_j v_j x (sum_k T_ijk v_k).
  out.resize(handles(), 3);
  Points seen(handles(), 3);
  for (Eigen::Index i = 0; i < handles(); ++i) {
    seen.noalias() = slices_[static_cast<std::size_t>(i)] * centered;
    Vec3 sum = Vec3::Zero();
    for (Eigen::Index j = 0; j < handles(); ++j)
      sum += Vec3(centered.row(j)).cross(Vec3(seen.row(j)));
    out.row(i) = 0.5 * sum.transpose();
  }
}

double VolumeForm::volume(const Points& pose) const {
  Points slope;
  gradient(pose, slope);
  // A form of the third degree is a third of its derivative along its own argument.
  const Points centered = pose.rowwise() - pose.colwise().mean();
  return centered.cwiseProduct(slope).sum() / 3;
}

std::array<double, 4> VolumeForm::along(const Points& pose, const Points& direction) const {
  // V(H + s U) = V(H) + s grad V(H).U + s^2 H.grad V(U) + s^3 V(U).
  Points atPose, atDirection;
  gradient(pose, atPose);
  gradient(direction, atDirection);
  const Points centered = pose.rowwise() - pose.colwise().mean();
  const Points relative = direction.rowwise() - direction.colwise().mean();
  return {centered.cwiseProduct(atPose).sum() / 3, relative.cwiseProduct(atPose).sum(),
          centered.cwiseProduct(atDirection).sum(), relative.cwiseProduct(atDirection).sum() / 3};
}

} // namespace viscera::deformation
