#pragma once

#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/sequences/centerline.h"
#include "viscera/sequences/gastric_waves.h"
#include "viscera/sequences/rig_parts.h"
#include "viscera/sequences/sequence.h"

namespace viscera::sequences {

/// A ring of handles that do not move.
struct FixedRing {
  Vec3 center = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double radius = 0; ///< mm
  int count = 1;
};

/// What has to be known of a stomach to put handles around it.
struct StomachAnatomy {
  Centerline centerline; ///< From the top of the fundus past the pylorus into the duodenum.
  GastricCourse course;  ///< On that line.
  AnatomySurface surface;
  std::vector<FixedRing> fixed; ///< Oesophagus, duodenum, top of the fundus.
  Bounds box;                   ///< Of the far corners.
};

/// Which part of the stomach a handle stands at.
enum class StomachRegion { fundus, body, antrum, fixed, farCorner };

/// One handle and its cross-section.
struct StomachHandle {
  StomachRegion region = StomachRegion::farCorner;
  Vec3 position = Vec3::Zero(); ///< At rest, mm, LPS.
  Vec3 center = Vec3::Zero();   ///< Of its ring, on the centreline.
  double s = 0;                 ///< Arc length of the ring, mm.
};

/// How close handles stand, mm.
struct StomachRigOptions {
  double ringDistance = 12; ///< Between rings, along the centreline.
  double spacing = 20;      ///< Along a ring.
};

/// The handles of a stomach, those of one region in one piece.
struct StomachRig {
  StomachAnatomy anatomy;
  std::vector<StomachHandle> handles;

  /// `n x 3`, the rest pose.
  Points restHandles() const { return positionsOf(handles); }
  /// One group a region that has handles, in their order.
  std::vector<HandleGroup> groups() const;
};

/// Places rings of 6 to 14 handles a little outside the wall from the fundus to just past the pylorus, and
/// those that do not move. Deterministic; some 10 ms. Throws `DataError` when the centreline runs outside the
/// surface or ends before the pylorus.
StomachRig makeStomachRig(StomachAnatomy anatomy, const StomachRigOptions& options = {});

/// The anatomy of the stomach that the program ships (definition `stomach`); `surface` is its node
/// `stomach_smooth`.
StomachAnatomy sampleStomachAnatomy(const AnatomySurface& surface);

} // namespace viscera::sequences
