#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

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

/// The record as JSON (docs/session_format.md, "measured"). O(phases x surfaces).
nlohmann::ordered_json toJson(const MeasuredRecord& record);

/// Reads what `toJson` made; verdicts, ejection fractions and tissue are computed again. Throws `DataError`
/// for what is no such record.
MeasuredRecord measuredRecordFrom(const nlohmann::ordered_json& item);

} // namespace viscera::live
