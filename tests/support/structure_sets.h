#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "dicom_slices.h"
#include "viscera/core/arrays.h"

/// Writes DICOM RT Structure Sets byte by byte, independently of the program's reader and writer.
namespace viscera::tests {

/// A contour as it is drawn: corners in mm LPS.
struct DrawnContour {
  Points corners;
  std::string type = "CLOSED_PLANAR";
};

/// A region of interest of a structure set.
struct DrawnStructure {
  int number = 1;
  std::string name;
  std::string color = "220\\20\\60";
  std::vector<DrawnContour> contours;
};

/// Options of a structure set for tests.
struct StructureWriting {
  std::string frameOfReference = "1.2.9";
  std::string referencedSeries = {};   ///< Empty: none.
  std::string referencedInstance = {}; ///< Empty: none.
};

inline std::string contourItem(const DrawnContour& contour) {
  std::string data = "DS";
  for (Eigen::Index i = 0; i < contour.corners.rows(); ++i)
    data += (i > 0 ? "\\" : "") + decimals(contour.corners.row(i).transpose());
  return dicomItem({{0x30060042, "CS" + contour.type},
                    {0x30060046, "IS" + std::to_string(contour.corners.rows())},
                    {0x30060050, data}});
}

inline DicomElements structureElements(const std::vector<DrawnStructure>& structures,
                                       const StructureWriting& writing = {}) {
  DicomElements series = {{0x0020000E, "UI" + writing.referencedSeries}};
  if (!writing.referencedInstance.empty())
    series[0x30060016] = "SQ" + dicomItem({{0x00081155, "UI" + writing.referencedInstance}});
  DicomElements frame = {{0x00200052, "UI" + writing.frameOfReference}};
  frame[0x30060012] = "SQ" + dicomItem({{0x30060014, "SQ" + dicomItem(series)}});
  std::string regions = "SQ", drawn = "SQ";
  for (const DrawnStructure& one : structures) {
    regions += dicomItem({{0x30060022, "IS" + std::to_string(one.number)},
                          {0x30060024, "UI" + writing.frameOfReference},
                          {0x30060026, "LO" + one.name}});
    std::string contours = "SQ";
    for (const DrawnContour& contour : one.contours)
      contours += contourItem(contour);
    DicomElements item = {{0x3006002A, "IS" + one.color}, {0x30060084, "IS" + std::to_string(one.number)}};
    if (!one.contours.empty())
      item[0x30060040] = contours;
    drawn += dicomItem(item);
  }
  return {{0x00080016, "UI1.2.840.10008.5.1.4.1.1.481.3"},
          {0x00080018, "UI1.2.8.1"},
          {0x00080060, "CSRTSTRUCT"},
          {0x0020000D, "UI1.2.3"},
          {0x0020000E, "UI1.2.8"},
          {0x30060002, "SHPlan"},
          {0x30060010, "SQ" + dicomItem(frame)},
          {0x30060020, regions},
          {0x30060039, drawn}};
}

/// A circle across z.
inline Points circleAt(const Vec3& center, double radius, int corners = 120) {
  Points circle(corners, 3);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    circle.row(i) = (center + radius * Vec3(std::cos(angle), std::sin(angle), 0)).transpose();
  }
  return circle;
}

/// mm^2
inline double circleArea(double radius, int corners = 120) {
  return 0.5 * corners * radius * radius * std::sin(2 * std::numbers::pi / corners);
}

} // namespace viscera::tests
