#include "sphere/plane_neighbours.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace viscera::coordinates {
namespace {

using Corner = Eigen::Vector2d;

/// Times the distance of the nearest site: how far a cell may reach.
constexpr double kReach = 1e6;

class PlanePolygon {
public:
  explicit PlanePolygon(double half)
      : corners_({{-half, -half}, {half, -half}, {half, half}, {-half, half}}) {}

  /// Keeps what has `normal . x <= offset`; true when anything was cut off.
  bool cut(const Corner& normal, double offset) {
    if (std::none_of(corners_.begin(), corners_.end(),
                     [&](const Corner& corner) { return normal.dot(corner) > offset; }))
      return false;
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Corner &from = corners_[i], &to = corners_[(i + 1) % corners_.size()];
      const double begin = normal.dot(from) - offset, end = normal.dot(to) - offset;
      if (begin <= 0)
        kept.push_back(from);
      if ((begin <= 0) != (end <= 0))
        kept.push_back(from + begin / (begin - end) * (to - from)); // normal . x = offset.
    }
    corners_ = std::move(kept);
    return true;
  }

  bool empty() const { return corners_.size() < 3; }

  double area() const {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < corners_.size(); ++i) {
      const Corner one = corners_[i] - corners_[0], two = corners_[i + 1] - corners_[0];
      sum += one[0] * two[1] - one[1] * two[0];
    }
    return std::max(0.0, sum / 2);
  }

  double reach() const {
    double reach = 0;
    for (const Corner& corner : corners_)
      reach = std::max(reach, corner.cwiseAbs().maxCoeff());
    return reach;
  }

private:
  std::vector<Corner> corners_;
};

} // namespace

bool planeNeighbours(const PlanePoints& sites, const Eigen::VectorXd& powers, Eigen::VectorXd& shares) {
  // The cell of the origin, whose power is 0: |x|^2 <= |x - s_i|^2 - w_i, x . s_i <= (|s_i|^2 - w_i) / 2.
  const Eigen::VectorXd squares = sites.rowwise().squaredNorm() - powers;
  const double reach = kReach * std::sqrt(squares.minCoeff());
  PlanePolygon cell(reach);
  for (Eigen::Index i = 0; i < sites.rows(); ++i)
    cell.cut(sites.row(i).transpose(), squares[i] / 2);
  if (cell.empty() || cell.reach() >= reach)
    return false;
  // What site i had of it before, |x - s_i|^2 - w_i <= |x - s_j|^2 - w_j for all j; share_i is this area over
  // the sum of the areas.
  shares.setZero(sites.rows());
  for (Eigen::Index i = 0; i < sites.rows(); ++i) {
    PlanePolygon taken = cell;
    for (Eigen::Index j = 0; j < sites.rows() && !taken.empty(); ++j)
      if (j != i)
        taken.cut((sites.row(j) - sites.row(i)).transpose(), (squares[j] - squares[i]) / 2);
    shares[i] = taken.area();
  }
  const double sum = shares.sum();
  if (!(sum > 0))
    return false;
  shares /= sum;
  return true;
}

} // namespace viscera::coordinates
