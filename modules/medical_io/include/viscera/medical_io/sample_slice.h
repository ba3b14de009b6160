#pragma once

#include <cstdint>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/medical_io/scan.h"
#include "viscera/medical_io/slice_frame.h"

namespace viscera::medical_io {

/// The options of `sampleSlice`: interpolation and thickness.
struct SampleOptions {
  bool nearest = false; ///< The voxel's own value instead of the trilinear one.
  double slabMm = 0;    ///< Thickness around the slice's plane; 0: the plane alone.
  bool maximum = false; ///< Of a slab the largest value instead of the mean.
  Threads threads = {};
};

/// The scan's values at the pixels of a slice, row by row from the lower left; NaN where nothing was
/// measured: outside of the scan's voxels, and in padding.
struct ValueImage {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// Samples a scan on a slice, in the scan's unit. Reads the stored samples in place; a frame may have any
/// orientation in the scan, which may be oblique, left-handed or sheared. With `rest`, `pixels x 3` mm LPS, a
/// pixel shows the value at the place where its tissue was at rest; a row of NaN means that this place is
/// unknown. The layers of a thick slice lie along its normal there as well. Reuses the memory of `image`.
/// O(pixels
/// * layers of the slab), on several threads; a fifth of that where rows of pixels run along an axis of the
/// voxels and nothing is bent.
void sampleSlice(const Scan& scan, const SliceFrame& frame, const SampleOptions& options, ValueImage& image,
                 const Points* rest = nullptr);

/// Converts values to grey levels by window and level: black at `level - width / 2` and below, white at
/// `level + width / 2` and above, `background` where nothing was measured. O(pixels), on several threads.
void greyOf(const ValueImage& image, const ValueWindow& window, std::uint8_t background,
            std::vector<std::uint8_t>& grey, Threads threads = {});

} // namespace viscera::medical_io
