#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/phantom/phantom_body.h"
#include "viscera/phantom/phantom_motion.h"
#include "viscera/phantom/row_cover.h"

namespace viscera::phantom {

/// How a scanner sees the tissue.
struct Contrast {
  enum class Kind { ct, cineMr };
  enum class Noise { none, gaussian, rician };
  Kind kind = Kind::ct;
  Noise noise = Noise::none;
  double deviation = 0;   ///< Of the noise, in the image's unit.
  std::uint64_t seed = 1; ///< Of grain and noise. Grain is the same in all images of one seed.
  LinesOfARow lines{2, 2};
};

/// The phantom at one instant.
struct PhantomInstant {
  std::vector<Points> surfaces;          ///< Of each of the body's, `n x 3` mm.
  const PhantomMotion* motion = nullptr; ///< Set to that instant; not null.
};

/// The body moved to the present instant of the motion. O(vertices).
PhantomInstant instantOf(const PhantomBody& body, const PhantomMotion& motion);

/// The body at rest. `motion` is only kept.
PhantomInstant atRest(const PhantomBody& body, const PhantomMotion& motion);

/// An image of that instant, i fastest, HU or MR signal: each voxel is the mean of its tissues by their part
/// of it along the lines, with grain at the place where the voxel's centre was at rest. `number` tells the
/// noise of one image from that of another. A microsecond or two a voxel.
std::vector<float> renderImage(const PhantomBody& body, const PhantomInstant& instant, const ImageGrid& grid,
                               const Contrast& contrast, std::uint64_t number, Threads threads = {});

/// The labels of that instant at the voxels' centres, i fastest.
std::vector<std::uint8_t> renderLabels(const PhantomBody& body, const PhantomInstant& instant,
                                       const ImageGrid& grid, Threads threads = {});

/// Tells the tissue of a point by the surfaces at rest. Immutable; thread-safe.
class RestTissue {
public:
  /// O(n log n).
  explicit RestTissue(const PhantomBody& body);
  ~RestTissue();
  RestTissue(const RestTissue&) = delete;
  RestTissue& operator=(const RestTissue&) = delete;

  /// The label at a place whose moving tissue was at `rest`: that of what stands still there, else that of
  /// the tissue around the point at rest. A few microseconds.
  int labelAt(const Vec3& place, const Vec3& rest) const;

private:
  struct Surfaces;
  std::unique_ptr<const Surfaces> surfaces_;
};

/// The labels of a motion's instant at the voxels' centres in the other way, by the tissue at rest and the
/// inverse of the motion: for the check of `renderLabels`. Some microseconds a voxel.
std::vector<std::uint8_t> warpLabels(const RestTissue& tissue, const PhantomMotion& motion,
                                     const ImageGrid& grid, Threads threads = {});

} // namespace viscera::phantom
