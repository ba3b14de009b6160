#pragma once

#include <functional>
#include <vector>

#include "motion_modes.h"

namespace viscera::lesson {

/// An instant of a motion, and how fast that runs.
struct Moment {
  double fraction = 0; ///< Of the cycle, [0, 1].
  double ratePerMinute = 0;
};

/// Where the carriers are at these moments, `c x 3` mm from rest each.
using CarriersAt = std::function<std::vector<Points>(const std::vector<Moment>&)>;

/// A motion that was looked at in so many moments that cubic pieces between every second of them meet the
/// others.
struct MotionSamples {
  struct Sample {
    double fraction = 0;
    Points carriers;           ///< `c x 3` mm from rest.
    Eigen::RowVectorXd probes; ///< x y z of some vertices then, mm from rest.
  };
  /// One rate. What lies at even places the pieces run through, what lies between is there to compare them
  /// with; the last one is the end of the cycle.
  struct Track {
    double rate = 0;
    std::vector<Sample> samples;
  };
  CourseEnd end = CourseEnd::cycles;
  std::vector<Track> tracks;
  std::vector<int> trackOfRate; ///< One a rate: those whose motion is the same share a track.
};

/// Samples the rates: begins with few moments, spread evenly, and looks again in the middle between two where
/// the motion there is not what cubic pieces through the others say, to `toleranceMm`. A corner costs few
/// moments, because they gather around it. `weights` as for `modesOf`; without columns the carriers are the
/// vertices themselves, and fewer moments are kept. Throws `Cancelled`, and what `carriersAt` throws.
MotionSamples sampleMotion(const std::vector<double>& rates, const CarrierWeights& weights,
                           const CarriersAt& carriersAt, double toleranceMm, Progress& progress);

/// A motion in few numbers.
struct SampledMotion {
  std::vector<Points> modes;   ///< `n x 3` mm each.
  std::vector<Course> courses; ///< One a track.
  std::vector<double> worst;   ///< One a track: the fraction at which it is off the most between samples.
  double betweenMm = 0;        ///< By how much.
};

/// The modes of what was sampled, so many that no vertex is off by more than `toleranceMm`. Throws
/// `Cancelled`.
SampledMotion motionOf(const MotionSamples& samples, const CarrierWeights& weights, double toleranceMm,
                       Progress& progress, Threads threads);

} // namespace viscera::lesson
