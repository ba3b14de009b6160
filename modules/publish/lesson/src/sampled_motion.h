#pragma once

#include <functional>
#include <vector>

#include "motion_modes.h"

namespace viscera::lesson {

/// An instant of a motion, and the rate at which it is played.
struct Moment {
  double fraction = 0; ///< Of the cycle, [0, 1].
  double ratePerMinute = 0;
};

/// Returns the displacements of the carriers at these moments, `c x 3` mm from rest each.
using CarriersAt = std::function<std::vector<Points>(const std::vector<Moment>&)>;

/// Samples of a motion, so many that cubic pieces through every second one reproduce the others.
struct MotionSamples {
  struct Sample {
    double fraction = 0;
    Points carriers;           ///< `c x 3` mm from rest.
    Eigen::RowVectorXd probes; ///< x y z of some vertices then, mm from rest.
  };
  /// The samples of one rate. The cubic pieces run through those at even indices; the others are used for
  /// comparison. The last one is the end of the cycle.
  struct Track {
    double rate = 0;
    std::vector<Sample> samples;
  };
  CourseEnd end = CourseEnd::cycles;
  std::vector<Track> tracks;
  std::vector<int> trackOfRate; ///< One for each rate: those whose motion is the same share a track.
};

/// Samples the rates: begins with few moments, spread evenly, and adds a moment in the middle between two if
/// the motion there differs from cubic pieces through the others by more than `toleranceMm`. A corner costs
/// few moments, because they gather around it. `weights` as for `modesOf`; without columns the carriers are
/// the vertices themselves, and fewer moments are kept. Throws `Cancelled`, and what `carriersAt` throws.
MotionSamples sampleMotion(const std::vector<double>& rates, const CarrierWeights& weights,
                           const CarriersAt& carriersAt, double toleranceMm, Progress& progress);

/// A motion as modes and their courses.
struct SampledMotion {
  std::vector<Points> modes;   ///< `n x 3` mm each.
  std::vector<Course> courses; ///< One a track.
  std::vector<double> worst;   ///< One a track: the fraction at which it is off the most between samples.
  double betweenMm = 0;        ///< The error there.
};

/// The modes of what was sampled, so many that no vertex is off by more than `toleranceMm`. Throws
/// `Cancelled`.
SampledMotion motionOf(const MotionSamples& samples, const CarrierWeights& weights, double toleranceMm,
                       Progress& progress, Threads threads);

} // namespace viscera::lesson
