#include "implicit/segment_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace viscera::sample_organs {
namespace {
constexpr int kLeafSize = 6;
constexpr int kDeepest = 64;       // 2^64 segments
constexpr double kSteepest = 0.9;  // radius per mm of axis; a ball that swallows its neighbour has no cone
constexpr double kShortest = 1e-9; // mm
} // namespace

SegmentTree::SegmentTree(const std::vector<AxisSample>& samples) {
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const AxisSample &from = samples[i], &to = samples[i + 1];
    RoundCone cone;
    cone.segment = static_cast<int>(i);
    cone.start = from.position;
    cone.length = std::max((to.position - from.position).norm(), kShortest);
    cone.direction = (to.position - from.position) / cone.length;
    cone.radius = from.radius;
    cone.rise = to.radius - from.radius;
    const double slope = std::clamp(cone.rise / cone.length, -kSteepest, kSteepest);
    cone.shift = slope / std::sqrt(1 - slope * slope);
    cones_.push_back(cone);
  }
  grow(0, static_cast<int>(cones_.size()));
}

int SegmentTree::grow(int begin, int end) {
  const int index = static_cast<int>(branches_.size());
  Branch branch;
  branch.begin = begin;
  branch.end = end;
  for (int i = begin; i < end; ++i) {
    const RoundCone& cone = cones_[static_cast<std::size_t>(i)];
    branch.box.include(cone.start);
    branch.box.include(Vec3(cone.start + cone.length * cone.direction));
    branch.radius = std::max({branch.radius, cone.radius, cone.radius + cone.rise});
  }
  branches_.push_back(branch);
  if (end - begin > kLeafSize) {
    const int middle = begin + (end - begin) / 2;
    int axis = 0;
    branch.box.size().maxCoeff(&axis);
    // Along space, not along the tube: the loops of a bowel lie side by side.
    std::nth_element(cones_.begin() + begin, cones_.begin() + middle, cones_.begin() + end,
                     [axis](const RoundCone& a, const RoundCone& b) {
                       return std::pair(a.start[axis], a.segment) < std::pair(b.start[axis], b.segment);
                     });
    grow(begin, middle);
    const int right = grow(middle, end);
    branches_[static_cast<std::size_t>(index)].right = right;
  }
  return index;
}

void SegmentTree::searchLeaf(const Branch& leaf, const Vec3& point, NearestOnAxis& best) const {
  for (int i = leaf.begin; i < leaf.end; ++i) {
    const RoundCone& cone = cones_[static_cast<std::size_t>(i)];
    const Vec3 offset = point - cone.start;
    const double along = offset.dot(cone.direction);
    const double away2 = std::max(offset.squaredNorm() - along * along, 0.0);
    const double t = std::clamp((along + std::sqrt(away2) * cone.shift) / cone.length, 0.0, 1.0);
    const double side = along - t * cone.length;
    const double distance = std::sqrt(away2 + side * side) - (cone.radius + t * cone.rise);
    if (distance < best.distance)
      best = {cone.segment, t, distance};
  }
}

NearestOnAxis SegmentTree::nearest(const Vec3& point, double limit) const {
  struct Visit {
    int branch;
    double axisDistance2; ///< From the box of the axis, squared.
  };
  const auto visitTo = [&](int branch) {
    return Visit{branch, branches_[static_cast<std::size_t>(branch)].box.distance2(point)};
  };
  std::array<Visit, kDeepest> open;
  std::size_t count = 0;
  open[count++] = visitTo(0);
  NearestOnAxis best{-1, 0, limit};
  while (count > 0) {
    const Visit visit = open[--count];
    const Branch& branch = branches_[static_cast<std::size_t>(visit.branch)];
    if (isFarther(branch, visit.axisDistance2, best.distance))
      continue;
    if (branch.right == 0) {
      searchLeaf(branch, point, best);
      continue;
    }
    Visit near = visitTo(visit.branch + 1), far = visitTo(branch.right);
    if (far.axisDistance2 < near.axisDistance2)
      std::swap(near, far);
    open[count++] = far;
    open[count++] = near;
  }
  return best;
}

} // namespace viscera::sample_organs
