#pragma once

#include <vector>

#include "viscera/document/command.h"

/// Commands that add, join and remove the probes and profiles of stress maps. All throw `UsageError` for
/// marks and organs that are not there.
namespace viscera::document {

/// Pins a probe to the tissue of an organ at a place at rest (mm, LPS). Its number is the first that is free.
Command addStressProbe(OrganId organ, const Vec3& rest);

/// Joins two probes of one organ by a line. Throws `UsageError` also for one probe with itself, for probes of
/// two organs, and for two that are joined already.
Command addStressLine(StressProbeId from, StressProbeId to);

/// Removes probes and the lines that end at them.
Command removeStressProbes(std::vector<StressProbeId> probes);
Command removeStressLines(std::vector<StressLineId> lines);
Command removeAllStressMarks();

} // namespace viscera::document
