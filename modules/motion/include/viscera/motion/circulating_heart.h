#pragma once

#include <string>

#include "viscera/circulation/beat.h"
#include "viscera/circulation/indices.h"
#include "viscera/circulation/parameters.h"
#include "viscera/motion/sequence_setup.h"
#include "viscera/sequences/course_heartbeat.h"

namespace viscera::motion {

/// One beat of a circulation as a course that the sample heart can follow: the ventricles' volumes are the
/// circulation's; the base descends, and the apex turns, as far as the ejection fraction says (15 mm and 10
/// degrees at 0.58); the atria contract with their activation. Time 0 is the beginning of the ventricles'
/// contraction. O(samples).
sequences::HeartCourse heartCourse(const std::string& name, const circulation::Parameters& parameters,
                                   const circulation::Beat& beat, const circulation::Indices& indices);

/// The sample heart with the heartbeat of a circulation: at any time the left ventricle holds the
/// circulation's volume within 0.5 ml, the right one within 1 ml. Calibration takes about a second and is
/// kept in the library's cache. Throws `DataError` when no beat repeats itself, or when the heart cannot take
/// such volumes. As `setUpSequence`.
SequenceSetup circulatingHeart(const sample_organs::SampleLibrary& library, const std::string& name,
                               const circulation::Parameters& parameters,
                               sample_organs::Resolution resolution, Progress& progress,
                               Threads threads = {});

} // namespace viscera::motion
