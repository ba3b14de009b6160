#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::medical_io {

/// A surface as read by a format's reader, before it is converted to a mesh: unchecked, with polygons of any
/// size.
struct RawSurface {
  std::vector<double> coordinates;   ///< `3 n`, in the file's axes.
  std::vector<std::uint8_t> colors;  ///< `3 n`; of any other size: not used.
  std::vector<std::int64_t> corners; ///< Point numbers of all polygons, one after the other.
  std::vector<std::size_t> ends;     ///< For every polygon where its corners end.
  std::string name;                  ///< Empty: the file does not say.
  std::optional<Space> space;        ///< Empty: the file does not say.
  bool pointsAreShared = true;       ///< False for STL, in which every triangle repeats its points.
  std::vector<Text> warnings;
  std::uint64_t ignoredCells = 0; ///< Lines and points among the cells of a VTK file.

  std::size_t pointCount() const { return coordinates.size() / 3; }
  std::size_t polygonCount() const { return ends.size(); }

  void addPoint(double x, double y, double z) { coordinates.insert(coordinates.end(), {x, y, z}); }
  /// Ends the polygon whose corners were appended to `corners`.
  void endPolygon() { ends.push_back(corners.size()); }
  void addTriangle(std::int64_t a, std::int64_t b, std::int64_t c) {
    corners.insert(corners.end(), {a, b, c});
    endPolygon();
  }
  void addPolygon(std::span<const std::int64_t> polygon) {
    corners.insert(corners.end(), polygon.begin(), polygon.end());
    endPolygon();
  }
  /// A channel of a colour, 255 at its brightest, rounded; what is no number or too dark is 0.
  void addChannel(double value) {
    colors.push_back(static_cast<std::uint8_t>(value > 0 ? std::min(value, 255.0) + 0.5 : 0.0));
  }
  /// The axes and the name that a comment of the file states, where no other has before.
  void takeComment(std::string_view comment);
  /// The triangles of a strip, every second one turned around; those with a repeated corner, which only join
  /// pieces of a strip, are left out.
  void addStrip(std::span<const std::int64_t> strip);
};

/// Reads a file by the reader of its format. Throws as `readSurface`, but does not check indices and
/// coordinates.
RawSurface readRawSurface(const std::filesystem::path& file);

/// Makes a valid mesh of it: checks indices and coordinates, merges equal points (the first keeps its place
/// and its colour), cuts polygons into triangles, drops triangles with a repeated corner and points without a
/// triangle, turns RAS into LPS. Triangles without area but with three different corners stay: without them a
/// closed surface would have slits. `file` is named in errors. Throws `DataError`.
SurfaceFile assembleSurface(RawSurface&& raw, const std::filesystem::path& file);

/// Cuts a polygon of three or more different corners (rows of `points`) into triangles of the same
/// orientation and appends them. Quadrilaterals are cut so that no triangle turns over, along the shorter
/// diagonal where both ways do; larger polygons by ears, which is quadratic, so that those above 2000 corners
/// become a fan. False when a polygon that is not a triangle or quadrilateral had to become a fan, which is
/// right only for a convex one.
bool triangulatePolygon(std::span<const std::int32_t> polygon, const Points& points,
                        std::vector<std::array<std::int32_t, 3>>& out);

} // namespace viscera::medical_io
