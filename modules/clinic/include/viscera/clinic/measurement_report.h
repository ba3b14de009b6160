#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viscera/clinic/dicom_objects.h"

/// Numbers of organs as a DICOM structured report.
namespace viscera::clinic {

/// What is measured, by a code that other programs know.
struct MeasuredQuantity {
  std::string code;    ///< "118565006"
  std::string scheme;  ///< "SCT", "LN", "DCM"; "99VISCERA" for what no scheme has.
  std::string meaning; ///< "Volume"
};

/// The codes of what this program measures.
namespace quantities {
inline const MeasuredQuantity kVolume{"118565006", "SCT", "Volume"};
inline const MeasuredQuantity kEndDiastolicVolume{"250929008", "SCT", "End diastolic volume"};
inline const MeasuredQuantity kEndSystolicVolume{"250930003", "SCT", "End systolic volume"};
inline const MeasuredQuantity kStrokeVolume{"90096001", "SCT", "Stroke volume"};
inline const MeasuredQuantity kEjectionFraction{"70822001", "SCT", "Cardiac ejection fraction"};
inline const MeasuredQuantity kCardiacOutput{"82799009", "SCT", "Cardiac output"};
inline const MeasuredQuantity kLength{"410668003", "SCT", "Length"};
inline const MeasuredQuantity kAngle{"1483009", "SCT", "Angle"};
inline const MeasuredQuantity kLongitudinalStrain{"GLS", "99VISCERA", "Global longitudinal strain"};
inline const MeasuredQuantity kCircumferentialStrain{"GCS", "99VISCERA", "Global circumferential strain"};
inline const MeasuredQuantity kRadialStrain{"GRS", "99VISCERA", "Global radial strain"};
} // namespace quantities

/// One number.
struct WrittenMeasurement {
  MeasuredQuantity quantity;
  double value = 0;
  std::string unit;        ///< UCUM: "ml", "mm", "%", "l/min", "deg".
  std::string unitMeaning; ///< "milliliter"
  std::string method;      ///< How it was measured, in at most 64 letters; may be empty.
};

/// The numbers of an organ, or of nothing that a segmentation has.
struct MeasuredOrgan {
  std::string name;
  std::string trackingUid;    ///< Stays the same for the same organ in other reports.
  std::optional<int> segment; ///< Its number in the segmentation, from 1.
  std::string timePoint;      ///< "phase 3 of 25, 240 ms"; empty for a still organ.
  std::vector<WrittenMeasurement> measurements;
};

/// An Imaging Measurement Report (PS3.16, TID 1500; PS3.3, A.35.13): a group of measurements for each organ,
/// with the segment that it is where there is a segmentation. Values have six digits. Throws `DataError` for
/// an organ without a measurement, and for a segment without a segmentation, `CannotCreateError`.
WrittenObject writeMeasurementReport(const std::filesystem::path& file, const StudyIdentity& identity,
                                     const ObjectSeries& series,
                                     const std::optional<WrittenObject>& segmentation,
                                     const std::vector<MeasuredOrgan>& organs);

} // namespace viscera::clinic
