#pragma once

#include <cstddef>
#include <variant>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"
#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {

/// A rectangle in the plane of a slice, mm LPS: from a corner along two sides at a right angle to each other.
struct RectangleRegion {
  Vec3 corner = Vec3::Zero();
  Vec3 first = Vec3::UnitX();
  Vec3 second = Vec3::UnitY();

  double areaMm2() const { return first.cross(second).norm(); }
};

/// A sphere, mm LPS.
struct SphereRegion {
  Vec3 center = Vec3::Zero();
  double radius = 0;

  double volumeMl() const;
};

using Region = std::variant<RectangleRegion, SphereRegion>;

/// Statistics of the scan's values in a region, in the scan's unit. All values are 0 where there is no voxel.
struct RegionStatistics {
  std::size_t count = 0; ///< Voxels that were measured; those of padding are none.
  double mean = 0;
  double deviation = 0; ///< Standard, of a sample: over `count - 1`; 0 for one voxel.
  double minimum = 0;
  double maximum = 0;

  friend bool operator==(const RegionStatistics&, const RegionStatistics&) = default;
};

/// The statistics of the stored voxels in a region, each counted once and none interpolated; the scan may be
/// oblique, left-handed or sheared. A voxel is in a sphere when its centre is. A voxel is in a rectangle when
/// the foot of the perpendicular from its centre to the plane lies in the rectangle and in the voxel: of a
/// grid along the plane that is the layer that the plane lies in, between two layers the one that comes later
/// in the scan. The same for any number of threads. O(voxels of the box around the sphere), O(voxels along
/// the rectangle).
RegionStatistics statisticsOf(const Scan& scan, const Region& region, Threads threads = {});

} // namespace viscera::medical_io
