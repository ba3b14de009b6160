#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "viscera/sequences/sequence.h"

namespace viscera::tests {

/// A handle that goes so far to either side, mm, and when in the cycle.
struct Swing {
  int handle = 0;
  Vec3 way = Vec3::Zero();
  double phase = 0; ///< rad
};

/// The handles' rest places, some of them swaying once a cycle.
class Sway final : public sequences::Sequence {
public:
  Sway(Points rest, std::vector<Swing> swings) : rest_(std::move(rest)), swings_(std::move(swings)) {}

  std::string id() const override { return "sway"; }
  Text name() const override { return "Sway"; }
  const Points& restHandles() const override { return rest_; }
  double standardRatePerMinute() const override { return 60; }
  double lowestRatePerMinute() const override { return 10; }
  double highestRatePerMinute() const override { return 120; }
  void poseAt(double seconds, double rate, Points& pose) const override {
    pose = rest_;
    const double cycles = seconds * rate / 60;
    for (const Swing& swing : swings_)
      pose.row(swing.handle) += std::sin(2 * std::numbers::pi * cycles + swing.phase) * swing.way.transpose();
  }
  std::vector<sequences::Phase> phases(double) const override { return {{"sway", 0, 1}}; }

private:
  Points rest_;
  std::vector<Swing> swings_;
};

} // namespace viscera::tests
