#include "viscera/sequences/gastric_waves.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/sequences/curve.h"

namespace viscera::sequences {
namespace {

// A wave begins to form before it sets out and fades at the pylorus, s.
constexpr double kFormsBefore = 2;
constexpr double kForming = 8;
constexpr double kWaveFading = 4;

// The depth of a wave as a part of the radius, and its width (one standard deviation, mm), over the way.
constexpr double kFirstDepth = 0.14;
constexpr double kDepthGain = 0.48;
constexpr double kDepthPower = 1.3;
constexpr double kFirstWidth = 15;
constexpr double kWidthLoss = 4;

/// Above so many a minute waves meet stomach that has not yet recovered, and are the shallower the more.
constexpr double kFullDepthRate = 4;

// The pylorus begins to close when a wave is in the last part of the antrum and is shut when it has half of
// that way left: as narrow there as its own wall of 3 mm is thick. It opens again while the wave fades.
constexpr double kLastWay = 28; ///< mm
constexpr double kShut = 0.6;
constexpr double kPyloricWidth = 8; ///< One standard deviation, mm.
/// A place narrowed by a wave and by the pylorus at once is hardly narrower than by one of them.
constexpr double kTogether = 8;

/// No ring closes more than this, however many waves meet.
constexpr double kDeepest = 0.9;

/// Waves that are less deep are not reported.
constexpr double kVisible = 0.05;

/// The part of the way at which the antrum begins.
constexpr double kAntrumOnTheWay = 0.4;

double clampedWaveRate(double ratePerMinute) {
  return std::clamp(ratePerMinute, GastricWaves::kLowestRate, GastricWaves::kHighestRate);
}

double periodOf(double ratePerMinute) {
  return 60 / clampedWaveRate(ratePerMinute);
}

} // namespace

GastricWaves::GastricWaves(const GastricCourse& course)
    : course_(course), length_(course.pylorus - course.midBody) {
  if (!(length_ > 0) || !std::isfinite(length_))
    throw DataError("the pylorus does not lie beyond the middle of the body", "gastric waves",
                    "choose the landmarks from the fundus downwards");
  if (!(course_.depth > 0) || !std::isfinite(course_.depth))
    throw DataError(misuse("waves without depth"), "gastric waves", misuse("give a depth above 0"));
}

double GastricWaves::transitSeconds() const {
  return length_ / kSpeed;
}

double GastricWaves::position(double age) const {
  return course_.midBody + kSpeed * std::clamp(age, -kFormsBefore, transitSeconds());
}

double GastricWaves::progress(double age) const {
  return std::clamp((position(age) - course_.midBody) / length_, 0.0, 1.0);
}

double GastricWaves::depth(double age) const {
  const double grown = smoothStep((age + kFormsBefore) / kForming);
  const double left = 1 - smoothStep((age - transitSeconds()) / kWaveFading);
  return course_.depth * (kFirstDepth + kDepthGain * std::pow(progress(age), kDepthPower)) * grown * left;
}

double GastricWaves::depth(double age, double ratePerMinute) const {
  return depth(age) * std::min(1.0, kFullDepthRate / clampedWaveRate(ratePerMinute));
}

double GastricWaves::pylorusClosureAt(double age) const {
  const double left = course_.pylorus - position(age);
  const double closing = smoothStep(2 * (kLastWay - left) / kLastWay);
  return kShut * course_.depth * closing * (1 - smoothStep((age - transitSeconds()) / kWaveFading));
}

double GastricWaves::pyloricClosure(double seconds, double ratePerMinute) const {
  double shut = 0;
  for (const double age : ages(seconds, ratePerMinute))
    shut = std::max(shut, pylorusClosureAt(age));
  return shut / (kShut * course_.depth);
}

std::vector<double> GastricWaves::ages(double seconds, double ratePerMinute) const {
  const double period = periodOf(ratePerMinute);
  const double youngest = seconds - period * std::floor((seconds + kFormsBefore) / period);
  std::vector<double> ages;
  for (double age = youngest; age < transitSeconds() + kWaveFading; age += period)
    ages.push_back(age);
  std::reverse(ages.begin(), ages.end());
  return ages;
}

double GastricWaves::constriction(double s, double seconds, double ratePerMinute) const {
  // Waves leave the product of (1 - depth exp(-(s - s_i)^2 / (2 width^2))). The pylorus joins by the norm
  // (a^8 + b^8)^1/8, nearly the larger of the two without its kink.
  double open = 1;
  for (const double age : ages(seconds, ratePerMinute)) {
    const double width = kFirstWidth - kWidthLoss * progress(age);
    const double away = (s - position(age)) / width;
    open *= 1 - std::min(kDeepest, depth(age, ratePerMinute)) * std::exp(-0.5 * away * away);
  }
  const double away = (s - course_.pylorus) / kPyloricWidth;
  const double pylorus =
      kShut * course_.depth * pyloricClosure(seconds, ratePerMinute) * std::exp(-0.5 * away * away);
  return std::pow(std::pow(1 - open, kTogether) + std::pow(pylorus, kTogether), 1 / kTogether);
}

std::vector<double> GastricWaves::positions(double seconds, double ratePerMinute) const {
  std::vector<double> places;
  for (const double age : ages(seconds, ratePerMinute))
    if (depth(age, ratePerMinute) > kVisible)
      places.push_back(position(age));
  return places;
}

std::vector<NamedPlace> GastricWaves::places() const {
  const auto part = [this](double s) { return s / course_.pylorus; };
  return {{"fundus", 0},
          {"body", part(course_.midBody)},
          {"antrum", part(course_.midBody + kAntrumOnTheWay * length_)},
          {"pylorus", 1}};
}

std::vector<TravellingMark> GastricWaves::travelling(double seconds, double ratePerMinute) const {
  std::vector<TravellingMark> marks;
  for (const double age : ages(seconds, ratePerMinute))
    if (const double deep = depth(age, ratePerMinute); deep > kVisible)
      marks.push_back({std::clamp(position(age) / course_.pylorus, 0.0, 1.0), deep});
  return marks;
}

const char* GastricWaves::placeOf(double age) const {
  if (age >= transitSeconds())
    return "wave fades at the pylorus";
  if (course_.pylorus - position(age) <= kLastWay)
    return "terminal antral contraction";
  return progress(age) >= kAntrumOnTheWay ? "wave in the antrum" : "wave in the body";
}

Text GastricWaves::rateRemark(double ratePerMinute) {
  if (ratePerMinute < kLowestNormalRate)
    return "Bradygastria: healthy people have 2 to 4 waves a minute.";
  if (ratePerMinute > kHighestNormalRate)
    return "Tachygastria: healthy people have 2 to 4 waves a minute.";
  return {};
}

std::vector<Phase> GastricWaves::phases(double ratePerMinute) const {
  constexpr int kSteps = 2000;
  const double period = periodOf(ratePerMinute);
  std::vector<Phase> phases;
  std::string_view last;
  for (int step = 0; step < kSteps; ++step) {
    const double begin = static_cast<double>(step) / kSteps;
    const std::vector<double> waves = ages((begin + 0.5 / kSteps) * period, ratePerMinute);
    const char* name = waves.empty() ? "rest" : placeOf(waves.front());
    if (name != last)
      phases.push_back({name, begin, 1});
    last = name;
    phases.back().end = static_cast<double>(step + 1) / kSteps;
  }
  return phases;
}

} // namespace viscera::sequences
