#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "dicom_slices.h"

/// Writes small cine MR pictures as DICOM files.
namespace viscera::tests {

/// One picture of one phase of a plane.
struct CinePicture {
  std::string patient = "P1", study = "1.2.3", frame = "1.2.3.77";
  int series = 1;
  std::string description = "cine";
  Vec3 corner = Vec3::Zero(), row = Vec3::UnitX(), column = Vec3::UnitY();
  double spacing = 2, thickness = 6;
  int columns = 8, rows = 6;
  int phase = 0, phases = 12;
  double intervalMs = 900;
  int slice = 0; ///< Of the series.

  /// The stored value of a pixel.
  int value(int i, int j) const { return 1000 * phase + 100 * series + 10 * j + i; }
  double triggerMs() const { return intervalMs * phase / phases; }
};

/// The plane of a short axis as a scanner has it: its normal goes from the apex to the base.
inline CinePicture shortAxisPicture(int series, double heightMm, double intervalMs) {
  CinePicture picture;
  picture.series = series;
  picture.row = Vec3(0.792067, 0, 0.610434).normalized();
  picture.column = Vec3(0.377686, 0.785613, -0.490067);
  picture.column = (picture.column - picture.column.dot(picture.row) * picture.row).normalized();
  picture.corner = Vec3(-20, 10, 30) + heightMm * picture.row.cross(picture.column);
  picture.intervalMs = intervalMs;
  return picture;
}

/// A plane along that axis, turned around it by an angle from the front wall to the septum: 0 shows two
/// chambers, 60 three and 120 four.
inline CinePicture longAxisPicture(int series, double degrees, double intervalMs) {
  CinePicture picture = shortAxisPicture(series, 0, intervalMs);
  const Vec3 apex = -picture.row.cross(picture.column);
  const Vec3 front = (Vec3::UnitZ() - apex.z() * apex).normalized(), septum = apex.cross(front);
  const double angle = degrees * std::numbers::pi / 180;
  picture.row = std::cos(angle) * front + std::sin(angle) * septum;
  picture.column = apex;
  picture.description = "long";
  return picture;
}

inline DicomElements cineElements(const CinePicture& picture) {
  std::string pixels;
  for (int j = 0; j < picture.rows; ++j)
    for (int i = 0; i < picture.columns; ++i)
      pixels += littleEndian(std::uint64_t(picture.value(i, j)), 2);
  const std::string series = picture.study + "." + std::to_string(picture.series);
  const int number = picture.slice * picture.phases + picture.phase + 1;
  return {{0x00080016, "UI1.2.840.10008.5.1.4.1.1.4"},
          {0x00080018, "UI" + series + "." + std::to_string(number)},
          {0x00080020, "DA20240301"},
          {0x00080060, "CSMR"},
          {0x0008103E, "LO" + picture.description},
          {0x00100010, "PNDoe^Jane"},
          {0x00100020, "LO" + picture.patient},
          {0x00180050, "DS" + decimal(picture.thickness)},
          {0x00181060, "DS" + decimal(picture.triggerMs())},
          {0x00181062, "IS" + std::to_string(int(picture.intervalMs))},
          {0x00181090, "IS" + std::to_string(picture.phases)},
          {0x0020000D, "UI" + picture.study},
          {0x0020000E, "UI" + series},
          {0x00200011, "IS" + std::to_string(picture.series)},
          {0x00200013, "IS" + std::to_string(number)},
          {0x00200032, "DS" + decimals(picture.corner)},
          {0x00200037, "DS" + decimals(picture.row) + '\\' + decimals(picture.column)},
          {0x00200052, "UI" + picture.frame},
          {0x00280002, us(1)},
          {0x00280004, "CSMONOCHROME2"},
          {0x00280010, us(picture.rows)},
          {0x00280011, us(picture.columns)},
          {0x00280030, "DS" + decimal(picture.spacing) + '\\' + decimal(picture.spacing)},
          {0x00280100, us(16)},
          {0x00280101, us(16)},
          {0x00280102, us(15)},
          {0x00280103, us(0)},
          {0x7FE00010, "OW" + pixels}};
}

/// A name that says nothing of the phase's place.
inline std::string cineFileName(const CinePicture& picture) {
  return std::to_string(picture.phase * 7 % 12) + "_" + std::to_string(picture.series) + "_" +
         std::to_string(picture.slice) + "_" + std::to_string(picture.phase) + ".dcm";
}

} // namespace viscera::tests
