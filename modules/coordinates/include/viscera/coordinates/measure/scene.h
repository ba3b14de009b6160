#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "viscera/coordinates/measure/line_profile.h"

/// Test scenes on which coordinate systems are measured.
namespace viscera::coordinates {

/// A test scene: handles, and points on a line or anywhere that are bound to them.
struct Scene {
  std::string name; ///< "line, 15 handles", "liver"
  HandleSet handles;
  std::optional<Line> line; ///< Along it jumps, kinks and maxima are measured.
  int parts = 400;          ///< Of the line, before looking closer.
  Points points;            ///< `n x 3`, mm; not used with a line.
};

/// The handles of a 3D Slicer fiducial table (`.fcsv`, LPS) as the tables in `resources/lines` are; only the
/// positions. Throws `DataError` for a line that has no three numbers.
HandleSet handlesOfTable(std::istream& table, const std::string& where);

/// Handles on and in a ball, and points among them: seeded, so the same on every machine. 12 handles on a
/// sphere of 50 mm, 8 inside, `points` points within 30 mm of the middle.
Scene cloudScene(int points);

} // namespace viscera::coordinates
