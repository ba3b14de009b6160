#pragma once

#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/heart/heart_frame.h"
#include "viscera/sequences/rig_parts.h"
#include "viscera/sequences/sequence.h"

namespace viscera::heart {

/// The part of the heart that a handle moves with.
enum class HeartRole {
  leftEndocardium, ///< On the wall of the left ventricle's cavity.
  epicardium,      ///< A little outside the ventricles.
  rightFreeWall,   ///< On the outer wall of the right ventricle's cavity.
  septum,          ///< On the right side of the wall between the ventricles.
  atrium,          ///< A little outside an atrium.
  vessel,          ///< Around a great vessel.
  farCorner,       ///< A corner of the box that keeps the whole organ inside the handles' hull.
};

/// A surface of revolution about the heart's long axis: an ellipse, of which the base cuts off the top.
struct HeartShell {
  double radius = 0;     ///< Largest distance from the axis, mm.
  double center = 0;     ///< Where along the axis (c, mm) that is.
  double halfLength = 0; ///< Half the length of the whole ellipse, mm.

  /// The distance from the axis at `c`; 0 beyond the ends.
  double radiusAt(double c) const;
  double apex() const { return center + halfLength; }
};

/// Surface, centre and appendage of an atrium.
struct AtriumAnatomy {
  sequences::AnatomySurface surface;
  Vec3 center = Vec3::Zero();  ///< The point towards which it contracts, mm.
  std::vector<Vec3> appendage; ///< Where handles go along its ear, mm.
  /// Whether it is the left one, which follows the left values of `AtrialState`.
  bool left = false;
};

/// Handles around a great vessel.
struct VesselRing {
  Vec3 center = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double radius = 0; ///< mm; 0 for one handle at the centre.
  int count = 1;
  double follow = 0; ///< The part of the base's descent in which the vessel takes part here, 0 to 1.
};

/// The measures of a heart that are needed to place handles around it.
struct HeartAnatomy {
  HeartFrame frame;
  HeartShell endocardium; ///< The left ventricle's cavity.
  HeartShell epicardium;  ///< The left ventricle from outside, the septum's right side included.
  double baseEpicardium =
      0;             ///< Where the ventricles begin along the axis (c, mm), a little behind the valves.
  double length = 0; ///< From the base to where the long axis ends, mm.
  sequences::AnatomySurface ventricles;   ///< Both from outside.
  sequences::AnatomySurface rightCavity;  ///< The right ventricle's cavity.
  sequences::AnatomySurface greatVessels; ///< All great vessels, which move little and at which no other
                                          ///< handles are placed.
  std::vector<AtriumAnatomy> atria;
  std::vector<VesselRing> vessels;
  Bounds box; ///< Of the far corners.
};

/// A handle of a heart, with its position and its role in the beat.
struct HeartHandle {
  HeartRole role = HeartRole::farCorner;
  Vec3 position = Vec3::Zero(); ///< At rest, mm, LPS.
  HeartPoint place;             ///< The same in the frame.
  double surfaceRho = 0;        ///< Distance from the axis of the surface that it moves with, mm.
  Vec3 center = Vec3::Zero();   ///< What it contracts towards, if in an atrium.
  double follow = 1;            ///< As in `VesselRing`.
};

/// The spacing of a heart's handles and other options of their placement.
struct HeartRigOptions {
  double spacing = 20;    ///< Along the rings around the ventricles, mm.
  double offset = 8;      ///< Between the ventricles and the handles outside them, mm.
  int atrialHandles = 24; ///< Directions tried around each atrium.
  bool cavities = true;   ///< Also handles on the walls of the ventricles' cavities.
  /// Whether the ventricles end where a ray from the axis first leaves them, not where it does last: for
  /// surfaces in which vessels may lie beside them.
  bool firstWall = false;
};

/// The handles of a heart, ordered by their role.
struct HeartRig {
  HeartAnatomy anatomy;
  std::vector<HeartHandle> handles;

  /// `n x 3`, the rest pose.
  Points restHandles() const { return sequences::positionsOf(handles); }
  /// The rows of the handles of one role, ascending.
  std::vector<int> handlesOf(HeartRole role) const;
  /// One group a role that has handles, in their order.
  std::vector<sequences::HandleGroup> groups() const;
};

/// Places the handles of a heart: rings around the long axis on the endocardium and outside the epicardium,
/// rows on the right ventricle's free wall and on the septum, points around the atria, rings around the
/// vessels, far corners. No handle is placed where a ray does not meet its surface. Deterministic; some 10
/// ms. Throws `DataError` when the surfaces do not match the frame, so that a ventricle gets fewer than eight
/// handles.
HeartRig makeHeartRig(HeartAnatomy anatomy, const HeartRigOptions& options = {});

/// The surfaces of the sample heart that its handles need, each negative inside.
struct SampleHeartSurfaces {
  sequences::AnatomySurface ventricles;
  sequences::AnatomySurface rightCavity;
  sequences::AnatomySurface rightAtrium;
  sequences::AnatomySurface leftAtrium;
  sequences::AnatomySurface
      greatVessels; ///< Aorta, pulmonary trunk, caval and pulmonary veins: the least of their values.
};

/// The anatomy of the heart that the program ships (definition `heart`): frame, ellipsoids and vessels of
/// that definition.
HeartAnatomy sampleHeartAnatomy(const SampleHeartSurfaces& surfaces);

} // namespace viscera::heart
