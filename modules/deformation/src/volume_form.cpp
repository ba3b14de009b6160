#include "viscera/deformation/volume_form.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>

#include <Eigen/Geometry>

#include "viscera/coordinates/corner_determinants.h"
#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

/// How far the form and the surface may differ in the trial pose, in units of the cube of its size.
constexpr double kAllowedDifference = 1e-11;
constexpr unsigned kTrialSeed = 20;
/// Above this the form takes longer to make than a user would wait at the first drag.
constexpr double kMostWork = 4e9;

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

bool VolumeForm::pays(Eigen::Index points, Eigen::Index handles) {
  // Made in O(points x handles^3); 4e9 take one processor half a second.
  const double squared = static_cast<double>(handles) * static_cast<double>(handles);
  const double making = 2.0 / 3 * static_cast<double>(points) * squared * static_cast<double>(handles);
  return squared <= static_cast<double>(points) && making <= kMostWork;
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
  const coordinates::CornerDeterminants determinants(binding, rest.triangles);
  std::vector<Eigen::MatrixXd> slices(static_cast<std::size_t>(count), Eigen::MatrixXd::Zero(count, count));
  const auto slice = [&slices](Eigen::Index i) -> Eigen::MatrixXd& {
    return slices[static_cast<std::size_t>(i)];
  };
  // The last handles first: they are the longest work.
  parallelRanges(count, 1, threads, [&](Eigen::Index begin, Eigen::Index) {
    progress.throwIfCancelled();
    const Eigen::Index k = count - 1 - begin;
    coordinates::CornerDeterminants::Sums sums;
    determinants.ofHandle(k, sums);
    // T_ijk is the same for even and the opposite for odd orders of i, j, k.
    for (Eigen::Index i = 0; i < k; ++i)
      for (Eigen::Index j = i + 1; j < k; ++j) {
        const double value = sums(i, j) / 6;
        slice(i)(j, k) = slice(j)(k, i) = slice(k)(i, j) = value;
        slice(i)(k, j) = slice(j)(i, k) = slice(k)(j, i) = -value;
      }
  });

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
