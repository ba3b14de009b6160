#include "viscera/elasticity/least_energy.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "viscera/core/error.h"

namespace viscera::elasticity {
namespace {

/// Witnesses whose contributions are summed together; the sums are added in a fixed order.
constexpr Eigen::Index kPortion = 128;
/// The stiffness of all springs together, by that of the tissue.
constexpr double kSprings = 1e-3;
constexpr Eigen::Index kNeighbours = 6;
/// Part of the mean diagonal that keeps the stiffness positive definite.
constexpr double kDamping = 1e-9;
constexpr int kMostHalvings = 16;
constexpr double kSufficient = 1e-4; ///< Armijo's part of the descent that the slope promises.
/// A stiffness is kept while each step is so much shorter than the one before.
constexpr double kFastEnough = 0.35;
constexpr double kMeritMargin = 2;

Eigen::Index portionsOf(Eigen::Index witnesses) {
  return (witnesses + kPortion - 1) / kPortion;
}

double longestRowOf(const Points& rows) {
  return rows.rows() == 0 ? 0.0 : rows.rowwise().norm().maxCoeff();
}

Values gatheredRows(const Points& rows, const std::vector<int>& free) {
  Values values(3 * static_cast<Eigen::Index>(free.size()));
  for (std::size_t i = 0; i < free.size(); ++i)
    values.segment<3>(3 * static_cast<Eigen::Index>(i)) = rows.row(free[i]).transpose();
  return values;
}

/// The volumes of a lock and the free handles' influence on them, relative to the targets.
struct VolumeConstraint {
  const deformation::VolumeLock* lock;
  const std::vector<int>& free;

  Eigen::Index count() const { return lock ? static_cast<Eigen::Index>(lock->surfaces().size()) : 0; }
  Values missing(const Points& pose) const {
    Values off(count());
    if (!lock)
      return off;
    const std::vector<double> volumes = lock->expectedVolumes(pose);
    for (Eigen::Index k = 0; k < count(); ++k)
      off[k] = volumes[std::size_t(k)] / lock->surfaces()[std::size_t(k)].targetMm3 - 1;
    return off;
  }
  Eigen::MatrixXd slopes(const Points& pose) const {
    Eigen::MatrixXd rows(count(), 3 * static_cast<Eigen::Index>(free.size()));
    if (!lock)
      return rows;
    const std::vector<Points> gradients = lock->gradients(pose);
    for (Eigen::Index k = 0; k < count(); ++k)
      rows.row(k) = gatheredRows(gradients[std::size_t(k)], free).transpose() /
                    lock->surfaces()[std::size_t(k)].targetMm3;
    return rows;
  }
};

} // namespace

Values witnessVolumes(const deformation::WitnessMesh& mesh) {
  const Values volumes = deformation::tetrahedronVolumes(mesh.points, mesh.tetrahedra);
  Values shares = Values::Zero(mesh.witnesses);
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t) {
    int inside = 0;
    for (int corner = 0; corner < 4; ++corner)
      inside += mesh.isWitness(mesh.tetrahedra(t, corner)) ? 1 : 0;
    for (int corner = 0; corner < 4; ++corner)
      if (mesh.isWitness(mesh.tetrahedra(t, corner)))
        shares[mesh.tetrahedra(t, corner)] += volumes[t] / inside;
  }
  return shares;
}

