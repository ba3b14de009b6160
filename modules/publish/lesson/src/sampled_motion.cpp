#include "sampled_motion.h"

#include <algorithm>
#include <array>

namespace viscera::lesson {
namespace {

using Track = MotionSamples::Track;

constexpr double kJustBeforeTheEnd = 1 - 1e-9;
constexpr double kJumpMm = 0.01; ///< From the end of a cycle to its beginning.
constexpr double kSameMm = 1e-6;
constexpr int kPieces = 12;                   ///< To begin with.
constexpr double kShortest = 1.0 / 16384;     ///< A shorter piece is not cut, whatever happens in it.
constexpr double kShortestOfMany = 1.0 / 128; ///< The same where the carriers are vertices.
constexpr Eigen::Index kProbes = 300;         ///< Vertices that are looked at while sampling.
constexpr std::size_t kAtOnce = 64;           ///< Moments between two looks at whether to go on.

/// Some of the vertices, spread evenly, and how they hang on the carriers.
class Probes {
public:
  explicit Probes(const CarrierWeights& weights) {
    if (weights.cols() == 0)
      return;
    const Eigen::Index step = std::max<Eigen::Index>(1, weights.rows() / kProbes);
    weights_ = weights(Eigen::seq(0, Eigen::last, step), Eigen::all);
  }
  MotionSamples::Sample sample(double fraction, Points carriers) const {
    const Points moved = weights_.cols() > 0 ? Points(weights_ * carriers) : carriers;
    return {fraction, std::move(carriers), Eigen::Map<const Eigen::RowVectorXd>(moved.data(), moved.size())};
  }

private:
  CarrierWeights weights_;
};

/// The carriers at moments of one rate each, some at once.
std::vector<Points> look(const std::vector<Moment>& moments, const CarriersAt& carriersAt,
                         Progress& progress) {
  std::vector<Points> all;
  for (std::size_t first = 0; first < moments.size(); first += kAtOnce) {
    progress.throwIfCancelled();
    const auto begin = moments.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min(kAtOnce, moments.size() - first));
    std::vector<Points> some = carriersAt({begin, end});
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

CourseEnd endOf(double rate, const CarriersAt& carriersAt) {
  const std::vector<Points> ends = carriersAt({{0, rate}, {kJustBeforeTheEnd, rate}});
  return (ends[1] - ends[0]).cwiseAbs().maxCoeff() > kJumpMm ? CourseEnd::stops : CourseEnd::cycles;
}

/// The rates to be sampled: each that moves in another way than those before it.
void shareTracks(const std::vector<double>& rates, const CarriersAt& carriersAt, MotionSamples& motion) {
  constexpr std::array<double, 5> kTried = {0.07, 0.23, 0.41, 0.66, 0.89};
  std::vector<std::vector<Points>> known;
  for (const double rate : rates) {
    std::vector<Moment> moments;
    for (const double fraction : kTried)
      moments.push_back({fraction, rate});
    std::vector<Points> tried = carriersAt(moments);
    const auto same = std::find_if(known.begin(), known.end(), [&](const std::vector<Points>& other) {
      return std::equal(tried.begin(), tried.end(), other.begin(), [](const Points& a, const Points& b) {
        return (a - b).cwiseAbs().maxCoeff() <= kSameMm;
      });
    });
    motion.trackOfRate.push_back(static_cast<int>(same - known.begin()));
    if (same != known.end())
      continue;
    known.push_back(std::move(tried));
    motion.tracks.push_back({rate, {}});
  }
}

/// Even moments of every track.
void begin(MotionSamples& motion, const Probes& probes, const CarriersAt& carriersAt, Progress& progress) {
  const bool cycles = motion.end == CourseEnd::cycles;
  std::vector<Moment> moments;
  for (const Track& track : motion.tracks)
    for (int i = 0; i < 2 * kPieces + (cycles ? 0 : 1); ++i)
      moments.push_back({std::min(i / (2.0 * kPieces), kJustBeforeTheEnd), track.rate});
  std::vector<Points> found = look(moments, carriersAt, progress);
  std::size_t next = 0;
  for (Track& track : motion.tracks) {
    for (int i = 0; i < 2 * kPieces + (cycles ? 0 : 1); ++i)
      track.samples.push_back(probes.sample(i / (2.0 * kPieces), std::move(found[next++])));
    if (cycles)
      track.samples.push_back(probes.sample(1, track.samples.front().carriers));
  }
}

/// A spline through the samples at even indices.
template <class RowOf>
Course splineOf(const Track& track, CourseEnd end, Eigen::Index columns, const RowOf& rowOf) {
  const std::size_t count = track.samples.size() / 2 + 1;
  std::vector<double> instants;
  Table values(static_cast<Eigen::Index>(count), columns);
  for (std::size_t i = 0; i < count; ++i) {
    instants.push_back(track.samples[2 * i].fraction);
    values.row(static_cast<Eigen::Index>(i)) = rowOf(2 * i);
  }
  return splineThrough(std::move(instants), std::move(values), end);
}

/// A piece that is to be cut in two: where between its ends the motion has been looked at already.
struct Cut {
  std::size_t track, middle;
};

std::vector<Cut> cutsOf(const MotionSamples& motion, double toleranceMm, double shortest) {
  std::vector<Cut> cuts;
  for (std::size_t t = 0; t < motion.tracks.size(); ++t) {
    const auto& samples = motion.tracks[t].samples;
    const Course spline =
        splineOf(motion.tracks[t], motion.end, samples.front().probes.size(),
                 [&](std::size_t i) -> const Eigen::RowVectorXd& { return samples[i].probes; });
    for (std::size_t i = 1; i < samples.size(); i += 2) {
      if (samples[i + 1].fraction - samples[i - 1].fraction <= shortest)
        continue;
      const Eigen::RowVectorXd off = valueAt(spline, samples[i].fraction).transpose() - samples[i].probes;
      const Eigen::Map<const Points> each(off.data(), off.size() / 3, 3);
      if (each.rowwise().norm().maxCoeff() > toleranceMm)
        cuts.push_back({t, i});
    }
  }
  return cuts;
}

/// Looks at the motion in the middle of both halves of each piece that is cut.
void cut(MotionSamples& motion, const std::vector<Cut>& cuts, const Probes& probes,
         const CarriersAt& carriersAt, Progress& progress) {
  std::vector<Moment> moments;
  for (const Cut& each : cuts) {
    const Track& track = motion.tracks[each.track];
    const double middle = track.samples[each.middle].fraction;
    for (const std::size_t end : {each.middle - 1, each.middle + 1})
      moments.push_back({(track.samples[end].fraction + middle) / 2, track.rate});
  }
  std::vector<Points> found = look(moments, carriersAt, progress);
  for (std::size_t i = cuts.size(); i-- > 0;) { // From the last, so that the places of others stay.
    auto& samples = motion.tracks[cuts[i].track].samples;
    const auto middle = static_cast<std::ptrdiff_t>(cuts[i].middle);
    for (const std::size_t half : {2 * i + 1, 2 * i})
      samples.insert(samples.begin() + middle + static_cast<std::ptrdiff_t>(half % 2),
                     probes.sample(moments[half].fraction, std::move(found[half])));
  }
}

/// How many samples of a track are instants of their own: of a cycle the last is the first.
std::size_t ownOf(const MotionSamples& motion, const Track& track) {
  return track.samples.size() - (motion.end == CourseEnd::cycles ? 1 : 0);
}

Instants instantsOf(const MotionSamples& motion) {
  std::size_t all = 0;
  for (const Track& track : motion.tracks)
    all += ownOf(motion, track);
  Instants instants;
  for (Table* axis : {&instants.x, &instants.y, &instants.z})
    axis->resize(static_cast<Eigen::Index>(all), motion.tracks.front().samples.front().carriers.rows());
  Eigen::Index row = 0;
  for (const Track& track : motion.tracks)
    for (std::size_t i = 0; i < ownOf(motion, track); ++i, ++row) {
      const Points& carriers = track.samples[i].carriers;
      instants.x.row(row) = carriers.col(0).transpose();
      instants.y.row(row) = carriers.col(1).transpose();
      instants.z.row(row) = carriers.col(2).transpose();
    }
  return instants;
}

} // namespace

MotionSamples sampleMotion(const std::vector<double>& rates, const CarrierWeights& weights,
                           const CarriersAt& carriersAt, double toleranceMm, Progress& progress) {
  MotionSamples motion;
  if (rates.empty())
    return motion;
  motion.end = endOf(rates.front(), carriersAt);
  shareTracks(rates, carriersAt, motion);
  const Probes probes(weights);
  begin(motion, probes, carriersAt, progress);
  const double shortest = weights.cols() > 0 ? kShortest : kShortestOfMany;
  for (;;) {
    const std::vector<Cut> cuts = cutsOf(motion, toleranceMm, shortest);
    if (cuts.empty())
      return motion;
    cut(motion, cuts, probes, carriersAt, progress);
  }
}

SampledMotion motionOf(const MotionSamples& samples, const CarrierWeights& weights, double toleranceMm,
                       Progress& progress, Threads threads) {
  SampledMotion motion;
  if (samples.tracks.empty())
    return motion;
  MotionModes found = modesOf(instantsOf(samples), weights, toleranceMm, progress, threads);
  motion.modes = std::move(found.modes);
  Eigen::Index first = 0;
  for (const Track& track : samples.tracks) {
    const std::size_t own = ownOf(samples, track);
    const auto rowOf = [&](std::size_t i) {
      return found.course.row(first + static_cast<Eigen::Index>(i < own ? i : 0));
    };
    motion.courses.push_back(splineOf(track, samples.end, found.course.cols(), rowOf));
    Table off(static_cast<Eigen::Index>(track.samples.size() / 2), found.course.cols());
    for (Eigen::Index i = 0; i < off.rows(); ++i) {
      const auto between = static_cast<std::size_t>(2 * i + 1);
      off.row(i) =
          valueAt(motion.courses.back(), track.samples[between].fraction).transpose() - rowOf(between);
    }
    const LargestDifference largest = largestDifference(motion.modes, off);
    motion.betweenMm = std::max(motion.betweenMm, largest.mm);
    motion.worst.push_back(track.samples[static_cast<std::size_t>(2 * largest.row + 1)].fraction);
    first += static_cast<Eigen::Index>(own);
  }
  return motion;
}

} // namespace viscera::lesson
