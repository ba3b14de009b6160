#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::sample_organs {

/// Collects points with colours and triangles of one surface from several.
class SheetParts {
public:
  using Index = std::int32_t;

  /// `color` is red, green, blue, 0 to 255.
  Index addPoint(const Vec3& point, const Vec3& color);
  void addTriangle(const std::array<Index, 3>& corners) { triangles_.push_back(corners); }
  const Vec3& point(Index v) const { return points_[static_cast<std::size_t>(v)]; }
  geometry::TriangleMesh mesh() const;

private:
  std::vector<Vec3> points_, colors_;
  std::vector<std::array<Index, 3>> triangles_;
};

/// The points of an edge of a surface, in the direction in which its triangles run along it.
using Rim = std::vector<SheetParts::Index>;

/// The way that the triangles of a part look: as those of the sheet, or the other way.
enum class Facing { outward, inward };

/// Adds what of a closed sheet with colours has positive `values` (one a point), and returns its rims, which
/// lie where the values pass zero: points near there are moved onto it, so that no sliver is left. Throws
/// `DataError` when rims touch each other.
std::vector<Rim> clipSheet(const geometry::TriangleMesh& sheet, std::vector<double> values, Facing facing,
                           SheetParts& parts);

} // namespace viscera::sample_organs
