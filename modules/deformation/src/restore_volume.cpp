#include "viscera/deformation/restore_volume.h"

#include <array>
#include <cmath>
#include <complex>
#include <optional>
#include <string>

#include <Eigen/Eigenvalues>

#include "viscera/core/error.h"

namespace viscera::deformation {
namespace {

using Cubic = Eigen::Vector4d; ///< c0 + c1 t + c2 t^2 + c3 t^3.

constexpr double kRealRoot = 1e-6;     ///< Imaginary part, relative to the root, that rounding explains.
constexpr double kNoInfluence = 1e-12; ///< Gradient relative to volume over size: these handles do nothing.
constexpr double kLeadingRounding =
    1e-13;                         ///< Leading coefficient relative to the others: the degree is lower.
constexpr int kPolishingSteps = 3; ///< Newton's, on the polynomial, after the eigenvalues.

double valueAt(const Cubic& c, double t) {
  return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}

double slopeAt(const Cubic& c, double t) {
  return c[1] + t * (2 * c[2] + t * 3 * c[3]);
}

/// The cubic through the values at t = -1, 0, 1, 2.
Cubic through(const std::array<double, 4>& v) {
  const double c2 = (v[0] + v[2]) / 2 - v[1];
  const double odd = (v[2] - v[0]) / 2;
  const double c3 = (v[3] - v[1] - 4 * c2 - 2 * odd) / 6;
  return {v[1], odd - c3, c2, c3};
}

/// The real root nearest to zero, by the eigenvalues of the companion matrix.
std::optional<double> nearestRoot(const Cubic& c) {
  const double scale = c.cwiseAbs().maxCoeff();
  int degree = 3;
  while (degree > 0 && std::abs(c[degree]) <= kLeadingRounding * scale)
    --degree;
  if (degree == 0)
    return std::nullopt;
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
  for (int i = 0; i < degree; ++i) {
    companion(i, degree - 1) = -c[i] / c[degree];
    if (i > 0)
      companion(i, i - 1) = 1;
  }
  std::optional<double> nearest;
  for (const std::complex<double>& root : companion.eigenvalues()) {
    const bool real = std::abs(root.imag()) <= kRealRoot * std::abs(root);
    if (real && (!nearest || std::abs(root.real()) < std::abs(*nearest)))
      nearest = root.real();
  }
  for (int step = 0; nearest && step < kPolishingSteps; ++step)
    if (const double slope = slopeAt(c, *nearest); slope != 0)
      *nearest -= valueAt(c, *nearest) / slope;
  return nearest;
}

/// The rows of the volume's gradient that belong to the compensating handles; zero elsewhere.
Points direction(Deformer& deformer, const std::vector<int>& compensating) {
  if (compensating.empty())
    throw UsageError("no handle is left to make up for the volume", {}, "name compensating handles");
  const Points& gradient = deformer.volumeGradient();
  Points along = Points::Zero(gradient.rows(), 3);
  for (int handle : compensating) {
    if (handle < 0 || handle >= gradient.rows())
      throw UsageError("there is no handle " + std::to_string(handle), "compensating handles");
    along.row(handle) = gradient.row(handle);
  }
  return along;
}

DataError unreachable(double targetMm3) {
  return DataError("no sensible motion of the compensating handles gives " +
                       std::to_string(targetMm3 / kMm3PerMl) + " ml",
                   "volume", "let more handles compensate, or ask for a volume nearer to the present one");
}

} // namespace

std::vector<int> restingHandles(const Points& restHandles, const Points& pose) {
  std::vector<int> resting;
  for (Eigen::Index i = 0; i < restHandles.rows(); ++i)
    if (restHandles.row(i) == pose.row(i))
      resting.push_back(static_cast<int>(i));
  return resting;
}

void restoreVolume(Deformer& deformer, double targetMm3, const std::vector<int>& compensating) {
  const Points pose = deformer.pose();
  const double missing = targetMm3 - deformer.volumeMm3();
  const Points along = direction(deformer, compensating);
  if (missing == 0)
    return;
  const double size = boundsOf(deformer.restHandles()).diagonal();
  const double squared = along.squaredNorm();
  if (!(std::sqrt(squared) > kNoInfluence * std::abs(deformer.restVolumeMm3()) / size))
    throw unreachable(targetMm3);
  const Points step = along * (missing / squared); // To first order, t = 1 is the whole way.
  std::array<double, 4> misses{};
  for (std::size_t i = 0; i < misses.size(); ++i) {
    deformer.setPose(pose + (static_cast<double>(i) - 1) * step);
    misses[i] = deformer.volumeMm3() - targetMm3;
  }
  const std::optional<double> root = nearestRoot(through(misses));
  const bool sensible = root && std::abs(*root) * step.rowwise().norm().maxCoeff() <= size;
  deformer.setPose(sensible ? Points(pose + *root * step) : pose);
  if (!sensible)
    throw unreachable(targetMm3);
}

} // namespace viscera::deformation
