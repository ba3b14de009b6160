#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "file_bytes.h"
#include "viscera/core/arrays.h"

/// Reads DICOM RT Structure Sets (PS3.3, A.19): organs as contours that were drawn for radiotherapy.
namespace viscera::medical_io {

/// A region of interest: an organ, a target or a mark.
struct DrawnRegion {
  int number = 0;
  std::string name;           ///< Empty: the file does not say.
  std::optional<Vec3> color;  ///< 0 to 1.
  std::vector<Points> closed; ///< Corners of its closed planar contours, n x 3, mm LPS, n >= 3.
};

/// What a structure set says.
struct StructureSet {
  std::string frameOfReference;            ///< UID; the first one.
  std::string seriesUid, description;      ///< Its own.
  std::set<std::string> series, instances; ///< UIDs of the images that it was drawn on.
  std::vector<DrawnRegion> regions;        ///< In the order of the file; those without contours too.
  std::size_t notClosed = 0;               ///< Points and open contours, which are left out.
  std::size_t damaged = 0;                 ///< Contours whose numbers cannot be read, which are left out.
  std::size_t elsewhere = 0;               ///< Regions in another frame of reference, which are left out.
};

/// Parses the file with DCMTK. Throws `DataError` for a damaged file and for one without regions.
StructureSet readStructureSet(const FileBytes& file);

} // namespace viscera::medical_io
