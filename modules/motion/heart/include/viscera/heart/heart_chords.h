#pragma once

#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/heart/heart_valves.h"
#include "viscera/heart/valve_leaflets.h"

/// The chords (chordae tendineae) that hold the sails of the sample heart's inlet valves.
namespace viscera::heart {

/// A chord: from a papillary muscle to the free edge of a sail.
struct Chord {
  HeartValve valve = HeartValve::mitral; ///< Mitral or tricuspid.
  int leaflet = 0;                       ///< Of `formOf(valve)`.
  int along = 0;                         ///< Its point of the free edge, 0 to `Leaflets::kAlong`.
  Vec3 muscle = Vec3::Zero();            ///< About where it begins, on the muscle's tip at rest, mm.
};

/// The chords of the sample heart: 16 from the two left papillary muscles to the mitral valve's halves, 18
/// from the three right ones to the tricuspid valve's. Each muscle holds the sails on both sides of a
/// commissure.
std::vector<Chord> sampleHeartChords();

/// The chords of a heart whose walls are known as a surface, the papillary muscles among them. A chord begins
/// at the vertex of the walls nearest to `Chord::muscle` and ends on its leaflet's edge, so that it holds on
/// to both in every pose. It is as long as in a shut valve at rest: what is too long for the way between its
/// ends bows outwards, away from the ring's axis, but by an eighth of that way at most; one that is too short
/// is straight. Immutable; thread-safe.
class HeartChords {
public:
  static constexpr int kPointsEach = 9;

  /// `walls` is the surface at rest, `n x 3` mm. Throws `DataError` when it has no points. O(n).
  explicit HeartChords(const Points& walls);

  std::size_t size() const { return chords_.size(); }
  const Chord& chord(std::size_t i) const { return chords_.at(i); }
  /// The vertex of the walls at which a chord begins.
  Eigen::Index vertex(std::size_t i) const { return vertices_.at(i); }
  /// A chord as a line of `kPointsEach` points, mm, from its muscle to its sail: of leaflets of its valve in
  /// this ring, and with the walls' vertices moved to `walls`. O(1).
  Points at(std::size_t i, const Leaflets& leaflets, const ValveRing& ring, const Points& walls) const;

private:
  std::vector<Chord> chords_;
  std::vector<Eigen::Index> vertices_;
  std::vector<double> lengths_; ///< mm
};

} // namespace viscera::heart
