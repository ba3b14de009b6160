#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/heart/beating_heart.h"
#include "viscera/sequences/sequence.h"

namespace viscera::heart {

/// A sequence that was made for an organ of standard size, played on one that is larger or smaller by a
/// factor: all lengths are multiplied, about the origin. So one set of constants, in millimetres, is used for
/// every size. It has whatever the scaled sequence has. Immutable; as thread-safe as the scaled sequence.
class ScaledSequence final : public sequences::Sequence, private BeatingHeart {
public:
  /// `scale` is the organ's size as a multiple of the standard one's. Throws `DataError` unless it is
  /// positive and finite.
  ScaledSequence(std::shared_ptr<const sequences::Sequence> standard, double scale);

  std::string id() const override { return standard_->id(); }
  Text name() const override { return standard_->name(); }
  const Points& restHandles() const override { return rest_; }
  std::vector<sequences::HandleGroup> groups() const override { return standard_->groups(); }
  double standardRatePerMinute() const override { return standard_->standardRatePerMinute(); }
  double lowestRatePerMinute() const override { return standard_->lowestRatePerMinute(); }
  double highestRatePerMinute() const override { return standard_->highestRatePerMinute(); }
  Text rateRemark(double ratePerMinute) const override { return standard_->rateRemark(ratePerMinute); }
  double finestStepSeconds() const override { return standard_->finestStepSeconds(); }
  void poseAt(double seconds, double ratePerMinute, Points& pose) const override;
  std::vector<sequences::Phase> phases(double ratePerMinute) const override {
    return standard_->phases(ratePerMinute);
  }
  std::vector<sequences::NamedPlace> course() const override { return standard_->course(); }
  std::vector<sequences::TravellingMark> travelling(double seconds, double ratePerMinute) const override {
    return standard_->travelling(seconds, ratePerMinute);
  }
  std::vector<double> keys() const override { return standard_->keys(); }
  const BeatingHeart* heart() const override { return standard_->heart() ? this : nullptr; }

  const sequences::Sequence& standard() const { return *standard_; }
  double scale() const { return scale_; }

private:
  std::optional<CardiacBeat> textbookBeat(double ratePerMinute) const override;
  std::optional<ValveInstants> valves(double seconds, double ratePerMinute) const override;
  std::optional<BeatClock> clock(double seconds, double ratePerMinute) const override;
  std::optional<HeartFrame> frame() const override;

  std::shared_ptr<const sequences::Sequence> standard_;
  double scale_;
  Points rest_;
};

} // namespace viscera::heart
