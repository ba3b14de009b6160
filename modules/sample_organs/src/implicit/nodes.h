#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "implicit/implicit_node.h"

/// Creates the nodes of implicit surfaces that definitions combine, apart from the tube (tube.h).
namespace viscera::sample_organs {

/// A node that may still be given its finish.
using NewNode = std::shared_ptr<ImplicitNode>;

/// An ellipsoid; its distance is the first-order one, exact on the surface and along the axes. `axes` holds
/// the directions of the semi-axes as columns, orthonormal; `radii` in mm, positive.
NewNode makeEllipsoid(const Vec3& center, const Vec3& radii, const Eigen::Matrix3d& axes);

/// All that lies behind a plane. Only useful inside an intersection or a subtraction. `normal` points out of
/// the half space; of length 1.
NewNode makeHalfSpace(const Vec3& point, const Vec3& normal);

/// Everything inside any of the children (at least one), with fillets of `blend` mm where they meet. Colours
/// mix across the seams.
NewNode makeUnion(std::vector<NodePtr> children, double blend);

/// What is inside all children (at least one), with rounded edges of `blend` mm. Looks like the first child.
NewNode makeIntersection(std::vector<NodePtr> children, double blend);

/// What is inside `body` and outside all `cuts`, with rounded edges of `blend` mm. Looks like the body.
NewNode makeSubtraction(const NodePtr& body, std::vector<NodePtr> cuts, double blend);

/// The child grown (or, with a negative distance, shrunk) by `distance` mm.
NewNode makeOffset(const NodePtr& child, double distance);

/// How a displacement roughens a surface.
struct Roughness {
  double amplitude = 1;   ///< mm, of the first octave.
  double wavelength = 20; ///< mm, of the first octave.
  int octaves = 1;        ///< Each with about half the amplitude and half the wavelength of the one before.
  int seed = 1;
};
/// The child with gentle bumps, for a natural look.
NewNode makeDisplacement(const NodePtr& child, const Roughness& roughness);

/// The placement of a child's own frame: `world = origin + rotation * scale * mirror * local`.
struct Placement {
  Vec3 origin = Vec3::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 mirror = Vec3::Ones(); ///< 1 or -1 along each local axis.
  double scale = 1;
};
/// The child placed in its own frame.
NewNode makeFrame(const NodePtr& child, const Placement& placement);

/// A tube on the surface of a body.
struct SurfaceVessel {
  NodePtr node;
  double seam = 0.35; ///< mm on either side of its edge over which the colours mix.
};
/// A body with vessels or fat on its surface, which blend into it over `blend` mm.
NewNode makeSurfaceVessels(const NodePtr& base, std::vector<SurfaceVessel> vessels, double blend);

} // namespace viscera::sample_organs
