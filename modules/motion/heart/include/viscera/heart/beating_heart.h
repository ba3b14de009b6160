#pragma once

#include <optional>

#include "viscera/heart/cardiac_cycle.h"
#include "viscera/heart/heart_frame.h"
#include "viscera/heart/heart_valves.h"
#include "viscera/sequences/sequence.h"

/// What a beating heart tells beside the poses of its handles.
namespace viscera::heart {

/// The heart of a sequence (`Sequence::heart`): the events of its beat, its valves, the place of its
/// cavities. Immutable; as thread-safe as its sequence, which it is a part of.
class BeatingHeart {
public:
  /// The textbook's beat at that rate; empty for a heart that beats as a circulation says.
  virtual std::optional<CardiacBeat> textbookBeat(double ratePerMinute) const = 0;
  /// The valves `seconds` after the beginning when played at that rate; empty where they are not known. O(1).
  virtual std::optional<ValveInstants> valves(double seconds, double ratePerMinute) const = 0;
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

} // namespace viscera::heart
