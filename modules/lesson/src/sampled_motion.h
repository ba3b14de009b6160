#pragma once

#include <functional>
#include <vector>

#include "motion_modes.h"

namespace viscera::lesson {

/// Fills where the carriers are at a fraction of the cycle and a rate, `c x 3` mm from rest.
using CarriersAt = std::function<void(double fraction, double ratePerMinute, Points& displacements)>;

/// How far a lesson's motion may be off.
struct Accuracy {
  double modesMm = 0.005;  ///< By the modes that are left out.
  double betweenMm = 0.03; ///< Between samples.
};

/// A motion in few numbers.
struct SampledMotion {
  std::vector<Points> modes; ///< `n x 3` mm each.
  CourseEnd end = CourseEnd::cycles;
  std::vector<Course> courses;   ///< Splines, `samples x modes`.
  std::vector<int> courseOfRate; ///< One a rate.
  std::vector<double> rates;     ///< One a course: the rate at which it was sampled.
  std::vector<double> worst;     ///< One a course: the fraction at which it is off the most between samples.
  double betweenMm = 0;          ///< By how much.
};

inline constexpr Eigen::Index kFewestSamples = 96;
inline constexpr Eigen::Index kMostSamples = 768;

/// Samples the rates at `kFewestSamples` instants a cycle: doubled until what lies in the middle between two
/// is met, or there are `kMostSamples`. Rates whose motion is the same share a course. `weights` as for
/// `modesOf`; without columns the carriers are the vertices themselves. Throws `Cancelled`, and what
/// `carriersAt` throws.
SampledMotion sampledMotion(const std::vector<double>& rates, const CarrierWeights& weights,
                            const CarriersAt& carriersAt, const Accuracy& accuracy, Progress& progress,
                            Threads threads);

} // namespace viscera::lesson
