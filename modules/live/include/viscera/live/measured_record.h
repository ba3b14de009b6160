#pragma once

#include <string>
#include <vector>

#include "viscera/document/ids.h"
#include "viscera/live/motion_series.h"
#include "viscera/live/patient_motion.h"

namespace viscera::live {

/// The numbers of a tracked motion that a session keeps: measured volumes and how well every phase fits. It
/// holds neither the measured voxels and surfaces nor the sequence, which the document has.
struct MeasuredRecord {
  std::vector<document::OrganId> organs; ///< The organs that are moved, one for each surface.
  MotionSeries series;                   ///< Names, times and volumes only.
  PatientMotion motion;                  ///< Without its sequence.
};

/// Writes the record as JSON text (docs/session_format.md, "measured"). O(phases x surfaces).
std::string toJson(const MeasuredRecord& record);

/// Reads what `toJson` wrote; verdicts, ejection fractions and tissue are computed again. Throws `DataError`
/// for invalid text.
MeasuredRecord measuredRecordFrom(const std::string& text);

} // namespace viscera::live