LeastEnergy::LeastEnergy(const std::vector<WitnessedTissue>& tissue, const Points& rest,
                         const Options& options)
    : rest_(rest), material_(options.poisson), threads_(options.threads) {
  std::vector<std::pair<const WitnessedTissue*, Eigen::Index>> used;
  for (const WitnessedTissue& part : tissue) {
    assert(part.gradients->handles() == rest.rows() && part.volumesMm3.size() <= part.gradients->witnesses());
    if (!part.gradients->linear())
      throw DataError("free handles cannot follow: these coordinates are not linear in the handles", {},
                      "choose another coordinate system");
    for (Eigen::Index w = 0; w < part.volumesMm3.size(); ++w)
      if (part.volumesMm3[w] > 0 && !part.gradients->failed(w))
        used.emplace_back(&part, w);
  }
  if (used.empty())
    throw DataError("free handles cannot follow: there is no witness point in the tissue", {},
                    "place the handles around an organ that encloses a volume");
  const auto count = static_cast<Eigen::Index>(used.size());
  shares_.resize(count);
  derivatives_.resize(rest.rows(), 3 * count);
  parallelRanges(count, kPortion, threads_, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i) {
      const auto& [part, w] = used[std::size_t(i)];
      shares_[i] = part->volumesMm3[w];
      for (Eigen::Index handle = 0; handle < rest.rows(); ++handle)
        derivatives_.block<1, 3>(handle, 3 * i) = part->gradients->gradient(w, handle).transpose();
    }
  });
  shares_ /= shares_.sum();
  std::set<std::pair<Eigen::Index, Eigen::Index>> pairs;
  for (Eigen::Index a = 0; a < rest.rows(); ++a) {
    std::vector<std::pair<double, Eigen::Index>> near;
    for (Eigen::Index b = 0; b < rest.rows(); ++b)
      if (const double distance = (rest.row(a) - rest.row(b)).norm(); distance > 0)
        near.emplace_back(distance, b);
    std::sort(near.begin(), near.end());
    for (std::size_t i = 0; i < near.size() && i < std::size_t(kNeighbours); ++i)
      pairs.insert(std::minmax(a, near[i].second));
  }
  for (const auto& [a, b] : pairs)
    springs_.push_back({a, b, (rest.row(a) - rest.row(b)).norm()});
}

/// The gradient of the springs' energy, which is added to `energy`.
Points LeastEnergy::springs(const Points& pose, double& energy) const {
  Points gradient = Points::Zero(pose.rows(), 3);
  const double stiffness = kSprings / static_cast<double>(std::max<std::size_t>(springs_.size(), 1));
  for (const Spring& spring : springs_) {
    const Eigen::RowVector3d way = pose.row(spring.a) - pose.row(spring.b);
    const double length = way.norm(), strain = length / spring.lengthMm - 1;
    energy += 0.5 * stiffness * strain * strain;
    if (length == 0)
      continue;
    const Eigen::RowVector3d force = stiffness * strain / (spring.lengthMm * length) * way;
    gradient.row(spring.a) += force;
    gradient.row(spring.b) -= force;
  }
  return gradient;
}

double LeastEnergy::evaluate(const Points& pose, Points* gradient) const {
  if (pose.rows() != rest_.rows())
    throw DataError(misuse("a pose of %1 handles does not fit an energy of %2", pose.rows(), rest_.rows()));
  // The derivatives add up to zero: about a handle, the sums stay small.
  const Eigen::MatrixXd local = (pose.rowwise() - pose.row(0)).eval();
  const Eigen::Index portions = portionsOf(witnesses());
  Values energies = Values::Zero(portions);
  std::vector<Eigen::MatrixXd> gradients(gradient ? std::size_t(portions) : 0);
  parallelRanges(portions, 1, threads_, [&](Eigen::Index portion, Eigen::Index) {
    const Eigen::Index begin = portion * kPortion, count = std::min(kPortion, witnesses() - begin);
    const auto derivatives = derivatives_.middleCols(3 * begin, 3 * count);
    Eigen::Matrix<double, 3, Eigen::Dynamic> f = local.transpose() * derivatives; // F of each witness.
    for (Eigen::Index w = 0; w < count; ++w) {
      const Eigen::Matrix3d own = f.middleCols<3>(3 * w);
      energies[portion] += shares_[begin + w] * material_.energy(own);
      if (gradient)
        f.middleCols<3>(3 * w) = shares_[begin + w] * material_.stress(own);
    }
    if (gradient) // dE/dv_i = sum of P grad a_i.
      gradients[std::size_t(portion)] = derivatives * f.transpose();
  });
  double sum = energies.sum();
  const Points ofSprings = springs(pose, sum);
  if (gradient) {
    *gradient = ofSprings;
    for (const Eigen::MatrixXd& part : gradients)
      *gradient += part;
  }
  return sum;
}

double LeastEnergy::energy(const Points& pose) const {
  return evaluate(pose, nullptr);
}

double LeastEnergy::energy(const Points& pose, Points& gradient) const {
  return evaluate(pose, &gradient);
}

