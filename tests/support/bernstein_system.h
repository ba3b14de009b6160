#pragma once

#include <cmath>
#include <memory>

#include "viscera/coordinates/coordinate_system.h"

/// A deformation of space that is known at every point, and its inverse too.
namespace viscera::tests {

inline constexpr double kSide = 100;

/// Weights by Bernstein's polynomials of degree 2 on the cube [0, 100]^3: a deformation that is known at
/// every point, and whose inverse is.
class BernsteinSystem final : public coordinates::DescribedSystem {
public:
  BernsteinSystem() : DescribedSystem({"bernstein", "Bernstein", "of a test"}) {}

  static coordinates::HandleSet lattice() {
    coordinates::HandleSet handles;
    handles.positions.resize(27, 3);
    for (int n = 0; n < 27; ++n)
      handles.positions.row(n) << kSide / 2 * (n % 3), kSide / 2 * (n / 3 % 3), kSide / 2 * (n / 9);
    return handles;
  }

  std::unique_ptr<coordinates::Binding> bind(const coordinates::HandleSet&, const Points& points,
                                             const coordinates::BindOptions&, Progress&) const override {
    return std::make_unique<Bound>(points);
  }

private:
  class Bound final : public coordinates::Binding {
  public:
    explicit Bound(const Points& points) : weights_(points.rows(), 27) {
      for (Eigen::Index p = 0; p < points.rows(); ++p)
        for (int n = 0; n < 27; ++n)
          weights_(p, n) =
              basis(n % 3, points(p, 0)) * basis(n / 3 % 3, points(p, 1)) * basis(n / 9, points(p, 2));
    }
    Eigen::Index handleCount() const override { return 27; }
    Eigen::Index pointCount() const override { return weights_.rows(); }
    const coordinates::BindingReport& report() const override { return report_; }
    void deform(const Points& pose, Points& points, Threads) const override { points = weights_ * pose; }
    void moveHandle(const Points&, int, const Vec3&, Points&, Threads) const override {}
    void pullBack(const Points&, const Points&, Points&, Threads) const override {}
    Values influence(int handle) const override { return weights_.col(handle); }

  private:
    static double basis(int i, double x) {
      const double t = x / kSide;
      return i == 0 ? (1 - t) * (1 - t) : i == 1 ? 2 * t * (1 - t) : t * t;
    }
    Eigen::MatrixXd weights_;
    coordinates::BindingReport report_;
  };
};

/// y = x + bend * 2 t (1 - t) along x, with t = x / 100, bends along x; z and y shear by its middle column.
inline Points bentPose(const coordinates::HandleSet& handles, double bend) {
  Points pose = handles.positions;
  for (int n = 0; n < 27; ++n)
    if (n % 3 == 1)
      pose(n, 0) += bend;
  return pose;
}

/// The x whose image is y: the root of x + 2 bend t (1 - t) = y in [0, 100].
inline double analyticInverse(double y, double bend) {
  const double a = -2 * bend / kSide / kSide, b = 1 + 2 * bend / kSide;
  return (-b + std::sqrt(b * b + 4 * a * y)) / (2 * a);
}

} // namespace viscera::tests
