#pragma once

#include "viscera/live/stress_frame.h"
#include "viscera/report/report.h"

/// The parts of a report that take some measuring.
namespace viscera::report {

/// What the stress map says, with its picture and histogram.
Section stressSection(const ReportSource& source, const live::StressFrame& frame, Threads threads);

/// The sequence over one cycle: volumes as curves and as a table, and what a clinician reads off a
/// ventricle's. The organs are in their pose again afterwards. Without blocks where the sequence cannot move
/// the handles.
Section motionSection(const ReportSource& source, Threads threads, Progress& progress);

} // namespace viscera::report
