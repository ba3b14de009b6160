#include "viscera/coordinates/systems.h"

#include <array>
#include <vector>

#include <Eigen/Geometry>

#include "nspace/direction_solver.h"
#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {
namespace {

/// Numbers of four unit vectors below this are rounding: the four lie in one plane, as those to handles in a
/// row.
constexpr double kFlatSimplex = 1e-12;

/// The determinants of all triples i < j < k of directions, and of no others: 27 MB for 273 handles.
class Determinants {
public:
  explicit Determinants(const Points& units) : count_(static_cast<std::size_t>(units.rows())) {
    begins_.resize(count_ * count_);
    values_.reserve(count_ * (count_ - 1) * (count_ - 2) / 6);
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = i + 1; j < count_; ++j) {
        const Vec3 cross = row(units, i).cross(row(units, j));
        begins_[i * count_ + j] = values_.size();
        for (std::size_t k = j + 1; k < count_; ++k)
          values_.push_back(cross.dot(row(units, k)));
      }
  }
  double operator()(std::size_t i, std::size_t j, std::size_t k) const {
    return values_[begins_[i * count_ + j] + k - j - 1];
  }

private:
  static Vec3 row(const Points& units, std::size_t i) {
    return units.row(static_cast<Eigen::Index>(i)).transpose();
  }

  std::size_t count_;
  std::vector<std::size_t> begins_; ///< Of each pair's row of `values_`.
  std::vector<double> values_;
};

/// Numbers of one sign balance the corners of a simplex that contains the point.
template <int Corners>
bool addSimplex(const std::array<std::size_t, Corners>& corners,
                const Eigen::Matrix<double, Corners, 1>& shares, Values& beta) {
  const bool positive = shares.minCoeff() >= 0, negative = shares.maxCoeff() <= 0;
  if (positive == negative ||
      shares.norm() < kFlatSimplex) // Mixed signs, or directions that do not span space.
    return false;
  // beta += b / |b|, b with the sign that makes it positive (thesis 3.3.3); the thesis's division by the
  // number of simplices drops out when the coordinates are divided by their sum.
  const double norm = positive ? shares.norm() : -shares.norm();
  for (std::size_t corner = 0; corner < corners.size(); ++corner)
    beta[static_cast<Eigen::Index>(corners[corner])] += shares[static_cast<Eigen::Index>(corner)] / norm;
  return true;
}

bool balance(const HandleDirections& sight, Values& beta) {
  // Any four vectors have det(jkl) u_i - det(ikl) u_j + det(ijl) u_k - det(ijk) u_l = 0 (thesis 3.3.3, whose
  // M_3 and M_4 are the second and the third with their columns turned).
  const Determinants determinants(sight.units);
  const auto count = static_cast<std::size_t>(beta.size());
  bool found = false;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      for (std::size_t k = j + 1; k < count; ++k) {
        const double first = determinants(i, j, k);
        for (std::size_t l = k + 1; l < count; ++l)
          found |= addSimplex<4>(
              {i, j, k, l}, {determinants(j, k, l), -determinants(i, k, l), determinants(i, j, l), -first},
              beta);
      }
  return found;
}

} // namespace

BalanceIn<2> planeDeterminants() {
  return [](const HandleDirectionsOf<2>& sight, Values& beta) {
    const auto count = static_cast<std::size_t>(beta.size());
    const auto determinant = [&](std::size_t i, std::size_t j) {
      const auto a = sight.units.row(static_cast<Eigen::Index>(i)),
                 b = sight.units.row(static_cast<Eigen::Index>(j));
      return a[0] * b[1] - a[1] * b[0];
    };
    // det(jk) u_i - det(ik) u_j + det(ij) u_k = 0.
    bool found = false;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i + 1; j < count; ++j)
        for (std::size_t k = j + 1; k < count; ++k)
          found |= addSimplex<3>({i, j, k}, {determinant(j, k), -determinant(i, k), determinant(i, j)}, beta);
    return found;
  };
}

/// Coordinates by determinants: the mean of the balanced vectors of all tetrahedra of handles that contain
/// the point, each divided by its norm (thesis 3.3.3). Positive; jumps where the number of tetrahedra
/// changes. O(n^4) a point.
std::shared_ptr<const CoordinateSystem> determinantsApproach() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{
          .id = "determinants-approach",
          .name = "Determinants approach",
          .summary =
              "The mean over all tetrahedra of handles around a point; jumps where their number changes",
          .traits = {.positive = true, .interpolates = true, .continuous = false, .smooth = false}},
      [](const HandleSet& handles, const ParameterValues&) {
        return std::make_unique<DirectionSolver>(handles.positions, balance);
      });
}

} // namespace viscera::coordinates
