#pragma once

#include <array>
#include <optional>
#include <string>

#include "viscera/core/arrays.h"

namespace viscera::presentation {

/// The zoom and centre of a slice.
struct SliceFraming {
  double rightMm = 0; ///< From the middle of the scan to the middle of the picture, to the right.
  double upMm = 0;    ///< The same upwards.
  double zoom = 1;    ///< 1: all of it is in the picture.

  bool operator==(const SliceFraming&) const = default;
};

/// What is shown of a cine study; of a scan of several phases only the fraction.
struct CineLook {
  /// The study's slice in each of the three panes beside the 3D view; -1: the one that `cineSlices` proposes.
  std::array<int, 3> slices{-1, -1, -1};
  double fraction = 0; ///< Of the cycle, [0, 1]; every slice shows the phase nearest to it.

  bool operator==(const CineLook&) const = default;
};

/// How the scan is shown: window and level, places of the slices, thickness and others.
struct ScanLook {
  /// The layout of the window's middle: "3d" alone, "four" views at once, or one slice alone by the id of its
  /// direction (`medical_io::sliceDirections`).
  std::string layout = "3d";
  std::optional<Vec3> focus; ///< Where the three slices meet, mm LPS; none: in the middle of the scan.
  double level = 0;          ///< The value that is middle grey; only with `width`.
  double width = 0;          ///< From black to white; 0: as the scan proposes.
  double slabMm = 0;         ///< Thickness of the slices.
  bool maximum = false;      ///< Thick slices show the largest value instead of the mean.
  bool smooth = true;        ///< Between voxels trilinear, else the nearest voxel.
  bool contours = true;      ///< The organs' outlines.
  bool rest = true;          ///< Thin contours of posed organs at rest, too.
  bool standing = false;     ///< The slices also stand in the 3D view.
  bool warped = false;       ///< The scan is deformed by the pose.
  std::array<SliceFraming, 3> framings; ///< Of the directions in their order.
  CineLook cine;                        ///< While the document has images over time.

  bool operator==(const ScanLook&) const = default;
};

} // namespace viscera::presentation
