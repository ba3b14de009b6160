#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <mutex>

#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {

/// Bytes of a scan's samples.
std::size_t bytesOfSamples(const Scan& scan);

/// The same scan with samples of 16 bits in place of 32: each value is the nearest of 65,000 steps between
/// the least and the largest one, those that are no measurement stay so. O(voxels).
Scan inSixteenBits(Scan&& scan);

/// Keeps the volumes that were used last, within a number of bytes; one at least. For any thread.
class VolumeRing {
public:
  using Volume = std::shared_ptr<const Scan>;

  explicit VolumeRing(std::size_t bytes) : most_(bytes) {}

  /// The volume of a phase, kept or decoded now; two threads may decode the same one at a time.
  Volume get(std::size_t phase, const std::function<Scan()>& decode);
  /// Keeps a volume; of several of one phase the first stays.
  Volume keep(std::size_t phase, Scan&& scan);
  /// Gives up a phase.
  void drop(std::size_t phase);
  std::size_t heldBytes() const;

private:
  struct Kept {
    std::size_t phase = 0;
    Volume volume;
  };
  Volume find(std::size_t phase);

  mutable std::mutex mutex_;
  std::list<Kept> kept_; ///< The last used first.
  std::size_t most_ = 0, held_ = 0;
};

} // namespace viscera::medical_io
