#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"
#include "viscera/sequences/curve.h"
#include "viscera/sequences/sequence.h"

/// Sequences that interpolate between a few keyframes.
namespace viscera::sequences {

/// The easing of a key: how fast the motion goes to the next one. All are monotone: no pose overshoots its
/// keys.
enum class Easing {
  linear, ///< Evenly.
  smooth, ///< Starts and ends gently (smoothstep); continuously differentiable across keys.
  in,     ///< Starts gently.
  out,    ///< Ends gently.
  hold    ///< Stays, and jumps at the next key.
};

/// "linear", "smooth", "in", "out", "hold".
std::string nameOf(Easing easing);
/// The easing with that name; empty for an unknown one.
std::optional<Easing> easingFromName(const std::string& name);

/// The part of the way at `part` of the time, both 0 to 1; ascending, `eased(e, 0) == 0`.
double eased(Easing easing, double part);

/// The method by which poses between keys are interpolated.
enum class Interpolation {
  eased, ///< On the straight way from key to key, with the easing of each key.
  curve  ///< On one curve through all keys, C1, without overshoot in any coordinate (`Curve`); no easings.
};

/// "eased", "curve".
std::string nameOf(Interpolation interpolation);
std::optional<Interpolation> interpolationFromName(const std::string& name);

/// A keyframe: a pose with its time.
struct Keyframe {
  double seconds = 0;             ///< [0, period).
  Points pose;                    ///< `n x 3` mm.
  Easing easing = Easing::smooth; ///< From here to the next key.
};

/// The shortest time between two keys and the shortest period, s.
inline constexpr double kShortestSpan = 1e-3;

/// A sequence that interpolates between keyframes. Immutable; thread-safe.
class KeyframedSequence final : public Sequence {
public:
  /// The data of a keyframed sequence.
  struct Track {
    std::string name = "Recorded"; ///< Shown to the user.
    Points restHandles;            ///< `n x 3` mm.
    std::vector<HandleGroup> groups;
    double periodSeconds = 1; ///< Of one cycle; beyond the last key.
    /// Whether the last key leads back to the first. Else the first pose lasts until its key, and the last
    /// one to the end of the period.
    bool loop = true;
    Interpolation interpolation = Interpolation::eased;
    std::vector<Keyframe> keys; ///< In order of time.
  };

  /// Throws `DataError` that names the key: no key, a pose of another size or with a number that is not
  /// finite, keys that do not ascend by `kShortestSpan` at least, or that do not fit into the period.
  explicit KeyframedSequence(Track track);

  std::string id() const override { return "keyframes"; }
  Text name() const override { return named(track_.name); }
  const Points& restHandles() const override { return track_.restHandles; }
  std::vector<HandleGroup> groups() const override { return track_.groups; }
  double standardRatePerMinute() const override { return 60 / track_.periodSeconds; }
  double lowestRatePerMinute() const override { return 0.1 * standardRatePerMinute(); }
  double highestRatePerMinute() const override { return 10 * standardRatePerMinute(); }

  /// Gives at a key's time that key's pose exactly, whatever the rate. O(n).
  void poseAt(double seconds, double ratePerMinute, Points& pose) const override;
  /// "key 1", "key 2", ...: from each key to the next; "start" before the first.
  std::vector<Phase> phases(double ratePerMinute) const override;
  std::vector<double> keys() const override;

  const Track& track() const { return track_; }

private:
  /// The keys around an instant, and the part of the way between them.
  struct Place {
    std::size_t from, to;
    double part;
  };
  Place placeAt(double secondsInPeriod) const;
  void makeCurves();

  Track track_;
  std::vector<Curve> curves_; ///< One a coordinate, row by row; empty without `Interpolation::curve`.
};

} // namespace viscera::sequences
