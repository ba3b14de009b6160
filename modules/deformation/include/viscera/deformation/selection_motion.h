#pragma once

#include <vector>

#include "viscera/core/arrays.h"

/// Moves, rotates, scales and mirrors several selected handles at once. Each returns a new pose; handles
/// outside the selection stay.
namespace viscera::deformation {

/// A plane through `point` with unit `normal`.
struct MirrorPlane {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitX();
  Vec3 reflected(const Vec3& p) const { return p - 2 * normal.dot(p - point) * normal; }
  Vec3 reflectedDirection(const Vec3& d) const { return d - 2 * normal.dot(d) * normal; }
};

/// The mean of the selected handles.
Vec3 selectionCenter(const Points& pose, const std::vector<int>& selection);

/// The selection moved by `by` (mm).
Points translated(const Points& pose, const std::vector<int>& selection, const Vec3& by);

/// The selection turned about `center` by `angle` (rad) around the unit `axis`.
Points rotated(const Points& pose, const std::vector<int>& selection, const Vec3& center, const Vec3& axis,
               double angle);

/// The selection scaled about `center` by `factors` along x, y and z. Throws nothing; a factor of 0 flattens.
Points scaled(const Points& pose, const std::vector<int>& selection, const Vec3& center, const Vec3& factors);

/// Finds for each selected handle the one nearest to its mirror image at rest, or -1 when none is nearer
/// than `tolerance` (mm) or it is the handle itself. O(selection x n).
std::vector<int> mirrorPartners(const Points& rest, const std::vector<int>& selection,
                                const MirrorPlane& plane, double tolerance);

/// The selection moved by `by`, and each partner by the mirrored vector. A partner that is itself selected is
/// not moved twice.
Points mirroredTranslation(const Points& pose, const std::vector<int>& selection,
                           const std::vector<int>& partners, const MirrorPlane& plane, const Vec3& by);

} // namespace viscera::deformation
