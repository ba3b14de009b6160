#include "viscera/sequences/keyframes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::sequences {
namespace {

constexpr std::array kEasings{std::pair{Easing::linear, "linear"}, std::pair{Easing::smooth, "smooth"},
                              std::pair{Easing::in, "in"}, std::pair{Easing::out, "out"},
                              std::pair{Easing::hold, "hold"}};
constexpr std::array kInterpolations{std::pair{Interpolation::eased, "eased"},
                                     std::pair{Interpolation::curve, "curve"}};

template <class Value, std::size_t count>
std::string nameIn(const std::array<std::pair<Value, const char*>, count>& list, Value value) {
  for (const auto& [one, name] : list)
    if (one == value)
      return name;
  return {};
}

template <class Value, std::size_t count>
std::optional<Value> valueIn(const std::array<std::pair<Value, const char*>, count>& list,
                             const std::string& name) {
  for (const auto& [value, one] : list)
    if (one == name)
      return value;
  return std::nullopt;
}

std::string inSeconds(double seconds) {
  std::ostringstream text;
  text << seconds << " s";
  return text.str();
}

void requireKey(const KeyframedSequence::Track& track, std::size_t i) {
  const Keyframe& key = track.keys[i];
  const Text where = phrase("key %1", i + 1);
  if (!std::isfinite(key.seconds))
    throw DataError(diagnostic("its time is not a finite number"), where);
  if (key.pose.rows() != track.restHandles.rows())
    throw DataError(diagnostic("its pose has %n {handle|handles} instead of %2", key.pose.rows(),
                               track.restHandles.rows()),
                    where);
  if (!key.pose.allFinite())
    throw DataError(diagnostic("a handle's position is not a finite number"), where);
  if (key.seconds < 0 || !(key.seconds < track.periodSeconds))
    throw DataError(diagnostic("its time, %1, is outside the period of %2", inSeconds(key.seconds),
                               inSeconds(track.periodSeconds)),
                    where, "move it, or lengthen the period");
  if (i > 0 && key.seconds - track.keys[i - 1].seconds < kShortestSpan)
    throw DataError(
        diagnostic("its time, %1, is not after that of the key before it", inSeconds(key.seconds)), where,
        misuse("sort the keys by time and leave a millisecond at least between two"));
}

} // namespace

std::string nameOf(Easing easing) {
  return nameIn(kEasings, easing);
}

std::optional<Easing> easingFromName(const std::string& name) {
  return valueIn(kEasings, name);
}

std::string nameOf(Interpolation interpolation) {
  return nameIn(kInterpolations, interpolation);
}

std::optional<Interpolation> interpolationFromName(const std::string& name) {
  return valueIn(kInterpolations, name);
}

double eased(Easing easing, double part) {
  part = std::clamp(part, 0.0, 1.0);
  switch (easing) {
  case Easing::linear:
    return part;
  case Easing::smooth:
    return smoothStep(part);
  case Easing::in:
    return part * part;
  case Easing::out:
    return part * (2 - part);
  case Easing::hold:
    return 0;
  }
  return part;
}

KeyframedSequence::KeyframedSequence(Track track) : track_(std::move(track)) {
  if (track_.keys.empty())
    throw DataError("there is no key", track_.name, "add a key first");
  if (!(track_.periodSeconds >= kShortestSpan) || !std::isfinite(track_.periodSeconds))
    throw DataError(diagnostic("the period is not a positive number of seconds"), track_.name);
  if (!track_.restHandles.allFinite())
    throw DataError(diagnostic("a handle's rest position is not a finite number"), track_.name);
  for (std::size_t i = 0; i < track_.keys.size(); ++i)
    requireKey(track_, i);
  if (track_.interpolation == Interpolation::curve && track_.keys.size() > 1)
    makeCurves();
}

void KeyframedSequence::makeCurves() {
  const Eigen::Index coordinates = track_.restHandles.size();
  for (Eigen::Index c = 0; c < coordinates; ++c) {
    std::vector<Key> keys;
    for (const Keyframe& frame : track_.keys)
      keys.push_back({frame.seconds, frame.pose.data()[c]});
    curves_.push_back(track_.loop ? Curve::periodic(std::move(keys), track_.periodSeconds)
                                  : Curve::through(std::move(keys)));
  }
}

KeyframedSequence::Place KeyframedSequence::placeAt(double seconds) const {
  const std::vector<Keyframe>& keys = track_.keys;
  const auto after = std::upper_bound(keys.begin(), keys.end(), seconds,
                                      [](double value, const Keyframe& key) { return value < key.seconds; });
  const auto next = static_cast<std::size_t>(after - keys.begin());
  const std::size_t last = keys.size() - 1;
  const bool within = next > 0 && next <= last;
  if (!within && !track_.loop)
    return {next == 0 ? 0 : last, next == 0 ? 0 : last, 0};
  const std::size_t from = within ? next - 1 : last;
  const std::size_t to = within ? next : 0;
  const double span = keys[to].seconds - keys[from].seconds + (within ? 0 : track_.periodSeconds);
  const double passed = seconds - keys[from].seconds + (next == 0 ? track_.periodSeconds : 0);
  return {from, to, eased(keys[from].easing, passed / span)};
}

void KeyframedSequence::poseAt(double seconds, double ratePerMinute, Points& pose) const {
  const double rate = std::clamp(ratePerMinute, lowestRatePerMinute(), highestRatePerMinute());
  // Take the time of the recording; at the standard rate exactly that which was asked for.
  double inside = rate == standardRatePerMinute() ? seconds : seconds * rate / standardRatePerMinute();
  inside -= track_.periodSeconds * std::floor(inside / track_.periodSeconds);
  if (!curves_.empty()) {
    pose.resize(track_.restHandles.rows(), 3);
    for (std::size_t c = 0; c < curves_.size(); ++c)
      pose.data()[c] = curves_[c].at(inside);
    return;
  }
  const Place place = placeAt(inside);
  const Points& from = track_.keys[place.from].pose;
  if (place.part == 0)
    pose = from;
  else
    pose = from + place.part * (track_.keys[place.to].pose - from);
}

/// Each instant is named after the key that is nearest to it, as tables of the keys mark it: every key has
/// its surroundings, from half way before it to half way behind it.
std::vector<Phase> KeyframedSequence::phases(double) const {
  std::vector<Phase> phases;
  const auto add = [&](Text name, double seconds) {
    const double begin = seconds / track_.periodSeconds;
    if (!phases.empty())
      phases.back().end = begin;
    phases.push_back({std::move(name), begin, 1});
  };
  const std::vector<Keyframe>& keys = track_.keys;
  if (keys.front().seconds > 0)
    add("start", 0);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const double before = i > 0 ? keys[i - 1].seconds : 0;
    add(phrase("key %1", i + 1), 0.5 * (before + keys[i].seconds));
  }
  if (track_.loop && keys.size() > 1 && keys.front().seconds == 0) // The first key comes again.
    add(phrase("key %1", 1), 0.5 * (keys.back().seconds + track_.periodSeconds));
  return phases;
}

std::vector<double> KeyframedSequence::keys() const {
  std::vector<double> seconds;
  for (const Keyframe& key : track_.keys)
    seconds.push_back(key.seconds);
  return seconds;
}

} // namespace viscera::sequences