Points LeastEnergy::gradient(const Points& pose) const {
  Points found;
  evaluate(pose, &found);
  return found;
}

void LeastEnergy::addSprings(const Points& pose, const std::vector<int>& free,
                             Eigen::MatrixXd& stiffness) const {
  std::vector<Eigen::Index> places(std::size_t(rest_.rows()), -1);
  for (std::size_t i = 0; i < free.size(); ++i)
    places[std::size_t(free[i])] = 3 * static_cast<Eigen::Index>(i);
  const double share = kSprings / static_cast<double>(std::max<std::size_t>(springs_.size(), 1));
  for (const Spring& spring : springs_) {
    const Eigen::Vector3d way = (pose.row(spring.a) - pose.row(spring.b)).transpose();
    const double length = way.norm(), rest = spring.lengthMm;
    if (length == 0)
      continue;
    const Eigen::Matrix3d along = way * way.transpose() / (length * length);
    const double across = std::max(0.0, 1 / (rest * rest) - 1 / (rest * length)); // Of a stretched spring.
    const Eigen::Matrix3d block =
        share * (along / (rest * rest) + across * (Eigen::Matrix3d::Identity() - along));
    const Eigen::Index a = places[std::size_t(spring.a)], b = places[std::size_t(spring.b)];
    if (a >= 0)
      stiffness.block<3, 3>(a, a) += block;
    if (b >= 0)
      stiffness.block<3, 3>(b, b) += block;
    if (a >= 0 && b >= 0) {
      stiffness.block<3, 3>(a, b) -= block;
      stiffness.block<3, 3>(b, a) -= block;
    }
  }
}

Eigen::MatrixXd LeastEnergy::stiffness(const Points& pose, const std::vector<int>& free) const {
  const Eigen::MatrixXd local = (pose.rowwise() - pose.row(0)).eval();
  const auto size = static_cast<Eigen::Index>(free.size());
  const Eigen::Index portions = portionsOf(witnesses());
  // The blocks (a, b) of axes side by side: (0,0) (0,1) (0,2) (1,1) (1,2) (2,2), each `free x free`.
  constexpr std::pair<int, int> kAxes[] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};
  std::vector<Eigen::MatrixXf> sums(static_cast<std::size_t>(portions));
  parallelRanges(portions, 1, threads_, [&](Eigen::Index portion, Eigen::Index) {
    const Eigen::Index begin = portion * kPortion, count = std::min(kPortion, witnesses() - begin);
    const auto derivatives = derivatives_.middleCols(3 * begin, 3 * count);
    const Eigen::Matrix<double, 3, Eigen::Dynamic> f = local.transpose() * derivatives;
    const Eigen::MatrixXf own = derivatives(free, Eigen::all).cast<float>();
    // K_ab = sum over witnesses of G^T H_ab G, with G the derivatives of the free handles' coordinates.
    Eigen::MatrixXf ends(6 * size, 3 * count);
    for (Eigen::Index w = 0; w < count; ++w) {
      const Eigen::Matrix<float, 9, 9> h =
          (shares_[begin + w] * material_.projectedTangent(f.middleCols<3>(3 * w))).cast<float>();
      for (Eigen::Index k = 0; k < 6; ++k)
        ends.block(k * size, 3 * w, size, 3).noalias() =
            own.middleCols<3>(3 * w) * h.block<3, 3>(3 * kAxes[k].first, 3 * kAxes[k].second).transpose();
    }
    sums[std::size_t(portion)].noalias() = own * ends.transpose();
  });
  Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(size, 6 * size);
  for (const Eigen::MatrixXf& sum : sums)
    blocks += sum.cast<double>();
  Eigen::MatrixXd all(3 * size, 3 * size);
  for (Eigen::Index k = 0; k < 6; ++k) {
    const auto [a, b] = kAxes[k];
    for (Eigen::Index i = 0; i < size; ++i)
      for (Eigen::Index j = 0; j < size; ++j)
        all(3 * i + a, 3 * j + b) = all(3 * j + b, 3 * i + a) = blocks(i, k * size + j);
  }
  addSprings(pose, free, all);
  return all;
}

namespace {

/// One minimisation.
class Descent {
public:
  Descent(const LeastEnergy& tissue, const std::vector<int>& free, const deformation::VolumeLock* lock)
      : tissue_(tissue), free_(free), constraint_{lock, free} {}

