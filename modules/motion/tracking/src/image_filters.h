#pragma once

#include "viscera/tracking/cine_images.h"

/// Filters of single images, for tracking. Sums run in one order: the same bits every time.
namespace viscera::tracking {

/// Smooths by a Gaussian of `sigma` pixels, cut off at four of them; mirrored at the edges. O(pixels sigma).
CineImage smoothed(const CineImage& image, double sigma);

/// Differences along rows and along columns, a pixel: from both neighbours, at an edge from one.
struct ImageSlope {
  CineImage row, column;
};
ImageSlope slopeOf(const CineImage& image);

/// The value at (row, column), bilinear, and that of the edge beyond it.
float valueAt(const CineImage& image, double row, double column);

/// A displacement of every pixel, in pixels.
struct Flow {
  CineImage row, column;

  static Flow zero(Eigen::Index rows, Eigen::Index columns) {
    return {CineImage::Zero(rows, columns), CineImage::Zero(rows, columns)};
  }
};

/// `image` where the flow leads: the value of pixel x is that at x + flow(x).
CineImage warped(const CineImage& image, const Flow& flow);

/// An image resampled to another size, corner to corner.
CineImage resized(const CineImage& image, Eigen::Index rows, Eigen::Index columns);

} // namespace viscera::tracking
