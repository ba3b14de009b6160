#include "viscera/geometry/carried_points.h"

#include <algorithm>
#include <numeric>

namespace viscera::geometry {
namespace {
constexpr double kSoftMm2 = 1; ///< So that a vertex at a point does not carry it alone.
}

CarriedPoints::CarriedPoints(const Points& points, const Points& surface) {
  const Eigen::Index count = std::min(kCarriers, surface.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Values away = (surface.rowwise() - points.row(i)).rowwise().squaredNorm();
    Carriers carriers;
    carriers.vertices.resize(static_cast<std::size_t>(surface.rows()));
    std::iota(carriers.vertices.begin(), carriers.vertices.end(), Eigen::Index{0});
    const auto nearer = [&](Eigen::Index a, Eigen::Index b) {
      return away[a] < away[b] || (away[a] == away[b] && a < b);
    };
    std::partial_sort(carriers.vertices.begin(), carriers.vertices.begin() + count, carriers.vertices.end(),
                      nearer);
    carriers.vertices.resize(static_cast<std::size_t>(count));
    double sum = 0;
    for (const Eigen::Index vertex : carriers.vertices)
      sum += carriers.weights.emplace_back(1 / (away[vertex] + kSoftMm2));
    carriers.offset = points.row(i).transpose();
    for (std::size_t k = 0; k < carriers.vertices.size(); ++k) {
      carriers.weights[k] /= sum;
      carriers.offset -= carriers.weights[k] * surface.row(carriers.vertices[k]).transpose();
    }
    carriers_.push_back(std::move(carriers));
  }
}

Points CarriedPoints::at(const Points& surface) const {
  Points points(static_cast<Eigen::Index>(carriers_.size()), 3);
  for (std::size_t i = 0; i < carriers_.size(); ++i) {
    const Carriers& carriers = carriers_[i];
    Vec3 place = carriers.offset;
    for (std::size_t k = 0; k < carriers.vertices.size(); ++k)
      place += carriers.weights[k] * surface.row(carriers.vertices[k]).transpose();
    points.row(static_cast<Eigen::Index>(i)) = place.transpose();
  }
  return points;
}

} // namespace viscera::geometry
