#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/coordinates/registry.h"
#include "viscera/core/progress.h"
#include "viscera/live/motion_runner.h"
#include "viscera/live/patient_motion.h"
#include "viscera/live/sequence_file.h"

/// Organs in motion, whatever moves them.
namespace viscera::live {

/// Surfaces in motion: the poses of their handles at some instants, and how handles move them.
struct MovedOrgans {
  std::vector<SequenceOrgan> organs;                           ///< At rest.
  coordinates::HandleSet handles;                              ///< At rest.
  std::shared_ptr<const coordinates::CoordinateSystem> system; ///< Never null.
  coordinates::ParameterValues parameters;
  std::vector<double> seconds; ///< Ascending.
  std::vector<Points> poses;   ///< One for each instant.
  /// The measured points of each surface in each phase, `[organ][phase]`, where points correspond; else
  /// empty: the surfaces are where the handles move them.
  std::vector<std::vector<Points>> measured;
  /// The row of each point of its file, by surface, as `tracking::SurfaceSeries::rowOfGiven`; may be
  /// empty.
  std::vector<std::vector<std::int32_t>> rowOfGiven;
  /// Whether material points are known; empty where the motion does not say.
  std::optional<bool> corresponding;
  /// The wall of the left ventricle by itself, at rest, of a sample heart; none of other hearts.
  std::optional<SequenceOrgan> wall = std::nullopt;
};

/// The organs of a sequence file at its keys. Throws `UsageError` for a system that does not exist and for a
/// file without organs.
MovedOrgans movedOrgans(const SequenceFile& file, const coordinates::Registry& systems);

/// The organs of a tracked series, with the measured surfaces where points correspond.
MovedOrgans movedOrgans(const MotionSeries& series, const PatientMotion& found,
                        const coordinates::Registry& systems);

/// A motion without keys is read at so many instants of its cycle.
inline constexpr int kStrainInstants = 50;

/// The organs that a runner moves, by the names of the document: at the keys of a motion that is recorded,
/// else at `instants` of its cycle; a computed motion moves material points. Throws `UsageError` when the
/// runner cannot move the handles, `DataError` where a volume cannot be kept, and `Cancelled`.
MovedOrgans movedOrgans(MotionRunner& runner, const coordinates::Registry& systems, int instants,
                        Progress& progress);

/// Adds the wall of the left ventricle where the document has the sample heart, whose outer surface lies on
/// fat and vessels too: strain is that of the muscle. It is taken from the cache of
/// `sample_organs::standardLibrary`, or made (a second). Throws what `sample_organs::sampleSurface` throws.
void addOwnWall(const document::DocumentState& state, Progress& progress, MovedOrgans& moved);

} // namespace viscera::live
