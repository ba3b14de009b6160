#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include <Eigen/Cholesky>

#include "choice_parameter.h"
#include "nspace/direction_solver.h"
#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {
namespace {

enum class Sampling { hitAndRun, sphere, cube };

const Parameter kSampling = choiceParameter("sampling", "Method that finds positive balanced vectors",
                                            {"hit-and-run", "sphere", "cube"});
const Parameter kSamplesAPoint = countParameter("samples", "Number of samples for each point", 10, 1e6, 400);
const Parameter kCelestialSeed = countParameter("seed", "Seed of the random numbers", 0, 1e6, 1);

constexpr int kMostCelestialSteps = 100;
constexpr double kConverged = 1e-10;
/// Part of the function: a smaller descent is lost in rounding, and a whole step is taken.
constexpr double kRounding = 1e-15;

/// Positive numbers `exp(q_i . x)` that balance the directions: somewhere well inside the cone. Damped
/// Newton on a convex function of three variables.
bool startInside(const Points& units, Values& beta) {
  // f(x) = sum exp(q_i . x) has the gradient sum beta_i q_i with beta_i = exp(q_i . x), which is zero where
  // beta balances the directions (thesis 3.15), and the Hessian sum beta_i q_i q_i^T.
  Vec3 x = Vec3::Zero();
  for (int step = 0; step < kMostCelestialSteps; ++step) {
    beta = (units * x).array().exp();
    const Vec3 slope = units.transpose() * beta;
    if (slope.norm() <= kConverged * beta.sum())
      return true;
    const Eigen::Matrix3d bend = units.transpose() * beta.asDiagonal() * units;
    const Vec3 way = -bend.ldlt().solve(slope);
    // Halved until f(x + length way) <= f(x) + 0.1 length slope . way (Armijo's condition), but for rounding.
    double length = 1;
    while (length > kConverged && !((units * (x + length * way)).array().exp().sum() <=
                                    beta.sum() * (1 + kRounding) + 0.1 * length * slope.dot(way)))
      length /= 2;
    x += length * way;
  }
  return false;
}

struct Sampler {
  Sampling sampling;
  int samples;
  unsigned seed;
  const Progress& progress; ///< Of the binding; a million samples with many handles take minutes a point.

  bool operator()(const HandleDirections& sight, Values& beta) const {
    const BalancedSpace<3> space(sight.units);
    if (!space.valid())
      return false;
    const bool found = sampling == Sampling::hitAndRun ? walk(sight, space, beta) : throwAtCone(space, beta);
    if (found)
      beta = space.project(beta).cwiseMax(0); // Many sums leave the space by rounding.
    return found;
  }

  bool walk(const HandleDirections& sight, const BalancedSpace<3>& space, Values& beta) const {
    Values at(beta.size());
    if (!startInside(sight.units, at))
      return false;
    // Take out the balance's remaining error, and set |at| = 1/2: inside the unit ball.
    at = space.project(at);
    at /= 2 * at.norm();
    if (at.minCoeff() < 0)
      return false;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> number;
    std::uniform_real_distribution<double> part(0, 1);
    Values way(beta.size());
    for (int sample = 0; sample < samples; ++sample) {
      progress.throwIfCancelled();
      for (Eigen::Index i = 0; i < way.size(); ++i)
        way[i] = number(random);
      way = space.project(way); // Every direction within the space is as likely as any other.
      const double where = part(random);
      const auto [low, high] = chord(at, way);
      beta += at + (low + high) / 2 * way; // The expectation of the next place has less variance than the
                                           // place.
      at = (at + (low + where * (high - low)) * way).cwiseMax(0);
    }
    return true;
  }

  /// The part of a line through `at` that the cone and the unit ball leave.
  static std::pair<double, double> chord(const Values& at, const Values& way) {
    const double square = way.squaredNorm(), half = at.dot(way), out = at.squaredNorm() - 1;
    if (!(square > 0))
      return {0, 0};
    // |at + s way|^2 = 1: |way|^2 s^2 + 2 (at . way) s + |at|^2 - 1 = 0.
    const double root = std::sqrt(std::max(0.0, half * half - square * out));
    double low = (-half - root) / square, high = (-half + root) / square;
    // at_i + s way_i >= 0: s is at least -at_i / way_i where way_i > 0, and at most that where way_i < 0.
    for (Eigen::Index i = 0; i < at.size(); ++i) {
      if (way[i] > 0)
        low = std::max(low, -at[i] / way[i]);
      else if (way[i] < 0)
        high = std::min(high, -at[i] / way[i]);
    }
    return low < high ? std::pair(low, high) : std::pair(0.0, 0.0);
  }

  /// The sum of the projected samples without a negative number, which is their centroid (thesis 4.2) but for
  /// a factor.
  bool throwAtCone(const BalancedSpace<3>& space, Values& beta) const {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> number;
    std::uniform_real_distribution<double> side(-1, 1);
    Values sample(beta.size());
    bool found = false;
    for (int i = 0; i < samples; ++i) {
      progress.throwIfCancelled();
      for (Eigen::Index k = 0; k < sample.size(); ++k)
        sample[k] = sampling == Sampling::cube ? side(random) : number(random);
      if (sampling == Sampling::sphere)
        sample.normalize();
      sample = space.project(sample);
      if (sample.minCoeff() < 0)
        continue;
      beta += sample;
      found = true;
    }
    return found;
  }
};

} // namespace

/// C-Celestial coordinates: the centroid of the positive balanced vectors within the unit sphere, by sampling
/// (thesis 4.2). `sampling`:
/// * `hit-and-run` (ours): a walk inside the cone and the unit ball, which loses no sample;
/// * `sphere`, `cube`: as in the thesis, random vectors are projected, and those with a negative number
///   rejected. With many handles almost all are rejected, and a point may have no coordinates.
///
/// `samples` a point, and `seed`; every point uses the same random numbers. O(samples x n) a point.
std::shared_ptr<const CoordinateSystem> cCelestial() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{
          .id = "c-celestial",
          .name = "C-Celestial",
          .summary =
              "Centroid of all positive solutions, estimated by sampling; more samples are more accurate",
          // A walk of many steps makes a difference of the last bit a large one, so turns change something.
          .traits = {.positive = true,
                     .interpolates = true,
                     .rotationInvariant = false,
                     .everywhere = false,
                     .continuous = false,
                     .smooth = false},
          .parameters = {kSampling, kSamplesAPoint, kCelestialSeed}},
      [](const HandleSet& handles, const Points&, const BindOptions& options, Progress& progress) {
        const ParameterValues& parameters = options.parameters;
        return std::make_shared<const DirectionSolver>(
            handles.positions,
            Sampler{chosen<Sampling>(parameters, kSampling), static_cast<int>(parameters.get(kSamplesAPoint)),
                    static_cast<unsigned>(parameters.get(kCelestialSeed)), progress});
      });
}

} // namespace viscera::coordinates
