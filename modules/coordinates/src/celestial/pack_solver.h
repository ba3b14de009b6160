#pragma once

#include "celestial/celestial_kernels.h"
#include "celestial/small_matrices.h"
#include "simd/pack_math.h"

/// The Newton solver of celestial coordinates for a pack of points, one in each SIMD lane.
namespace viscera::coordinates::simd::VISCERA_ISA {

constexpr int kTile = 16;

/// Newton steps for one point. Points on the hull's boundary, where |x| has to grow by a factor of about 1.5
/// a step, take some 40.
constexpr long long kMostIterations = 120;

/// Once the relative gradient and the Newton step are this small that step squares the gradient away; writing
/// the coordinates then looks at what is left, so that most points save one evaluation.
constexpr double kQuadratic = 1e-7;
constexpr double kShortStep = 1e-3;

/// The first steps are taken in single precision where that is faster, at most so many, until the relative
/// gradient and the Newton step are so small that this step takes it to what single precision can tell. (On
/// the hull's boundary the gradient vanishes, too, but the steps grow.)
constexpr bool kSingleIsFaster = kWidth >= 4;
constexpr int kSingleSteps = 12;
constexpr double kArrived = 1e-4;
constexpr double kArrivingStep = 1e-2;

/// After this many steps a solution is good enough within this factor of the tolerance. A point that rounding
/// has put just outside the hull comes near to the tolerance but not below it, and then leaves again.
constexpr long long kPatientSteps = 32;
constexpr double kBoundarySlack = 30;

/// The fraction of the decrease predicted by the gradient that a step has to reach (Armijo).
constexpr double kSufficientDecrease = 1e-4;

/// Changes of F below this part of it are lost in rounding.
constexpr double kValueRounding = 1e-13;

/// Smallest prior weight. Anything positive keeps the coordinates exact; the floor bounds |x|, and with it
/// the number of steps, where a point is very near to a handle.
constexpr double kLeastPrior = 1e-24;

/// Where sum beta falls below this, F goes on falling for ever: the point is outside. A solution never has so
/// little, since the nearest handle's prior weight is 1 and the others' are not below `kLeastPrior`.
constexpr double kVanished = 1e-100;

/// Sums above this are the overflow of a step that went too far.
constexpr double kOverflow = 1e100;

/// A point is outside when x separates it from all handles by this angle or more. Looked at every so many
/// steps (a power of two).
constexpr double kSeparation = 1e-12;
constexpr long long kSeparationPeriod = 8;

/// Every so many steps (a power of two) beyond the first ones, which are enough for most points: see
/// `PackSolver::recenter`.
constexpr long long kCenterPeriod = 8;
constexpr long long kFirstCenter = 11;

/// Sums over the handles at one x: F, its gradient and Hessian, and sum beta.
template <int Dim>
struct Sums {
  Pack value{};
  Pack total{};
  Pack gradient[Dim]{};
  Pack hessian[Dim * (Dim + 1) / 2]{}; ///< Lower triangle by rows.
};

/// The minimum of F for as many points as a pack has lanes, see celestial_kernels.h. The lanes are
/// independent: the results of a lane do not depend on its neighbours.
template <class Function, int Dim, bool Prior>
class PackSolver {
public:
  /// `points` is `Dim x 16`, of which the first lanes are used; `scratch` holds `kCelestialScratch` numbers a
  /// handle.
  PackSolver(const CelestialProblem& problem, const double* points, double* scratch)
      : problem_(problem), scratch_(scratch),
        singles_(reinterpret_cast<float*>(scratch + problem.count * kStride)) {
    for (int row = 0; row < Dim; ++row)
      for (int axis = 0; axis < Dim; ++axis)
        frame_[row][axis] = splat(row == axis);
    look(points);
    if constexpr (Prior)
      weighByDistance();
  }

