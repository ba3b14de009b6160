#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "viscera/medical_io/surface_file.h"

namespace viscera::medical_io {

/// What a format's reader found, before it is made a mesh: nothing checked, polygons of any size.
struct RawSurface {
  std::vector<double> coordinates;   ///< `3 n`, in the file's axes.
  std::vector<std::uint8_t> colors;  ///< `3 n`, or empty.
  std::vector<std::int64_t> corners; ///< Point numbers of all polygons, one after the other.
  std::vector<std::size_t> ends;     ///< For every polygon where its corners end.
  std::string name;                  ///< Empty: the file does not say.
  std::optional<Space> space;        ///< Empty: the file does not say.
  bool pointsAreShared = true;       ///< False for STL, in which every triangle repeats its points.
  std::vector<std::string> warnings;

  std::size_t pointCount() const { return coordinates.size() / 3; }
  std::size_t polygonCount() const { return ends.size(); }

  void addPoint(double x, double y, double z) { coordinates.insert(coordinates.end(), {x, y, z}); }
  /// Ends the polygon whose corners were appended to `corners`.
  void endPolygon() { ends.push_back(corners.size()); }
  void addTriangle(std::int64_t a, std::int64_t b, std::int64_t c) {
    corners.insert(corners.end(), {a, b, c});
    endPolygon();
  }
  /// The triangles of a strip, every second one turned around; those with a repeated corner, which only join
  /// pieces of a strip, are left out.
  void addStrip(std::span<const std::int64_t> strip);
};

/// What the reader of the file's format finds. Throws as `readSurface`, but looks neither at indices nor at
/// coordinates.
RawSurface readRawSurface(const std::filesystem::path& file);

/// Makes a valid mesh of it: checks indices and coordinates, merges equal points (the first keeps its place
/// and its colour), cuts polygons into triangles, drops triangles with a repeated corner and points without a
/// triangle, turns RAS into LPS. Triangles without area but with three different corners stay: without them a
/// closed surface would have slits. `file` is named in errors. Throws `DataError`.
SurfaceFile assembleSurface(RawSurface&& raw, const std::filesystem::path& file);

} // namespace viscera::medical_io
