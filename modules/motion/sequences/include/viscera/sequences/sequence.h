#pragma once

#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"

namespace viscera::heart {
class BeatingHeart;
} // namespace viscera::heart

namespace viscera::sequences {

/// A named part of a cycle, for the line under the timeline.
struct Phase {
  Text name;        ///< "ejection"
  double begin = 0; ///< Fraction of the cycle, [0, 1).
  double end = 1;
  std::string group = {}; ///< The larger part of the cycle that it belongs to: "systole"; empty for none.
};

/// A mark that travels through the organ during the cycle, such as a peristaltic wave.
struct TravellingMark {
  double place = 0;    ///< On its way through the organ: 0 at the beginning, 1 at the end.
  double strength = 0; ///< Strength of its effect there, 0 to 1.
};

/// A named place on the path of travelling marks.
struct NamedPlace {
  std::string name; ///< "pylorus"
  double place = 0; ///< As in `TravellingMark`.
};

/// A named group of handles that move together.
struct HandleGroup {
  std::string name;             ///< "Epicardium"
  Vec3 color = {1.0, 0.5, 0.2}; ///< Red green blue, 0 to 1.
  std::vector<int> handles;     ///< Rows of the rest handles, ascending.
};

/// The interface of all sequences, which give a pose of the handles at every instant of a cycle. What only
/// some of them have (a course of waves, recorded keys, a beating heart) is empty for the others, so that no
/// caller asks which sequence it has. Immutable; may be called from several threads.
///
///     const double rate = sequence.standardRatePerMinute();
///     Points pose;
///     sequence.poseAt(60 / rate, rate, pose); // As at the beginning.
class Sequence {
public:
  virtual ~Sequence() = default;

  virtual std::string id() const = 0; ///< "heartbeat"
  virtual Text name() const = 0;      ///< "Heartbeat"

  /// The handles at rest, `n x 3` mm, to which organs are bound.
  virtual const Points& restHandles() const = 0;

  /// The handles by group; each handle is in one. Empty: there are no groups.
  virtual std::vector<HandleGroup> groups() const { return {}; }

  /// The rate, in cycles (beats, waves) a minute, for which it was made, and the range in which it may be
  /// played.
  virtual double standardRatePerMinute() const = 0;
  virtual double lowestRatePerMinute() const = 0;
  virtual double highestRatePerMinute() const = 0;
  /// A remark on that rate, as a sentence; empty for most rates.
  virtual Text rateRemark(double /*ratePerMinute*/) const { return {}; }

  /// The smallest useful step through the cycle, s; 0: ordinary frames are fine enough.
  virtual double finestStepSeconds() const { return 0; }

  /// Fills `pose` (resized to `n x 3`) at `seconds` since the start when played at `ratePerMinute`. Periodic
  /// with 60 / rate. O(n).
  virtual void poseAt(double seconds, double ratePerMinute, Points& pose) const = 0;

  /// The parts of one cycle at that rate, in order, covering [0, 1].
  virtual std::vector<Phase> phases(double ratePerMinute) const = 0;

  /// The places along the way of travelling marks, from the beginning to the end; empty when there are none.
  virtual std::vector<NamedPlace> course() const { return {}; }
  /// The travelling marks at that instant, the farthest first.
  virtual std::vector<TravellingMark> travelling(double /*seconds*/, double /*ratePerMinute*/) const {
    return {};
  }

  /// The instants at which its poses were recorded or measured, s at the standard rate, ascending; empty for
  /// a sequence that computes its poses.
  virtual std::vector<double> keys() const { return {}; }
  /// The heart that beats (heart/beating_heart.h), as long as the sequence lives; null for other organs, and
  /// for recorded poses, whatever they show.
  virtual const heart::BeatingHeart* heart() const { return nullptr; }
};

} // namespace viscera::sequences
