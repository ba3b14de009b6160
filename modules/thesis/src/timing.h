#pragma once

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

namespace viscera::thesis {

/// The least time that `work` took, in seconds, of at least one and at most `most` runs within about half a
/// second.
template <class Work>
double leastSeconds(const Work& work, int most = 15) {
  constexpr double kEnough = 0.5;
  double least = std::numeric_limits<double>::infinity(), spent = 0;
  for (int run = 0; run < most && spent < kEnough; ++run) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    least = std::min(least, seconds);
    spent += seconds;
  }
  return least;
}

/// The same for two works that are compared, in turn, so that a busy machine slows down both alike.
template <class First, class Second>
std::pair<double, double> leastSecondsInTurn(const First& first, const Second& second, int most = 15) {
  std::pair<double, double> least(std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::infinity());
  double spent = 0;
  constexpr double kEnough = 1;
  for (int run = 0; run < most && spent < kEnough; ++run) {
    const double one = leastSeconds(first, 1), other = leastSeconds(second, 1);
    least = {std::min(least.first, one), std::min(least.second, other)};
    spent += one + other;
  }
  return least;
}

} // namespace viscera::thesis
