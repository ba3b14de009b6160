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

/// The measures of a stomach that are needed to place handles around it.
struct StomachAnatomy {
  Centerline centerline; ///< From the top of the fundus past the pylorus into the duodenum.
  GastricCourse course;  ///< On that line.
  AnatomySurface surface;
  std::vector<FixedRing> fixed; ///< Oesophagus, duodenum, top of the fundus.
  Bounds box;                   ///< Of the far corners.
};

/// The part of the stomach at which a handle is.
enum class StomachRegion { fundus, body, antrum, fixed, farCorner };

/// A handle of a stomach, with the cross-section that it belongs to.
struct StomachHandle {
  StomachRegion region = StomachRegion::farCorner;
  Vec3 position = Vec3::Zero(); ///< At rest, mm, LPS.
  Vec3 center = Vec3::Zero();   ///< Of its ring, on the centreline.
  double s = 0;                 ///< Arc length of the ring, mm.
};

/// The spacing of a stomach's handles, mm.
struct StomachRigOptions {
  double ringDistance = 12; ///< Between rings, along the centreline.
  double spacing = 20;      ///< Along a ring.
};

/// The handles of a stomach, ordered by region.
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
