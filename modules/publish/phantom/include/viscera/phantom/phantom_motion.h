#pragma once

#include <memory>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/phantom/phantom_body.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::phantom {

/// What moves the phantom.
struct MotionOptions {
  bool heartbeat = false;
  bool breathing = false;
  double ejectionFraction = 0.58; ///< Of the left ventricle, 0.2 to 0.7.
  double beatsPerMinute = 75;     ///< 40 to 150.
  double breathsPerMinute = 15;   ///< 4 to 40.
};

/// Points of the moved phantom at rest.
struct PhantomRest {
  Points points;                    ///< `n x 3`, mm.
  std::vector<std::uint8_t> unsure; ///< 1 where the heartbeat folds space, so that the place is a guess.
};

/// The motion of all tissue that is not still, known everywhere: y = B(H(x)), the heartbeat H first, then the
/// breath B. H is trilinear on a grid whose nodes follow the sample heart's handles by its own coordinates
/// (`deformation::InverseMap`); B is in closed form. Rest is the end of expiration, with the heart as the
/// sample heart is at rest: the end of diastole but for the atria's contraction.
/// For one thread at a time; it computes on several, and no result depends on how many.
class PhantomMotion {
public:
  /// Makes the beating heart, some seconds: its left ventricle has the ejection fraction to 0.0001, measured
  /// on the body's surface. Throws `UsageError` for options out of range and when nothing moves, `DataError`
  /// for a beat that the heart cannot follow, what `live::CirculatingHeart` throws, `Cancelled`.
  PhantomMotion(const sample_organs::SampleLibrary& library, const PhantomBody& body,
                const MotionOptions& options, Progress& progress, Threads threads = {});
  ~PhantomMotion();
  PhantomMotion(const PhantomMotion&) = delete;
  PhantomMotion& operator=(const PhantomMotion&) = delete;

  /// Duration of what is repeated, s: one beat, or one breath with the next whole number of beats in it.
  double periodSeconds() const;
  /// Beats a minute, after this rounding.
  double beatsPerMinute() const;

  void setSeconds(double seconds);
  double beatFraction() const; ///< The part of the beat that has gone by; 0 without a heartbeat.
  double inspiration() const;  ///< The depth of the breath, 0 to 1.
  /// When the left ventricle is smallest, s; a beat begins when it is fullest.
  double endSystoleSeconds() const;

  /// Where rest points go, `n x 3` mm. Some 0.1 microseconds a point.
  Points moved(const Points& rest) const;
  /// Where points were at rest: |F(x) - y| is 0.001 mm or less where space is not folded.
  /// About a microsecond a point.
  PhantomRest restOf(const Points& moved) const;
  /// How much space the heartbeat folds in this pose, ml.
  double foldedMl() const;
  /// How far H is from the handles' own coordinates between the nodes of its grid, mm; 99 % of places are
  /// nearer. It is no error of the phantom, whose motion H is.
  double gridErrorMm() const;

private:
  struct Beat;
  std::unique_ptr<Beat> beat_; ///< Null without a heartbeat.
  struct Breath;
  std::unique_ptr<const Breath> breath_; ///< Null without breathing.
  MotionOptions options_;
  Threads threads_;
  double seconds_ = 0;
};

} // namespace viscera::phantom
