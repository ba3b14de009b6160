#pragma once

#include <memory>
#include <optional>
#include <string>

#include "viscera/circulation/beat.h"
#include "viscera/circulation/indices.h"
#include "viscera/circulation/parameters.h"
#include "viscera/core/phrase.h"
#include "viscera/document/circulation_choice.h"
#include "viscera/heart/course_heartbeat.h"
#include "viscera/live/motion_recipe.h"
#include "viscera/live/sequence_setup.h"

namespace viscera::live {

/// One beat of a circulation as a course that the sample heart can follow: the ventricles' volumes are the
/// circulation's, and so are the atria's between 24 and 140 ml, outside of which they cannot be drawn and are
/// clamped. The descent of the base and the twist of the apex follow from the ejection fraction (15 mm and 10
/// degrees at 0.58). Time 0 is the beginning of the ventricles' contraction. The left ventricle has
/// `leftMuscle` times the muscle of the sample heart. O(samples).
heart::HeartCourse heartCourse(Text name, const circulation::Parameters& parameters,
                               const circulation::Beat& beat, const circulation::Indices& indices,
                               double leftMuscle = 1);

/// The sample heart, ready to follow one circulation after the other, as while a control moves. Immutable;
/// thread-safe.
class CirculatingHeart {
public:
  /// Binds its cavities: some 0.5 s, and what `sample_organs::sampleOrgan` takes. Throws what that throws.
  CirculatingHeart(const sample_organs::SampleLibrary& library, sample_organs::Resolution resolution,
                   Progress& progress, Threads threads = {});
  ~CirculatingHeart();

  const sample_organs::SampleOrgan& organ() const;

  /// The heartbeat of a course: at any time the left ventricle holds the course's volume within 0.5 ml, the
  /// right one and the atria within 1 ml. Some 100 ms. Throws `DataError` when the heart cannot take such
  /// volumes, `Cancelled`.
  std::shared_ptr<const heart::CourseHeartbeat> follow(heart::HeartCourse course, Progress& progress) const;
  /// The same with organ, handles and coordinates.
  SequenceSetup setup(heart::HeartCourse course, Progress& progress) const;

private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

/// The sample heart with the heartbeat of a circulation, and the muscle of the scenario of that name
/// (`circulation::leftMuscleOf`). Throws `DataError` when there is no periodic beat, or when the heart cannot
/// take such volumes. As `CirculatingHeart`.
SequenceSetup circulatingHeart(const sample_organs::SampleLibrary& library, const Text& name,
                               const circulation::Parameters& parameters,
                               sample_organs::Resolution resolution, Progress& progress,
                               Threads threads = {});

/// The valves at a place of the cycle, [0, 1], of the motion that a recipe makes and a circulation may drive,
/// without making the motion; empty unless it is the sample heart's, and for a circulation without a periodic
/// beat. Some 20 ms if a circulation drives. Throws `Cancelled`.
std::optional<heart::ValveInstants> heartValves(const MotionRecipe& recipe,
                                                const document::CirculationChoice& choice, double fraction,
                                                double ratePerMinute, Progress& progress);

/// The clock at that place of the cycle, as `heartValves`.
std::optional<heart::BeatClock> heartClock(const MotionRecipe& recipe,
                                           const document::CirculationChoice& choice, double fraction,
                                           double ratePerMinute, Progress& progress);

} // namespace viscera::live
