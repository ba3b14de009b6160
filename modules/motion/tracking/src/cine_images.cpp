#include "viscera/tracking/cine_images.h"

#include <algorithm>
#include <cmath>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::tracking {
namespace {

constexpr double kUnitTolerance = 1e-3;
constexpr double kParallelCosine = 0.985; ///< 10 degrees.

void requireFrame(const CinePlane& plane) {
  const bool unit = std::abs(plane.alongRow.norm() - 1) < kUnitTolerance &&
                    std::abs(plane.alongColumn.norm() - 1) < kUnitTolerance &&
                    std::abs(plane.alongRow.dot(plane.alongColumn)) < kUnitTolerance;
  if (!unit || !plane.origin.allFinite())
    throw DataError("The directions of its rows and columns are not perpendicular", plane.name,
                    "export the series again");
  if (!(plane.spacing.minCoeff() > 0) || !plane.spacing.allFinite())
    throw DataError("The size of its pixels is unknown", plane.name, "export the series again");
}

void requireImages(const CinePlane& plane) {
  if (plane.images.empty() || plane.images.size() != plane.fractions.size())
    throw DataError("It has no image, or images without times", plane.name, "export the series again");
  for (std::size_t i = 0; i < plane.images.size(); ++i) {
    const double fraction = plane.fractions[i];
    if (!(fraction >= 0 && fraction < 1) || (i > 0 && !(fraction > plane.fractions[i - 1])))
      throw DataError(phrase("The time of image %1 is not after the one before, within one cycle", i + 1),
                      plane.name, "export the series again");
    const CineImage& image = plane.images[i];
    if (image.rows() != plane.images[0].rows() || image.cols() != plane.images[0].cols() ||
        image.rows() < 2 || image.cols() < 2)
      throw DataError(phrase("Image %1 has another size than the first", i + 1), plane.name,
                      "export the series again");
    if (!image.allFinite())
      throw DataError(phrase("Image %1 has grey values that are no numbers", i + 1), plane.name,
                      "export the series again");
  }
}

} // namespace

int CinePlane::imageAt(double fraction, double tolerance) const {
  int nearest = -1;
  double least = tolerance;
  for (std::size_t i = 0; i < fractions.size(); ++i) {
    const double ahead = std::abs(fractions[i] - fraction);
    if (const double apart = std::min(ahead, 1 - ahead); apart < least) {
      least = apart;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

void requireValid(const std::vector<CinePlane>& planes) {
  for (const CinePlane& plane : planes) {
    requireFrame(plane);
    requireImages(plane);
  }
}

std::vector<bool> longAxisPlanes(const std::vector<CinePlane>& planes) {
  const auto parallel = [&](std::size_t a, std::size_t b) {
    return std::abs(planes[a].normal().dot(planes[b].normal())) > kParallelCosine;
  };
  std::size_t middle = 0, most = 0;
  for (std::size_t a = 0; a < planes.size(); ++a) {
    std::size_t count = 0;
    for (std::size_t b = 0; b < planes.size(); ++b)
      count += parallel(a, b);
    if (count > most) {
      most = count;
      middle = a;
    }
  }
  std::vector<bool> isLong(planes.size(), true);
  for (std::size_t b = 0; b < planes.size() && most > 1; ++b)
    isLong[b] = !parallel(middle, b);
  return isLong;
}

} // namespace viscera::tracking