  /// Writes the coordinates to the first columns of `tile` (`handles x 16`). Gives the lanes without a
  /// solution.
  Mask solve(double* tile) {
    Mask active = usable_ & (interpolated_ == 0);
    failed_ = usable_ == 0;
    bool atZero = true;
    if constexpr (kUsesSingle)
      atZero = bits(approach(active)) == 0;
    for (;; atZero = false) {
      minimise(active, atZero);
      active = writeCoordinates(tile);
      if (bits(active) == 0)
        break;
      recenter(active);
      steps_ -= active; // Counts as a step, so that lanes that rounding keeps open come to an end.
    }
    return failed_;
  }

  /// The minimum x, zero for failed lanes: `Dim x 16`, of which the first lanes are written.
  void writeSolutions(double* solutions) const {
    for (int axis = 0; axis < Dim; ++axis)
      store(solutions + axis * kTile, select(failed_, Pack{}, whole(axis)));
  }

private:
  // The scratch memory holds Dim packs of q for each handle, then these.
  static constexpr int kInverse = Dim * kWidth;     ///< 1 / D.
  static constexpr int kOffset = kInverse + kWidth; ///< q . center.
  static constexpr int kWeight = kOffset + kWidth;  ///< m, where there is a prior.
  static constexpr int kStride = kWeight + (Prior ? kWidth : 0);

  // Behind all of that: of each handle Dim packs of q and, where there is a prior, m, in single precision.
  static constexpr bool kUsesSingle = kSingleIsFaster && Function::kHasSingle;
  static constexpr int kSingleStride = (Dim + (Prior ? 1 : 0)) * kWidth;

  static Pack inverseRoot(Pack value) { return 1.0 / squareRoot(value); }

  double* handle(long index) const { return scratch_ + index * kStride; }
  float* single(long index) const { return singles_ + index * kSingleStride; }

  /// Fills the scratch memory with the handles as seen from the points.
  void look(const double* points) {
    Pack point[Dim], nearest = splat(kFarAway);
    for (int axis = 0; axis < Dim; ++axis)
      point[axis] = load(points + axis * kTile);
    for (long index = 0; index < problem_.count; ++index) {
      Pack offset[Dim];
      for (int axis = 0; axis < Dim; ++axis)
        offset[axis] = problem_.handles[axis * problem_.count + index] - point[axis];
      const Pack squared = dot(offset, offset);
      const Pack inverse = inverseRoot(squared + problem_.softnessSquared);
      for (int axis = 0; axis < Dim; ++axis) {
        const Pack q = offset[axis] * inverse;
        store(handle(index) + axis * kWidth, q);
        if constexpr (kUsesSingle)
          store(single(index) + axis * kWidth, q);
      }
      store(handle(index) + kInverse, inverse);
      store(handle(index) + kOffset, Pack{});
      const Mask nearer = squared < nearest;
      nearest = select(nearer, squared, nearest);
      nearestHandle_ = select(nearer, splat(static_cast<double>(index)), nearestHandle_);
    }
    usable_ = nearest < kFarAway; // Not so for a point that is not finite.
    if (problem_.softnessSquared == 0)
      interpolated_ = nearest <= problem_.samePlaceSquared;
    nearestInverse_ = inverseRoot(nearest + problem_.softnessSquared);
  }

  void weighByDistance() {
    for (long index = 0; index < problem_.count; ++index) {
      const Pack ratio = larger(load(handle(index) + kInverse) / nearestInverse_, splat(1e-300));
      const Pack weight = larger(exponential(problem_.locality * logarithm(ratio)), splat(kLeastPrior));
      store(handle(index) + kWeight, weight);
      if constexpr (kUsesSingle)
        store(single(index) + Dim * kWidth, weight);
    }
  }

  /// q . x of a handle.
  Pack along(const double* from) const {
    Pack t = load(from + kOffset);
    for (int axis = 0; axis < Dim; ++axis)
      t += load(from + axis * kWidth) * x_[axis];
    return t;
  }

