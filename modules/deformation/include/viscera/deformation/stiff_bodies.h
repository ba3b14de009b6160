#pragma once

#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include "viscera/core/progress.h"
#include "viscera/deformation/inverse_map.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::deformation {

/// Organs that do not bend, in a space that does: bones in a warped scan. Inside of such an organ the space
/// moves as the organ does, by a rotation and a translation; around it that motion passes smoothly into the
/// one of the soft tissue, over a few times the distance by which the two differ at the organ's surface.
/// Between two bodies the motions are mixed by their distances. Distances are kept on a grid around each
/// body, so that a sample costs about a tenth of a microsecond for each body that is near.
///
///     StiffBodies bones({femur->mesh}, {}, progress);
///     bones.setPose({&posedFemur}, map);
///     map.restPlane(plane, rest);
///     bones.stiffen(plane, rest);
///
/// Immutable but for `setPose`; results do not depend on the number of threads.
class StiffBodies {
public:
  /// Measures the distances around each surface at rest, mm, which may have holes; all have triangles. Some
  /// tenths of a second for each. Throws `Cancelled`.
  StiffBodies(std::vector<std::shared_ptr<const geometry::TriangleMesh>> rest, Threads threads,
              Progress& progress);

  bool empty() const { return bodies_.empty(); }

  /// Takes where the vertices of each body are in the pose of `soft`, in the order of the constructor. What
  /// does not fit to a rotation and a translation is left out. O(vertices).
  void setPose(const std::vector<const Points*>& posed, const InverseMap& soft);

  /// Changes the result of `soft.restPlane` for this plane, refined or not: samples in a body get their
  /// places at rest in that body, those around it places between these and their own. Samples in a body are
  /// not folded.
  void stiffen(const SamplePlane& plane, RestPoints& rest) const;

  /// Where the tissue at a posed place was at rest, mm, with `soft` in the pose of `setPose`; and the
  /// reverse, to a hundredth of a millimetre where nothing is folded.
  Vec3 restOf(const InverseMap& soft, const Vec3& posed) const;
  Vec3 posedOf(const InverseMap& soft, const Vec3& rest) const;

private:
  /// A body, the distances around it and its present motion.
  struct Body {
    std::shared_ptr<const geometry::TriangleMesh> rest;
    Vec3 origin = Vec3::Zero(); ///< The first node of the grid of distances, mm.
    double spacing = 1;         ///< mm.
    Eigen::Vector3i size = Eigen::Vector3i::Zero();
    std::vector<float> distances; ///< mm, negative inside; x first.
    Eigen::Isometry3d toPose = Eigen::Isometry3d::Identity();
    Eigen::Isometry3d toRest = Eigen::Isometry3d::Identity();
    double band = 0; ///< mm around the surface in which the motions are mixed.

    double distanceAt(const Vec3& restPlace) const;
    double weightAt(const Vec3& restPlace) const;
  };
  /// The share of the soft tissue in the motion of a place, and that of each body times its place.
  struct Mix {
    double soft = 1;
    Vec3 ofBodies = Vec3::Zero();
    bool touched() const { return soft < 1; }
    Vec3 with(const Vec3& softPlace) const { return soft * softPlace + ofBodies; }
  };
  Mix mixed(const std::vector<double>& weights, const std::vector<Vec3>& places) const;
  Mix mixAtPosed(const Vec3& posed) const;

  static Body bodyOf(std::shared_ptr<const geometry::TriangleMesh> rest, Threads threads, Progress& progress);

  std::vector<Body> bodies_;
  Threads threads_;
};

} // namespace viscera::deformation
