#pragma once

#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "viscera/document/ids.h"
#include "viscera/live/cine_motion.h"
#include "viscera/live/motion_series.h"
#include "viscera/live/patient_motion.h"

namespace viscera::live {

/// How a motion was found from images, and what these said: what is needed to show it and to find it again.
struct CineRecord {
  CineRequest request;
  std::string study;       ///< `document::studyHash` of the images; empty: not known.
  int handles = 0;         ///< As the options have them; 0: chosen by the program.
  bool keepVolumes = true; ///< The same.
  /// Read from a session, it lacks its `motion`, which the record has.
  CineMotion found;
};

/// The numbers of a tracked motion that a session keeps: measured volumes and how well every phase fits. It
/// holds neither the measured voxels and surfaces nor the sequence, which the document has.
struct MeasuredRecord {
  std::vector<document::OrganId> organs; ///< The organs that are moved, one for each surface.
  MotionSeries series;                   ///< Names, times and volumes only.
  PatientMotion motion;                  ///< Without its sequence.
  /// Null where every phase was labelled.
  std::shared_ptr<const CineRecord> images = nullptr;
};

/// The record as JSON (docs/session_format.md, "measured"). O(phases x surfaces).
nlohmann::ordered_json toJson(const MeasuredRecord& record);

/// Reads what `toJson` made; ejection fractions, tissue and (where every phase was labelled) verdicts are
/// computed again. Throws `DataError` for what is no such record.
MeasuredRecord measuredRecordFrom(const nlohmann::ordered_json& item);

} // namespace viscera::live
