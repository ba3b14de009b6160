#include "viscera/sequences/gastric_waves.h"

#include <algorithm>
#include <cmath>

#include "viscera/core/error.h"
#include "viscera/sequences/curve.h"

namespace viscera::sequences {
namespace {

// How fast a wave is where it arises and at the pylorus, mm/s; in between it gains speed with the way.
constexpr double kFirstSpeed = 3.0;
constexpr double kLastSpeed = 6.5;

// It forms before it sets out and fades at the pylorus, s.
constexpr double kFormsBefore = 3;
constexpr double kForming = 8;
constexpr double kFading = 4;

// Its depth as a part of the radius, and its width (one standard deviation, mm), over the way.
constexpr double kFirstDepth = 0.14;
constexpr double kDepthGain = 0.48;
constexpr double kDepthPower = 1.3;
constexpr double kFirstWidth = 15;
constexpr double kWidthLoss = 4;

/// No ring closes more than this, however many waves meet.
constexpr double kDeepest = 0.9;

/// A wave is told of when it is deeper than this.
constexpr double kVisible = 0.05;

// Parts of the way at which the antrum and its last part begin.
constexpr double kAntrum = 0.4;
constexpr double kLastAntrum = 0.85;

double periodOf(double ratePerMinute) {
  return 60 / std::clamp(ratePerMinute, GastricWaves::kLowestRate, GastricWaves::kHighestRate);
}

} // namespace

GastricWaves::GastricWaves(const GastricCourse& course)
    : course_(course), length_(course.pylorus - course.midBody) {
  if (!(length_ > 0) || !std::isfinite(length_))
    throw DataError("the pylorus does not lie beyond the middle of the body", "gastric waves",
                    "choose the landmarks from the fundus downwards");
  if (!(course_.depth > 0) || !std::isfinite(course_.depth))
    throw DataError("waves without depth", "gastric waves", "give a depth above 0");
}

double GastricWaves::transitSeconds() const {
  return length_ / (kLastSpeed - kFirstSpeed) * std::log(kLastSpeed / kFirstSpeed);
}

double GastricWaves::position(double age) const {
  const double gain = kLastSpeed - kFirstSpeed;
  const double moving = std::clamp(age, -kFormsBefore, transitSeconds());
  return course_.midBody + kFirstSpeed * length_ / gain * std::expm1(gain * moving / length_);
}

double GastricWaves::progress(double age) const {
  return std::clamp((position(age) - course_.midBody) / length_, 0.0, 1.0);
}

double GastricWaves::depth(double age) const {
  const double grown = smoothStep((age + kFormsBefore) / kForming);
  const double left = 1 - smoothStep((age - transitSeconds()) / kFading);
  return course_.depth * (kFirstDepth + kDepthGain * std::pow(progress(age), kDepthPower)) * grown * left;
}

std::vector<double> GastricWaves::ages(double seconds, double ratePerMinute) const {
  const double period = periodOf(ratePerMinute);
  const double youngest = seconds - period * std::floor((seconds + kFormsBefore) / period);
  std::vector<double> ages;
  for (double age = youngest; age < transitSeconds() + kFading; age += period)
    ages.push_back(age);
  std::reverse(ages.begin(), ages.end());
  return ages;
}

double GastricWaves::constriction(double s, double seconds, double ratePerMinute) const {
  double open = 1;
  for (const double age : ages(seconds, ratePerMinute)) {
    const double width = kFirstWidth - kWidthLoss * progress(age);
    const double away = (s - position(age)) / width;
    open *= 1 - std::min(kDeepest, depth(age)) * std::exp(-0.5 * away * away);
  }
  return 1 - open;
}

std::vector<double> GastricWaves::positions(double seconds, double ratePerMinute) const {
  std::vector<double> places;
  for (const double age : ages(seconds, ratePerMinute))
    if (depth(age) > kVisible)
      places.push_back(position(age));
  return places;
}

std::vector<NamedPlace> GastricWaves::places() const {
  const auto part = [this](double s) { return s / course_.pylorus; };
  return {{"fundus", 0},
          {"body", part(course_.midBody)},
          {"antrum", part(course_.midBody + kAntrum * length_)},
          {"pylorus", 1}};
}

std::vector<TravellingMark> GastricWaves::travelling(double seconds, double ratePerMinute) const {
  std::vector<TravellingMark> marks;
  for (const double age : ages(seconds, ratePerMinute))
    if (depth(age) > kVisible)
      marks.push_back({std::clamp(position(age) / course_.pylorus, 0.0, 1.0), depth(age)});
  return marks;
}

const char* GastricWaves::placeOf(double age) const {
  if (age >= transitSeconds())
    return "wave fades at the pylorus";
  const double way = progress(age);
  if (way >= kLastAntrum)
    return "terminal antral contraction";
  return way >= kAntrum ? "wave in the antrum" : "wave in the body";
}

std::vector<Phase> GastricWaves::phases(double ratePerMinute) const {
  constexpr int kSteps = 2000;
  const double period = periodOf(ratePerMinute);
  std::vector<Phase> phases;
  for (int step = 0; step < kSteps; ++step) {
    const double begin = static_cast<double>(step) / kSteps;
    const std::vector<double> waves = ages((begin + 0.5 / kSteps) * period, ratePerMinute);
    const char* name = waves.empty() ? "rest" : placeOf(waves.front());
    if (phases.empty() || phases.back().name != name)
      phases.push_back({name, begin, 1});
    phases.back().end = static_cast<double>(step + 1) / kSteps;
  }
  return phases;
}

} // namespace viscera::sequences
