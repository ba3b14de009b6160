#pragma once

#include "viscera/live/stress_frame.h"
#include "viscera/report/report.h"

/// Makes the sections of a report that need computations.
namespace viscera::report {

/// The section on the stress map, with its picture and histogram.
Section stressSection(const ReportSource& source, const live::StressFrame& frame, Threads threads);

/// The sequence over one cycle: volumes as curves and as a table, and the clinical numbers of a ventricle.
/// The organs are in their pose again afterwards. Without blocks where the sequence cannot move the handles.
Section motionSection(const ReportSource& source, Threads threads, Progress& progress);

/// The strain of a left ventricle over the cycle: bull's eyes, curves, and the peaks beside those of healthy
/// adults. Without blocks where there is none. Seconds.
Section strainSection(const ReportSource& source, Threads threads, Progress& progress);

} // namespace viscera::report
