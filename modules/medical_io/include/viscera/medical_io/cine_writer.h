#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "viscera/medical_io/cine_study.h"

/// Writes pictures of a made heart over time as a scanner writes those of a patient.
namespace viscera::medical_io {

/// A series of one plane over the heart's cycle. Names are those of no patient.
struct CineSeries {
  std::string patientName; ///< "Phantom^Moving"
  std::string patientId;
  std::string studyUid; ///< UIDs: digits and dots, 64 at most.
  std::string seriesUid;
  std::string frameOfReferenceUid; ///< The same for all planes of one study.
  int number = 1;                  ///< Of the series.
  std::string description;         ///< "cine_sax 1"
  CineGeometry geometry;
  double intervalMs = 800; ///< Duration of the cycle.
  int phases = 20;         ///< Pictures in it.
};

/// Writes the picture of one phase as an MR image (DICOM, explicit little endian, 16 bits): its trigger time
/// is the phase's share of the interval. `pixels` are rows x columns, row by row. The same arguments give the
/// same bytes; no date, and no name of the machine. Atomic. Throws `DataError` for another number of pixels
/// and a phase that the series does not have, `CannotCreateError`. O(pixels).
void writeCinePicture(const std::filesystem::path& file, const CineSeries& series, int phase,
                      const std::vector<std::uint16_t>& pixels);

} // namespace viscera::medical_io
