#include "image_filters.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace viscera::tracking {
namespace {

constexpr double kCutOff = 4; ///< Where a Gaussian ends, in its widths.

std::vector<float> gaussianOf(double sigma) {
  const int radius = static_cast<int>(kCutOff * sigma + 0.5);
  std::vector<double> exact;
  double sum = 0;
  for (int i = -radius; i <= radius; ++i)
    sum += exact.emplace_back(std::exp(-0.5 * i * i / (sigma * sigma)));
  std::vector<float> kernel;
  for (const double weight : exact)
    kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

/// The pixel that a place beyond the edge mirrors.
Eigen::Index mirroredPlace(Eigen::Index place, Eigen::Index count) {
  while (place < 0 || place >= count)
    place = place < 0 ? -1 - place : 2 * count - 1 - place;
  return place;
}

} // namespace

CineImage smoothed(const CineImage& image, double sigma) {
  const std::vector<float> kernel = gaussianOf(sigma);
  const auto size = static_cast<Eigen::Index>(kernel.size()), radius = size / 2;
  const Eigen::Index rows = image.rows(), columns = image.cols();
  CineImage down = CineImage::Zero(rows, columns);
  for (Eigen::Index row = 0; row < rows; ++row)
    for (Eigen::Index k = 0; k < size; ++k)
      down.row(row) += kernel[static_cast<std::size_t>(k)] * image.row(mirroredPlace(row + k - radius, rows));
  CineImage across = CineImage::Zero(rows, columns);
  Eigen::Array<float, 1, Eigen::Dynamic> padded(columns + 2 * radius);
  for (Eigen::Index row = 0; row < rows; ++row) {
    padded.segment(radius, columns) = down.row(row);
    for (Eigen::Index i = 0; i < radius; ++i) {
      padded[i] = down(row, mirroredPlace(i - radius, columns));
      padded[radius + columns + i] = down(row, mirroredPlace(columns + i, columns));
    }
    for (Eigen::Index k = 0; k < size; ++k)
      across.row(row) += kernel[static_cast<std::size_t>(k)] * padded.segment(k, columns);
  }
  return across;
}

ImageSlope slopeOf(const CineImage& image) {
  const Eigen::Index rows = image.rows(), columns = image.cols();
  ImageSlope slope{CineImage(rows, columns), CineImage(rows, columns)};
  slope.row.row(0) = image.row(1) - image.row(0);
  slope.row.row(rows - 1) = image.row(rows - 1) - image.row(rows - 2);
  slope.row.middleRows(1, rows - 2) = 0.5F * (image.bottomRows(rows - 2) - image.topRows(rows - 2));
  slope.column.col(0) = image.col(1) - image.col(0);
  slope.column.col(columns - 1) = image.col(columns - 1) - image.col(columns - 2);
  slope.column.middleCols(1, columns - 2) =
      0.5F * (image.rightCols(columns - 2) - image.leftCols(columns - 2));
  return slope;
}

float valueAt(const CineImage& image, double row, double column) {
  const auto y = static_cast<float>(std::clamp(row, 0.0, static_cast<double>(image.rows() - 1)));
  const auto x = static_cast<float>(std::clamp(column, 0.0, static_cast<double>(image.cols() - 1)));
  const auto i = std::min<Eigen::Index>(static_cast<Eigen::Index>(y), image.rows() - 2);
  const auto j = std::min<Eigen::Index>(static_cast<Eigen::Index>(x), image.cols() - 2);
  const float b = y - static_cast<float>(i), a = x - static_cast<float>(j);
  const float* upper = image.data() + i * image.cols() + j;
  const float* lower = upper + image.cols();
  return (1 - b) * ((1 - a) * upper[0] + a * upper[1]) + b * ((1 - a) * lower[0] + a * lower[1]);
}

CineImage warped(const CineImage& image, const Flow& flow) {
  CineImage result(flow.row.rows(), flow.row.cols());
  for (Eigen::Index row = 0; row < result.rows(); ++row)
    for (Eigen::Index column = 0; column < result.cols(); ++column)
      result(row, column) = valueAt(image, static_cast<double>(row) + flow.row(row, column),
                                    static_cast<double>(column) + flow.column(row, column));
  return result;
}

CineImage resized(const CineImage& image, Eigen::Index rows, Eigen::Index columns) {
  const double down = static_cast<double>(image.rows() - 1) / static_cast<double>(rows - 1);
  const double across = static_cast<double>(image.cols() - 1) / static_cast<double>(columns - 1);
  CineImage result(rows, columns);
  for (Eigen::Index row = 0; row < rows; ++row)
    for (Eigen::Index column = 0; column < columns; ++column)
      result(row, column) =
          valueAt(image, static_cast<double>(row) * down, static_cast<double>(column) * across);
  return result;
}

} // namespace viscera::tracking
