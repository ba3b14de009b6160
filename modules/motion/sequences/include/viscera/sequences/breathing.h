#pragma once

#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"
#include "viscera/sequences/sequence.h"

namespace viscera::sequences {

/// Parameters of the liver's motion in a quiet breath.
struct LiverExcursion {
  double downMm = 15;      ///< The middle of the organ towards the feet (10 to 25 mm: doi 10.1118/1.2349696).
  double forwardMm = 4;    ///< Towards the front.
  double domeShare = 0.08; ///< By which part of the height the dome comes closer to the lower edge, 0 to 0.5.
  double rightShare =
      0.03; ///< How much farther down the right side goes than the left, as a part of their distance.
};

/// The motion of the liver in quiet breathing: the diaphragm pushes it down and forward, the dome more than
/// the lower edge and the right lobe more than the left, and it widens so that its volume stays the same.
/// Time course `sin^4` (Lujan and others, doi 10.1118/1.598577, n = 2): rest is the end of expiration, in the
/// middle of the pause, at which a breath begins. Inspiration takes 0.38 of a breath, expiration and pause
/// 0.62 (1 : 1.6; awake adults at rest differ much, but each keeps a pattern of his own: doi
/// 10.1016/S0034-5687(00)00154-7). The motion is affine, so that any coordinates with linear precision follow
/// it exactly, whatever the handles. Thread-safe.
class LiverBreathing final : public Sequence {
public:
  /// `restHandles` is `n x 3`; `organ` the liver's box, about whose middle it moves. Throws `DataError` for
  /// fewer than four handles, for an empty box and for excursions that would turn the organ inside out.
  LiverBreathing(Points restHandles, const Bounds& organ, std::vector<HandleGroup> groups = {},
                 const LiverExcursion& excursion = {});

  std::string id() const override { return "breathing"; }
  Text name() const override { return "Breathing"; }
  const Points& restHandles() const override { return rest_; }
  std::vector<HandleGroup> groups() const override { return groups_; }
  double standardRatePerMinute() const override { return 15; }
  double lowestRatePerMinute() const override { return 4; }
  double highestRatePerMinute() const override { return 40; }

  /// O(n).
  void poseAt(double seconds, double ratePerMinute, Points& pose) const override;
  std::vector<Phase> phases(double ratePerMinute) const override;

  /// The depth of inspiration at an instant, 0 to 1.
  double inspiration(double seconds, double ratePerMinute) const;
  /// The place of a point of the liver at that depth of inspiration.
  Vec3 moved(const Vec3& point, double inspiration) const;

private:
  Points rest_;
  Vec3 middle_;
  std::vector<HandleGroup> groups_;
  LiverExcursion excursion_;
};

} // namespace viscera::sequences