  /// Moves the origin of x_ to where the lanes stand, and turns its axes into the Hessian's principal
  /// directions. Near the hull's boundary |x| is huge, and steps of its last digit would be too coarse for
  /// the handles of the nearby face, edge or corner; F is as good as flat there in some directions and not in
  /// others, and along any other axes the small curvatures would drown in the rounding of the large ones. The
  /// rounding of `q . center` is harmless: it acts like a slightly different prior weight.
  void recenter(Mask lanes) {
    Pack turn[Dim][Dim];
    principalDirections(hessian_, turn);
    for (int row = 0; row < Dim; ++row)
      for (int axis = 0; axis < Dim; ++axis)
        turn[row][axis] = select(lanes, turn[row][axis], splat(row == axis));
    for (long index = 0; index < problem_.count; ++index) {
      double* at = handle(index);
      store(at + kOffset, select(lanes, along(at), load(at + kOffset)));
      Pack q[Dim];
      for (int axis = 0; axis < Dim; ++axis)
        q[axis] = load(at + axis * kWidth);
      for (int row = 0; row < Dim; ++row)
        store(at + row * kWidth, dot(turn[row], q));
    }
    for (int axis = 0; axis < Dim; ++axis)
      center_[axis] = select(lanes, whole(axis), center_[axis]);
    turnFrame(turn);
    for (Pack& each : x_)
      each = select(lanes, Pack{}, each);
  }

  void turnFrame(const Pack (&turn)[Dim][Dim]) {
    for (int axis = 0; axis < Dim; ++axis) {
      Pack column[Dim];
      for (int row = 0; row < Dim; ++row)
        column[row] = frame_[row][axis];
      for (int row = 0; row < Dim; ++row)
        frame_[row][axis] = dot(turn[row], column);
    }
  }

  /// A component of the whole x, along the original axes.
  Pack whole(int axis) const {
    Pack sum = center_[axis];
    for (int row = 0; row < Dim; ++row)
      sum += frame_[row][axis] * x_[row];
    return sum;
  }

  Pack distanceFromZero() const {
    Pack all[Dim];
    for (int axis = 0; axis < Dim; ++axis)
      all[axis] = whole(axis);
    return squareRoot(dot(all, all));
  }

  /// The sums at x_, which is zero for all lanes with AtZero: there phi needs no root and no exponential.
  template <bool AtZero>
  Sums<Dim> evaluate() const {
    Sums<Dim> sums;
    for (long index = 0; index < problem_.count; ++index) {
      const double* from = handle(index);
      FunctionValues phi = Function::kAtZero;
      if constexpr (!AtZero)
        phi = Function::evaluate(along(from));
      if constexpr (Prior) {
        const Pack weight = load(from + kWeight);
        phi = {phi.value * weight, phi.first * weight, phi.second * weight};
      }
      sums.value += phi.value;
      sums.total += phi.first;
      for (int row = 0, entry = 0; row < Dim; ++row) {
        const Pack q = load(from + row * kWidth);
        sums.gradient[row] += phi.first * q;
        const Pack scaled = phi.second * q;
        for (int column = 0; column <= row; ++column, ++entry)
          sums.hessian[entry] += scaled * load(from + column * kWidth);
      }
    }
    return sums;
  }

  /// The total, the gradient and the Hessian at x_ (or zero), summed in single precision.
  template <bool AtZero>
  Sums<Dim> evaluateSingle() const {
    constexpr int kEntries = Dim * (Dim + 1) / 2;
    SinglePack x[Dim], total{}, gradient[Dim]{}, hessian[kEntries]{};
    for (int axis = 0; axis < Dim; ++axis)
      x[axis] = __builtin_convertvector(x_[axis], SinglePack);
    for (long index = 0; index < problem_.count; ++index) {
      const float* from = single(index);
      SinglePack q[Dim], t{};
      for (int axis = 0; axis < Dim; ++axis) {
        q[axis] = loadSingle(from + axis * kWidth);
        t += q[axis] * x[axis];
      }
      SingleSlopes phi{SinglePack{} + 1.0f, SinglePack{} + 2.0f};
      if constexpr (!AtZero)
        phi = Function::slopes(t);
      if constexpr (Prior) {
        const SinglePack weight = loadSingle(from + Dim * kWidth);
        phi = {phi.first * weight, phi.second * weight};
      }
      total += phi.first;
      for (int row = 0, entry = 0; row < Dim; ++row) {
        gradient[row] += phi.first * q[row];
        const SinglePack scaled = phi.second * q[row];
        for (int column = 0; column <= row; ++column, ++entry)
          hessian[entry] += scaled * q[column];
      }
    }
    Sums<Dim> sums;
    sums.total = widened(total);
    for (int axis = 0; axis < Dim; ++axis)
      sums.gradient[axis] = widened(gradient[axis]);
    for (int entry = 0; entry < kEntries; ++entry)
      sums.hessian[entry] = widened(hessian[entry]);
    return sums;
  }

