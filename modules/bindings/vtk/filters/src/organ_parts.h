#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include <vtkSmartPointer.h>

#include "leaves.h"
#include "ranks.h"
#include "rig.h"

/// Binds, poses and measures the part of an organ that one rank holds.
namespace viscera::vtk_filters {

/// The coordinates of one leaf's points, divided into portions.
using Portions = std::vector<std::shared_ptr<const coordinates::Binding>>;

/// The volume of all parts on all ranks.
struct GlobalVolume {
  double mm3 = 0;
  bool solid = false; ///< Of tetrahedra; else of a surface.
};

/// The volume at rest, with the vector area, by which open surfaces are detected.
struct RestVolume {
  GlobalVolume volume;
  double areaMm2 = 0;       ///< Of a surface.
  double vectorAreaMm2 = 0; ///< Zero to rounding where it is closed.

  bool closed() const { return volume.solid || vectorAreaMm2 <= 1e-6 * areaMm2; }
};

/// The coordinates that are kept from one execution to the next, for points and handles that have not
/// changed.
struct KeptWeights {
  using Key = std::pair<const void*, unsigned long>; ///< The points and when they changed.
  Rig rig;
  std::map<Key, Portions> portions;
  std::vector<Key> measured; ///< The parts whose volume at rest is in `rest`.
  RestVolume rest;
};

/// The parts of an organ that this rank holds, bound and posed. Members marked so are collective.
class OrganParts {
public:
  /// Called between portions with the fraction done; may throw to abort.
  using Told = std::function<void(double fraction)>;

  OrganParts(const Ranks& ranks, const Rig& rig, std::vector<Leaf> leaves)
      : ranks_(ranks), rig_(rig), leaves_(std::move(leaves)) {}

  /// Binds what `kept` does not hold and poses all points; with `keep` all coordinates stay in `kept`, else
  /// none are held but for a portion's time. The output's points are new. Throws what binding throws.
  void pose(KeptWeights& kept, bool keep, const Told& told);

  /// The volume at rest, from `kept` where no rank's part has changed. Collective. Throws on all ranks for
  /// cells that have no volume.
  RestVolume restVolume(KeptWeights& kept) const;
  /// The volume in the pose. Collective. Throws likewise.
  GlobalVolume volume() const;

  /// Points outside the hull of the handles, which do not move. Collective.
  std::int64_t unboundPoints() const;

  /// Moves the handles at rest, all by the least, so that the organ has `targetMm3`, exactly; poses it anew.
  /// Coordinates and the volume at rest are in `kept`. Returns the pose. Collective. Throws on all ranks when
  /// it cannot be.
  Points restoreVolume(const KeptWeights& kept, double targetMm3);

private:
  struct Posed {
    vtkSmartPointer<vtkPoints> points;
    std::int64_t unbound = 0;
  };
  /// The derivative of the volume by the handles, up to a factor; the same bits on all ranks.
  Points direction(const KeptWeights& kept, const std::vector<int>& free, bool solid) const;
  std::array<double, 4> along(const KeptWeights& kept, const Points& pose, const Points& direction,
                              bool solid) const;
  /// The displacements of a leaf's points when the handles go to `to`.
  Points motionOf(const KeptWeights& kept, std::size_t leaf, const Points& to) const;
  void poseAgain(const KeptWeights& kept, const Points& pose);
  using Memory = std::function<const double*(std::size_t leaf)>;
  GlobalVolume volumeOf(const Memory& memory, const Vec3& origin) const;
  void measureClosedness(const Memory& memory, RestVolume& rest) const;
  void forEachPart(const std::function<void(std::size_t leaf, vtkPointSet* cells)>& visit) const;
  const Portions& portionsOf(const KeptWeights& kept, std::size_t leaf) const;

  const Ranks& ranks_;
  const Rig& rig_;
  std::vector<Leaf> leaves_;
  std::vector<Posed> posed_;
};

/// Points that are bound together. A multiple of the coordinates' tile.
inline constexpr vtkIdType kPortion = 65536;

} // namespace viscera::vtk_filters
