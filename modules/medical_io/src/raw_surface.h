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

/// A part of a file that has a name of its own: a group of an OBJ file, a node of a scene, a solid, a block.
struct RawPart {
  std::string name;          ///< Empty: it has none.
  std::string material;      ///< Of its only one; empty: it has none, or several.
  std::optional<Vec3> color; ///< Red green blue, 0 to 1; of that material.
  double opacity = 1;        ///< 0 to 1.
  int cavityOf = -1;         ///< The part whose cavity this is; -1: of none.
  bool plain = false;        ///< Its points have no colours, whatever stands in the place of them.
};

/// A surface as read by a format's reader, before it is converted to a mesh: unchecked, with polygons of any
/// size. All parts of a file together, which `organsOf` takes apart.
struct RawSurface {
  std::vector<double> coordinates;   ///< `3 n`, in the file's axes.
  std::vector<std::uint8_t> colors;  ///< `3 n`; of any other size: not used.
  std::vector<std::int64_t> corners; ///< Point numbers of all polygons, one after the other.
  std::vector<std::size_t> ends;     ///< For every polygon where its corners end.
  std::string name;                  ///< Empty: the file does not say.
  std::optional<Space> space;        ///< Empty: the file does not say.
  bool pointsAreShared = true;       ///< False for STL, in which every triangle repeats its points.
  std::vector<Text> warnings;
  std::uint64_t ignoredCells = 0;    ///< Lines and points among the cells of a VTK file.
  std::vector<RawPart> parts;        ///< Empty: the file has none.
  std::vector<std::uint32_t> partOf; ///< For every polygon its part; of any other size: there are no parts.
  bool partsAreOrgans = false;       ///< The file says itself that each part is an organ.
  std::vector<std::uint64_t> polygonsInFile; ///< For every polygon its number in the file; empty: as here.

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

/// Tells for every point whether a polygon uses it: 0, or `kUnusedPoint`. Throws `DataError`, which names
/// `file`, for a surface without polygons or of a size that is no organ's, a corner that is no point, and a
/// used point that is not finite or more than 1000 km away.
std::vector<std::int32_t> usedPoints(const RawSurface& raw, const std::string& file);
inline constexpr std::int32_t kUnusedPoint = -1;

/// Numbers the places of used points, the same for points with equal coordinates; others keep
/// `kUnusedPoint`. `firstAt` gets for every place its first point. O(n).
void numberPlaces(const RawSurface& raw, std::vector<std::int32_t>& places,
                  std::vector<std::size_t>& firstAt);

/// Makes a valid mesh of it: checks indices and coordinates, merges equal points (the first keeps its place
/// and its colour), cuts polygons into triangles, drops triangles with a repeated corner and points without a
/// triangle, turns RAS into LPS. Triangles without area but with three different corners stay: without them a
/// closed surface would have slits. A flat polygon that crosses itself is an error with its number. `file` is
/// named in errors. Throws `DataError`.
SurfaceFile assembleSurface(RawSurface&& raw, const std::filesystem::path& file);

} // namespace viscera::medical_io
