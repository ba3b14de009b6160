#include "viscera/deformation/selection_motion.h"

#include <algorithm>
#include <cassert>

namespace viscera::deformation {
namespace {

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

} // namespace

Vec3 selectionCenter(const Points& pose, const std::vector<int>& selection) {
  Vec3 sum = Vec3::Zero();
  for (const int handle : selection)
    sum += pose.row(handle).transpose();
  return selection.empty() ? sum : Vec3(sum / static_cast<double>(selection.size()));
}

Points translated(const Points& pose, const std::vector<int>& selection, const Vec3& by) {
  Points moved = pose;
  for (const int handle : selection)
    moved.row(handle) += by.transpose();
  return moved;
}

Points rotated(const Points& pose, const std::vector<int>& selection, const Vec3& center, const Vec3& axis,
               double angle) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  Points moved = pose;
  for (const int handle : selection)
    moved.row(handle) = (center + turn * (pose.row(handle).transpose() - center)).transpose();
  return moved;
}

Points scaled(const Points& pose, const std::vector<int>& selection, const Vec3& center,
              const Vec3& factors) {
  Points moved = pose;
  for (const int handle : selection)
    moved.row(handle) = (center + factors.cwiseProduct(pose.row(handle).transpose() - center)).transpose();
  return moved;
}

std::vector<int> mirrorPartners(const Points& rest, const std::vector<int>& selection,
                                const MirrorPlane& plane, double tolerance) {
  std::vector<int> partners;
  for (const int handle : selection) {
    const Vec3 image = plane.reflected(rest.row(handle).transpose());
    Eigen::Index nearest = 0;
    const double distance = (rest.rowwise() - image.transpose()).rowwise().norm().minCoeff(&nearest);
    partners.push_back(distance <= tolerance && nearest != handle ? static_cast<int>(nearest) : -1);
  }
  return partners;
}

Points mirroredTranslation(const Points& pose, const std::vector<int>& selection,
                           const std::vector<int>& partners, const MirrorPlane& plane, const Vec3& by) {
  assert(selection.size() == partners.size());
  Points moved = translated(pose, selection, by);
  const Vec3 mirrored = plane.reflectedDirection(by);
  std::vector<int> done;
  for (const int partner : partners) {
    if (partner < 0 || contains(selection, partner) || contains(done, partner))
      continue;
    moved.row(partner) += mirrored.transpose();
    done.push_back(partner);
  }
  return moved;
}

} // namespace viscera::deformation
