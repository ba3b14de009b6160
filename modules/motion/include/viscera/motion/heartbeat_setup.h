#pragma once

#include "viscera/motion/sequence_setup.h"
#include "viscera/sequences/course_heartbeat.h"

namespace viscera::motion {

/// The sample heart with its heartbeat (`sequences::CalibratedHeartbeat`), calibrated on the cavities of that
/// resolution: at any time and rate the left ventricle holds what its curve says within 0.5 ml, the right one
/// within 1 ml. The corrections are kept in the library's cache under the hash of all that they depend on;
/// calibrating takes about a second otherwise. As `setUpSequence`.
SequenceSetup heartbeatSetup(const sample_organs::SampleLibrary& library,
                             sample_organs::Resolution resolution, Progress& progress, Threads threads = {});

/// The same heart, following a course (`sequences::CourseHeartbeat`).
SequenceSetup courseSetup(const sample_organs::SampleLibrary& library, const sequences::HeartCourse& course,
                          sample_organs::Resolution resolution, Progress& progress, Threads threads = {});

} // namespace viscera::motion