  /// Newton steps from zero in single precision, to begin near the minimum. Gives the lanes that are there;
  /// the others, such as those of points near the hull's boundary, begin at zero.
  Mask approach(Mask lanes) {
    Mask arrived{};
    for (int step = 0; step < kSingleSteps && bits(lanes) != 0; ++step) {
      const Sums<Dim> sums = step == 0 ? evaluateSingle<true>() : evaluateSingle<false>();
      Pack next[Dim];
      newtonStep(sums.hessian, sums.gradient, next);
      shorten(next);
      for (int axis = 0; axis < Dim; ++axis)
        x_[axis] = select(lanes, x_[axis] + next[axis], x_[axis]);
      const Mask now = lanes &
                       (dot(sums.gradient, sums.gradient) <= kArrived * kArrived * sums.total * sums.total) &
                       (dot(next, next) <= kArrivingStep * kArrivingStep);
      arrived |= now;
      lanes &= ~now;
    }
    for (Pack& each : x_)
      each = select(arrived, each, Pack{});
    return arrived;
  }

  /// No step is longer than 2 (1 + |x|): far from the solution the quadratic model is not accurate.
  void shorten(Pack (&step)[Dim]) const {
    const Pack length = squareRoot(dot(step, step));
    const Pack most = 2.0 + 2.0 * distanceFromZero();
    const Pack factor = select(length > most, most / length, splat(1));
    for (Pack& each : step)
      each *= factor;
  }

  /// Lanes whose x separates their point from every handle: they are outside the hull.
  Mask separated() const {
    Pack most = splat(-kFarAway);
    for (long index = 0; index < problem_.count; ++index)
      most = larger(most, along(handle(index)));
    return most < -kSeparation * distanceFromZero();
  }

  Pack tolerance() const {
    return select(steps_ >= kPatientSteps, splat(kBoundarySlack * problem_.tolerance),
                  splat(problem_.tolerance));
  }

  /// Newton steps, halved until F decreases, for the lanes of `active`, until each is as good as solved or
  /// has failed.
  void minimise(Mask active, bool atZero) {
    Pack base[Dim]{}, step[Dim]{}, bound = splat(kFarAway), slope{}, scale = splat(1);
    while (bits(active) != 0) {
      const Sums<Dim> sums = atZero ? evaluate<true>() : evaluate<false>();
      for (int entry = 0; entry < Dim * (Dim + 1) / 2; ++entry)
        hessian_[entry] = sums.hessian[entry];
      atZero = false;
      const Mask better = sums.value <= bound + kSufficientDecrease * scale * slope;
      const Pack error2 = dot(sums.gradient, sums.gradient), total2 = sums.total * sums.total;
      failed_ |= active & (sums.total < kVanished);
      active &= ~failed_;
      // Half of what is asked for when the coordinates are written, whose sums round differently.
      const Pack enough = 0.5 * tolerance();
      active &= ~(better & (error2 <= enough * enough * total2));
      if (bits(active) == 0)
        return;

      const Mask accepted = active & better;
      const Mask due =
          accepted & (steps_ >= kFirstCenter) & (((steps_ - kFirstCenter) & (kCenterPeriod - 1)) == 0);
      Pack next[Dim];
      newtonStep(sums.hessian, sums.gradient, next);
      shorten(next);
      for (Pack& each : next)
        each = select(due, Pack{}, each); // These lanes stay, to look again along better axes.
      slope = select(accepted, dot(sums.gradient, next), slope);
      bound = select(accepted, sums.value * (1 + kValueRounding), bound);
      scale = select(accepted, splat(1), select(active, scale * 0.5, scale));
      for (int axis = 0; axis < Dim; ++axis) {
        base[axis] = select(accepted, x_[axis], base[axis]);
        step[axis] = select(accepted, next[axis], step[axis]);
        x_[axis] = select(active, base[axis] + scale * step[axis], x_[axis]);
      }
      steps_ -= active; // Minus -1.
      const Mask last =
          (error2 <= kQuadratic * kQuadratic * total2) & (dot(next, next) <= kShortStep * kShortStep);
      active = withoutUnsolvable(active & ~(accepted & ~due & last));

      if (bits(due) != 0) {
        recenter(due);
        for (Pack& each : base)
          each = select(due, Pack{}, each);
        bound = select(due, splat(kFarAway), bound); // The same x, but F differs by rounding.
      }
    }
  }

