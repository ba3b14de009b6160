#pragma once

#include "viscera/sequences/sequence.h"

namespace viscera::examples {

/// An organ that swells and shrinks about its middle, as a worked example of docs/developer_guide.md.
class Pulse final : public sequences::Sequence {
public:
  /// `restHandles` is `n x 3`, mm; `swelling` the part by which lengths grow at most.
  Pulse(Points restHandles, double swelling) : rest_(std::move(restHandles)), swelling_(swelling) {}

  std::string id() const override { return "pulse"; }
  Text name() const override { return "Pulse"; }
  const Points& restHandles() const override { return rest_; }
  double standardRatePerMinute() const override { return 75; }
  double lowestRatePerMinute() const override { return 20; }
  double highestRatePerMinute() const override { return 220; }
  void poseAt(double seconds, double ratePerMinute, Points& pose) const override;
  std::vector<sequences::Phase> phases(double ratePerMinute) const override;

private:
  Points rest_;
  double swelling_;
};

} // namespace viscera::examples
