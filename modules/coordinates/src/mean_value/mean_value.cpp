#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mean_value/mean_value_solver.h"
#include "mean_value/triangle_share.h"
#include "same_place.h"
#include "viscera/coordinates/cage/cage.h"

namespace viscera::coordinates {
namespace {

class MeanValueSolver final : public PointSolver {
public:
  MeanValueSolver(Points handles, Triangles cage)
      : handles_(std::move(handles)), cage_(std::move(cage)), size_(boundsOf(handles_).diagonal()),
        corner_(static_cast<std::size_t>(handles_.rows()), false) {
    for (const auto corner : cage_.reshaped())
      corner_[static_cast<std::size_t>(corner)] = true;
  }

  bool solve(const Vec3& point, Values& weights) const override {
    return add(point, weights, nullptr) != Place::nowhere;
  }

  bool solveGradients(const Vec3& point, Values& weights, Points& gradients) const override {
    return add(point, weights, &gradients) == Place::inSpace;
  }

private:
  enum class Place { inSpace, onCage, nowhere };

  Place add(const Vec3& point, Values& weights, Points* gradients) const {
    for (Eigen::Index i = 0; i < handles_.rows(); ++i)
      if (corner_[static_cast<std::size_t>(i)] &&
          (handles_.row(i).transpose() - point).norm() <= kSamePlace * size_) {
        weights[i] = 1;
        return Place::onCage;
      }
    for (Eigen::Index t = 0; t < cage_.rows(); ++t)
      if (addTriangle(t, point, weights, gradients))
        return Place::onCage;
    // a_i = w_i / W with W = sum w_j; grad a_i = (grad w_i - a_i grad W) / W.
    const double sum = weights.sum();
    if (!(std::abs(sum) > 0))
      return Place::nowhere;
    weights /= sum;
    if (gradients) {
      const Eigen::RowVector3d ofSum = gradients->colwise().sum();
      *gradients = (*gradients - weights * ofSum) / sum;
    }
    return Place::inSpace;
  }

  /// True when the point lies in this triangle; the weights are then its barycentric coordinates.
  bool addTriangle(Eigen::Index triangle, const Vec3& point, Values& weights, Points* gradients) const {
    const auto items = cage_.row(triangle);
    Corners<double> corners;
    for (int i = 0; i < 3; ++i)
      corners[static_cast<std::size_t>(i)] = handles_.row(items[i]).transpose() - point;
    const bool wantGradients = gradients != nullptr;
    auto share = shareOfTriangle(corners, wantGradients);
    if (!share) {
      const BesideTriangle place = besideTriangle(corners);
      if (std::max(place.height, place.beside) <= kSamePlace * size_) {
        weights.setZero();
        for (int i = 0; i < 3; ++i)
          weights[items[i]] = place.shares[i];
        return true;
      }
      if (!(place.height > kInPlane * place.beside))
        return false; // Seen from the side it has no weight, and without an area neither.
      share = preciseShareOf(corners, wantGradients);
    }
    for (int i = 0; i < 3; ++i) {
      weights[items[i]] += share->weights[static_cast<std::size_t>(i)];
      if (wantGradients)
        gradients->row(items[i]) += share->gradients[static_cast<std::size_t>(i)].transpose();
    }
    return false;
  }

  Points handles_;
  Triangles cage_;
  double size_;
  std::vector<bool> corner_; ///< Whether the cage uses the handle.
};

} // namespace

std::unique_ptr<const PointSolver> meanValueSolver(Points handles, Triangles cage) {
  return std::make_unique<MeanValueSolver>(std::move(handles), std::move(cage));
}

/// Mean value coordinates of a triangulated cage (thesis 3.1 and annex B.3; Floater, Kos, Reimers 2005, doi
/// 10.1016/j.cagd.2005.06.004; Ju, Schaefer, Warren 2005, doi 10.1145/1073204.1073229). The cage is
/// `HandleSet::cage`, else the convex hull of the handles. Positive inside a convex cage, negative here and
/// there in others; defined outside as well; smooth but on the cage itself. O(points x triangles).
///
/// Per triangle (i, j, k), with p at the origin and `m = sum of angle x unit normal` over the three planes
/// through p and an edge, the weight of v_i is `m . (v_j x v_k) / (2 det(v_i, v_j, v_k))`. This is the
/// thesis's (3.8) with its denominators made one, which makes its derivatives short.
std::shared_ptr<const CoordinateSystem> meanValue() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{.id = "mean-value",
                        .name = "Mean value",
                        .summary =
                            "The classical coordinates of a closed cage; positive where the cage is convex",
                        .traits = {.needsCage = true, .interpolates = true, .closedFormGradient = true}},
      [](const HandleSet& handles, const ParameterValues&) {
        return meanValueSolver(handles.positions, cageOf(handles));
      });
}

} // namespace viscera::coordinates
