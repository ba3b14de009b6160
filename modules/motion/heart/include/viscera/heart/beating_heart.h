#pragma once

#include <optional>

#include "viscera/heart/cardiac_cycle.h"
#include "viscera/heart/heart_frame.h"
#include "viscera/heart/heart_valves.h"
#include "viscera/sequences/sequence.h"

/// What a beating heart tells beside the poses of its handles.
namespace viscera::heart {

/// An instant of a beat, as its electricity counts: from the contraction of the ventricles.
struct BeatClock {
  double seconds = 0;       ///< After the beginning of the ventricles' contraction; periodic.
  double conduction = 0;    ///< The time between the contractions of atria and ventricles, s.
  double ratePerMinute = 0; ///< Of the beats.

  friend bool operator==(const BeatClock&, const BeatClock&) = default;
};

/// The clock of the textbook's beat `seconds` after its beginning. O(1).
BeatClock clockOf(const CardiacBeat& beat, double seconds);

/// The heart of a sequence (`Sequence::heart`): the events of its beat, its valves, the place of its
/// cavities. Immutable; as thread-safe as its sequence, which it is a part of.
class BeatingHeart {
public:
  /// The textbook's beat at that rate; empty for a heart that beats as a circulation says.
  virtual std::optional<CardiacBeat> textbookBeat(double ratePerMinute) const = 0;
  /// The valves `seconds` after the beginning when played at that rate; empty where they are not known. O(1).
  virtual std::optional<ValveInstants> valves(double seconds, double ratePerMinute) const = 0;
  /// The instant `seconds` after the beginning when played at that rate; empty where it is not known. O(1).
  virtual std::optional<BeatClock> clock(double seconds, double ratePerMinute) const = 0;
  /// The frame by which the walls between cavities and outer surface are measured (`WallGauge`); empty for a
  /// heart of which only the outer surface is known.
  virtual std::optional<HeartFrame> frame() const = 0;

protected:
  ~BeatingHeart() = default;
};

/// The valves of a sequence's heart, as `BeatingHeart::valves`; empty for a sequence without one.
inline std::optional<ValveInstants> valvesAt(const sequences::Sequence& sequence, double seconds,
                                             double ratePerMinute) {
  const BeatingHeart* heart = sequence.heart();
  return heart ? heart->valves(seconds, ratePerMinute) : std::nullopt;
}

/// The instant of a sequence's beat, as `BeatingHeart::clock`; empty for a sequence without one.
inline std::optional<BeatClock> clockAt(const sequences::Sequence& sequence, double seconds,
                                        double ratePerMinute) {
  const BeatingHeart* heart = sequence.heart();
  return heart ? heart->clock(seconds, ratePerMinute) : std::nullopt;
}

} // namespace viscera::heart