  /// `active` without the lanes that are outside the hull, or have used up their steps.
  Mask withoutUnsolvable(Mask active) {
    exhausted_ |= active & (steps_ >= kMostIterations);
    active &= ~exhausted_;
    const Mask due = active & ((steps_ & (kSeparationPeriod - 1)) == 0);
    if (bits(due) == 0)
      return active;
    const Mask outside = due & separated();
    failed_ |= outside;
    return active & ~outside;
  }

  /// Writes the normalised coordinates at x_, zero for failed lanes. Gives the lanes that need further steps;
  /// those that no step improves and that are not good enough join the failed ones.
  Mask writeCoordinates(double* tile) {
    Pack total{}, weights{}, gradient[Dim]{};
    for (long index = 0; index < problem_.count; ++index) {
      const double* from = handle(index);
      Pack beta = Function::first(along(from));
      if constexpr (Prior)
        beta *= load(from + kWeight);
      total += beta;
      for (int axis = 0; axis < Dim; ++axis)
        gradient[axis] += beta * load(from + axis * kWidth);
      const Pack weight = beta * load(from + kInverse);
      weights += weight;
      store(tile + index * kTile, weight);
    }
    exhausted_ |= steps_ >= kMostIterations;
    const Pack error = squareRoot(dot(gradient, gradient));
    const Mask good = (error <= tolerance() * total) & (total < kOverflow);
    const Mask open = ~(interpolated_ | failed_ | good);
    failed_ |= open & exhausted_;
    const Mask remaining = open & ~exhausted_;
    if (bits(remaining) == 0)
      normalise(tile, weights);
    return remaining;
  }

  void normalise(double* tile, Pack weights) const {
    const Pack factor = 1.0 / weights;
    for (long index = 0; index < problem_.count; ++index) {
      const Pack indicator = select(nearestHandle_ == static_cast<double>(index), splat(1), Pack{});
      const Pack value = select(interpolated_, indicator, load(tile + index * kTile) * factor);
      store(tile + index * kTile, select(failed_, Pack{}, value));
    }
  }

  static constexpr double kFarAway = 1e300;

  const CelestialProblem& problem_;
  double* scratch_;
  float* singles_;
  Pack center_[Dim]{};
  Pack frame_[Dim][Dim]; ///< The axes of x_ and of the handles' q, as rows.
  Pack x_[Dim]{};        ///< From `center_`, along the rows of `frame_`.
  Pack hessian_[Dim * (Dim + 1) / 2]{};
  Pack nearestHandle_{};
  Pack nearestInverse_{};
  Mask interpolated_{};
  Mask usable_{};
  Mask failed_{};
  Mask exhausted_{};
  Mask steps_{}; ///< How many each lane has taken.
};

} // namespace viscera::coordinates::simd::VISCERA_ISA
