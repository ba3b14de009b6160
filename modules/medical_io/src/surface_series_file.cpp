#include "viscera/medical_io/surface_series_file.h"

#include <array>
#include <cmath>

#include "polygon_triangles.h"
#include "raw_surface.h"
#include "surface_parts.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

Points pointsIn(const RawSurface& raw, const std::filesystem::path& file) {
  const auto count = static_cast<Eigen::Index>(raw.pointCount());
  Points points = Eigen::Map<const Points>(raw.coordinates.data(), count, 3);
  for (Eigen::Index i = 0; i < count; ++i)
    if (!points.row(i).allFinite())
      throw DataError(diagnostic("point %1 has a coordinate that is not a finite number", i), file.string(),
                      "export the surface again");
  if (raw.space == Space::ras)
    points.leftCols<2>() = (0.0 - points.leftCols<2>().array()).matrix();
  return points;
}

/// The polygons of the first file, cut by their shape there.
Triangles trianglesOf(const RawSurface& raw, const Points& points, const std::filesystem::path& file) {
  std::vector<std::array<std::int32_t, 3>> triangles;
  std::vector<std::int32_t> polygon;
  std::size_t at = 0;
  for (std::size_t number = 0; number < raw.polygonCount(); ++number) {
    polygon.clear();
    for (; at < raw.ends[number]; ++at) {
      const std::int64_t corner = raw.corners[at];
      if (corner < 0 || corner >= points.rows())
        throw DataError(diagnostic("a polygon refers to point %1, but there are %2 (counted from 0)", corner,
                                   points.rows()),
                        file.string(), "export the surface again");
      polygon.push_back(static_cast<std::int32_t>(corner));
    }
    if (polygon.size() >= 3 && triangulatePolygon(polygon, points, triangles) == PolygonCut::failed)
      throw DataError(
          diagnostic("polygon %1 (counted from 0) of %2 corners cannot be divided into triangles: "
                     "its edges cross each other",
                     number, polygon.size()),
          file.string(), "export the surface again");
  }
  if (triangles.empty())
    throw DataError("It holds no triangles", file.string(), "export it as STL, OBJ, PLY or GLB");
  Triangles result(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      result(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(k)) = triangles[t][k];
  return result;
}

} // namespace

SurfaceSeriesFile readSurfaceSeries(const std::vector<std::filesystem::path>& files, Progress& progress) {
  SurfaceSeriesFile series;
  RawSurface first;
  for (std::size_t i = 0; i < files.size(); ++i) {
    progress.report(static_cast<double>(i) / static_cast<double>(files.size()), files[i].filename().string());
    progress.throwIfCancelled();
    RawSurface raw = readRawSurface(files[i]);
    series.spaces.push_back(raw.space.value_or(Space::lps));
    series.spaceStated.push_back(raw.space.has_value());
    const bool same = i == 0 || (raw.coordinates.size() == first.coordinates.size() &&
                                 raw.corners == first.corners && raw.ends == first.ends);
    if (!same && series.correspond) {
      series.correspond = false;
      series.differs = i;
    }
    if (i == 0 || series.correspond)
      series.phases.push_back(pointsIn(raw, files[i]));
    if (i == 0) {
      requireOneOrgan(raw, files[i]);
      first = std::move(raw);
      series.triangles = trianglesOf(first, series.phases.front(), files[i]);
    }
  }
  if (!series.correspond)
    series.phases.resize(1);
  progress.report(1);
  return series;
}

} // namespace viscera::medical_io
