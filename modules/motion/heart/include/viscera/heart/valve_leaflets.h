#pragma once

#include "viscera/core/arrays.h"
#include "viscera/heart/heart_valves.h"

/// The shape of a valve's leaflets, from its ring and from how far it is open.
namespace viscera::heart {

/// How many leaflets a valve has, and of which kind.
struct ValveForm {
  int leaflets = 3; ///< Two or three.
  bool semilunar =
      false;         ///< Pockets, which are closed by backward flow; else sails that hang into a ventricle.
  double turned = 0; ///< Where the first commissure is, rad from the ring's `first` towards `second`.
};

/// The mitral valve has two sails, the tricuspid one three, aortic and pulmonary valve three pockets.
ValveForm formOf(HeartValve valve);

/// All leaflets of a valve: of each leaflet `kAlong + 1` columns from commissure to commissure, and in each
/// of those `kAcross + 1` points from the ring (first) to the free edge (last).
struct Leaflets {
  static constexpr int kAlong = 24;
  static constexpr int kAcross = 8;
  static constexpr int kPointsEach = (kAlong + 1) * (kAcross + 1);

  Points points; ///< mm
  Triangles triangles;
  double orificeMm2 = 0; ///< The area between the free edges, seen along the flow.
};

/// The leaflets of a valve whose free edges leave `orificeMm2` open, at most the ring's area. Seen along the
/// flow each leaflet stays within its own sector of the ring, so that none crosses another; shut ones meet
/// along the lines between the sectors and cover the ring. The line from ring to free edge keeps its length:
/// sails swing into the ventricle, pockets stand up along the artery's wall. O(1): about 10 microseconds.
Leaflets leafletsOf(const ValveRing& ring, const ValveForm& form, double orificeMm2);

} // namespace viscera::heart
