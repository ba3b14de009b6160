#include "body_axes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace viscera::medical_io {
namespace {

/// An organ's squared distance along one direction, in standard deviations, counts up to this: a wrong name
/// is no stronger evidence than an unusual place.
constexpr double kMostCost = 16;
/// What files that are not in LPS are, from the most to the least frequent.
constexpr double kOfRas = 0.5, kOfMirrored = 1, kOfOtherSigns = 3, kOfOtherAxes = 8;
/// Within these an adult's body explains the distances.
constexpr double kSmallestBody = 0.75, kLargestBody = 1.3;
/// Distances of fewer organs do not tell a small body from another arrangement.
constexpr std::size_t kEnoughForSize = 5;
/// Distances of few organs say little of the size: these are tried beside what they say.
constexpr std::array kOtherSizes = {0.65, 0.8, 1.25, 1.5};
constexpr std::size_t kMostStarts = 64;
constexpr int kRounds = 4;

/// One organ along one axis.
struct Offset {
  double off = 0, spread = 1, weight = 1;
};

double costAt(const std::vector<Offset>& offsets, double shift) {
  double cost = 0;
  for (const Offset& one : offsets) {
    const double away = (one.off - shift) / one.spread;
    cost += one.weight * std::min(away * away, kMostCost);
  }
  return cost;
}

/// The mean of the offsets that are not too far from a shift; the shift itself where all are.
double refined(const std::vector<Offset>& offsets, double shift) {
  double sum = 0, weights = 0;
  for (const Offset& one : offsets) {
    const double away = (one.off - shift) / one.spread;
    if (away * away > kMostCost)
      continue;
    const double weight = one.weight / (one.spread * one.spread);
    sum += weight * one.off;
    weights += weight;
  }
  return weights > 0 ? sum / weights : shift;
}

double meanOf(const std::vector<Offset>& offsets) {
  double sum = 0, weights = 0;
  for (const Offset& one : offsets) {
    const double weight = one.weight / (one.spread * one.spread);
    sum += weight * one.off;
    weights += weight;
  }
  return weights > 0 ? sum / weights : 0;
}

/// The shift with the least bounded cost: the bound makes valleys around single organs, so the search starts
/// from each.
double bestShift(const std::vector<Offset>& offsets) {
  double best = meanOf(offsets), bestCost = costAt(offsets, best);
  const std::size_t step = offsets.size() / kMostStarts + 1;
  for (std::size_t start = 0; start <= offsets.size(); start += step) {
    double shift = start < offsets.size() ? offsets[start].off : meanOf(offsets);
    for (int round = 0; round < kRounds; ++round)
      shift = refined(offsets, shift);
    if (const double cost = costAt(offsets, shift); cost < bestCost) {
      best = shift;
      bestCost = cost;
    }
  }
  return best;
}

/// How far the organs are from their places when the body's direction lies along an axis of the file.
std::vector<Offset> offsetsAlong(const std::vector<KnownOrgan>& organs, double factor, int direction,
                                 int axis, int sign) {
  std::vector<Offset> offsets;
  for (const KnownOrgan& organ : organs)
    if (std::isfinite(organ.spread[direction]))
      offsets.push_back({sign * organ.at[axis] / factor - organ.expected[direction], organ.spread[direction],
                         organ.weight});
  return offsets;
}

double rarity(const BodyWay& way) {
  if (!way.alongAxes())
    return kOfOtherAxes;
  if (way.isLps())
    return 0;
  const bool headUp = way.sign[2] > 0;
  if (way.sign[0] < 0 && headUp)
    return way.sign[1] < 0 ? kOfRas : kOfMirrored;
  return kOfOtherSigns;
}

/// The middle of values by their weights.
double weightedMedian(std::vector<std::pair<double, double>> values) {
  std::sort(values.begin(), values.end());
  double all = 0;
  for (const auto& [value, weight] : values)
    all += weight;
  double below = 0;
  for (const auto& [value, weight] : values)
    if ((below += weight) >= all / 2)
      return value;
  return 1;
}

/// All ways in their order, with the costs of one size.
std::vector<BodyWay> waysOfSize(const std::vector<KnownOrgan>& organs, double factor) {
  double costs[3][3][2];
  for (int direction = 0; direction < 3; ++direction)
    for (int axis = 0; axis < 3; ++axis)
      for (const int sign : {-1, 1}) {
        const std::vector<Offset> offsets = offsetsAlong(organs, factor, direction, axis, sign);
        costs[direction][axis][sign > 0 ? 1 : 0] = costAt(offsets, bestShift(offsets));
      }
  std::vector<BodyWay> ways;
  std::array<int, 3> axes = {0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      BodyWay way;
      way.axis = axes;
      way.factor = factor;
      for (std::size_t direction = 0; direction < 3; ++direction) {
        const bool against = ((signs >> direction) & 1) != 0;
        way.sign[direction] = against ? -1 : 1;
        way.cost += costs[direction][axes[direction]][against ? 0 : 1];
      }
      way.cost += rarity(way);
      ways.push_back(way);
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return ways;
}

} // namespace

double sizeFactorOf(const std::vector<KnownOrgan>& organs) {
  std::vector<std::pair<double, double>> ratios;
  for (std::size_t a = 0; a < organs.size(); ++a)
    for (std::size_t b = a + 1; b < organs.size(); ++b) {
      const Vec3 usual = organs[b].expected - organs[a].expected;
      const double spread = (organs[a].spread + organs[b].spread).norm();
      if (!std::isfinite(spread) || !(usual.norm() > 0))
        continue;
      const double clear = usual.norm() / spread;
      ratios.emplace_back((organs[b].at - organs[a].at).norm() / usual.norm(),
                          clear * clear * organs[a].weight * organs[b].weight);
    }
  double factor = ratios.empty() ? 1 : weightedMedian(std::move(ratios));
  if (!(factor > 0))
    return 1;
  const bool adult = factor > kSmallestBody && factor < kLargestBody;
  return adult && organs.size() < kEnoughForSize ? 1 : factor;
}

std::vector<BodyWay> bodyWays(const std::vector<KnownOrgan>& organs) {
  const double usual = sizeFactorOf(organs);
  std::vector<BodyWay> ways = waysOfSize(organs, usual);
  for (const double other : kOtherSizes) {
    const std::vector<BodyWay> larger = waysOfSize(organs, other * usual);
    for (std::size_t way = 0; way < ways.size(); ++way)
      if (larger[way].cost < ways[way].cost)
        ways[way] = larger[way];
  }
  std::stable_sort(ways.begin(), ways.end(),
                   [](const BodyWay& a, const BodyWay& b) { return a.cost < b.cost; });
  return ways;
}

double awayFrom(const std::vector<KnownOrgan>& organs, const BodyWay& way, std::size_t organ, int direction) {
  const auto at = static_cast<std::size_t>(direction);
  const double shift = bestShift(offsetsAlong(organs, way.factor, direction, way.axis[at], way.sign[at]));
  const KnownOrgan& one = organs[organ];
  return way.sign[at] * one.at[way.axis[at]] / way.factor - one.expected[direction] - shift;
}

} // namespace viscera::medical_io