  /// Takes the stiffness at `pose`; false where it cannot be solved with.
  bool takeStiffness(const Points& pose) {
    Eigen::MatrixXd stiffness = tissue_.stiffness(pose, free_);
    stiffness.diagonal().array() += kDamping * stiffness.trace() / static_cast<double>(stiffness.rows());
    solver_.compute(stiffness);
    return solver_.info() == Eigen::Success;
  }

  /// Newton's step of all handles, `n x 3`; `slope` is the energy's gradient at `pose`.
  Points stepFrom(const Points& pose, const Points& slope) {
    // min dx^T K dx / 2 + g . dx under C dx = -c: dx = y - Z l, with K y = -g, K Z = C^T, C Z l = C y + c.
    const Values g = gatheredRows(slope, free_);
    off_ = constraint_.missing(pose);
    Values motion = solver_.solve(-g);
    if (constraint_.count() > 0) {
      const Eigen::MatrixXd c = constraint_.slopes(pose), z = solver_.solve(c.transpose());
      const Values multipliers = (c * z).completeOrthogonalDecomposition().solve(Values(c * motion + off_));
      motion -= z * multipliers;
      penalty_ = std::max(penalty_, kMeritMargin * multipliers.lpNorm<Eigen::Infinity>());
    }
    descent_ = g.dot(motion) - penalty_ * off_.lpNorm<1>();
    Points step = Points::Zero(pose.rows(), 3);
    for (std::size_t i = 0; i < free_.size(); ++i)
      step.row(free_[i]) = motion.segment<3>(3 * static_cast<Eigen::Index>(i)).transpose();
    return step;
  }

  /// Goes along the step as far as the merit falls, and takes energy and slope there; the part of it, 0:
  /// nowhere.
  double advance(Points& pose, const Points& step, double& energy, Points& slope) const {
    const double before = energy + penalty_ * off_.lpNorm<1>();
    double part = 1;
    for (int i = 0; i < kMostHalvings; ++i, part /= 2) {
      Points next = pose + part * step, slopeThere;
      const double there = tissue_.energy(next, slopeThere); // The first part is nearly always taken.
      const double merit = there + penalty_ * constraint_.missing(next).lpNorm<1>();
      if (std::isfinite(merit) && merit <= before + kSufficient * part * descent_) {
        pose = std::move(next);
        slope = std::move(slopeThere);
        energy = there;
        return part;
      }
    }
    return 0;
  }

private:
  const LeastEnergy& tissue_;
  const std::vector<int>& free_;
  VolumeConstraint constraint_;
  Eigen::LDLT<Eigen::MatrixXd> solver_;
  Values off_;
  double penalty_ = 0, descent_ = 0;
};

} // namespace

RelaxedPose LeastEnergy::relax(const Points& start, const std::vector<int>& free, const Relaxing& relaxing,
                               const deformation::VolumeLock* lock) const {
  RelaxedPose relaxed{start, 0, 0, false};
  Points slope;
  relaxed.energy = evaluate(start, &slope);
  relaxed.converged = free.empty();
  if (free.empty())
    return relaxed;
  const double tolerance = relaxing.tolerance * boundsOf(rest_).diagonal();
  Descent descent(*this, free, lock);
  double lengthBefore = 0;
  bool fresh = false, keep = false;
  while (relaxed.steps < relaxing.mostSteps) {
    if (!keep) {
      if (!descent.takeStiffness(relaxed.pose))
        break;
      fresh = true;
    }
    const Points step = descent.stepFrom(relaxed.pose, slope);
    const double length = longestRowOf(step);
    const double part =
        std::isfinite(length) ? descent.advance(relaxed.pose, step, relaxed.energy, slope) : 0;
    ++relaxed.steps;
    relaxed.converged = length <= tolerance;
    if (relaxed.converged || (part == 0 && fresh))
      break;
    // Newton's steps get shorter quickly near the answer, with an older stiffness as well.
    keep = part == 1 && (lengthBefore == 0 || length < kFastEnough * lengthBefore);
    lengthBefore = part == 1 ? length : 0;
    fresh = false;
  }
  return relaxed;
}

} // namespace viscera::elasticity
