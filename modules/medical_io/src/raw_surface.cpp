#include "raw_surface.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <unordered_map>
#include <utility>

#include "file_bytes.h"
#include "polygon_triangles.h"
#include "space_tag.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/organ_names.h"
#include "viscera/medical_io/plausible_size.h"

namespace viscera::medical_io {
namespace {

/// Larger numbers of polygon corners do not come from an organ, but a few kilobytes of glTF can ask for them.
constexpr std::size_t kMostCorners = 600'000'000;

/// 1000 km: a coordinate beyond is a damaged number, and its cube would not be a volume any more.
constexpr double kFarthestCornerMm = 1e9;

constexpr auto kExportAgain = "export the surface again";

/// Checks the surface, and appends what a user should know before working with it: it is open, inside out, in
/// pieces; its size is none that an organ has in mm, with the units that would explain it; its volume is far
/// from the normal one of the organ that its name says. O(m log m).
void appendSurfaceWarnings(SurfaceFile& surface) {
  const auto append = [&](std::optional<Text> doubt) {
    if (doubt)
      surface.warnings.push_back(std::move(*doubt));
  };
  append(doubtAboutSize(surface.name, boundsOf(surface.mesh.points).diagonal()));
  surface.report = geometry::checkSurface(surface.mesh);
  for (Text& fault : geometry::faults(surface.report))
    surface.warnings.push_back(std::move(fault));
  if (surface.report.closed())
    append(doubtAboutVolume(surface.name, std::abs(surface.report.volumeMm3) / kMm3PerMl));
}

class Assembly {
public:
  Assembly(RawSurface&& raw, const std::filesystem::path& file)
      : raw_(std::move(raw)), file_(file.string()) {}

  SurfaceFile run() {
    if (raw_.colors.size() != raw_.coordinates.size())
      raw_.colors.clear();
    target_ = usedPoints(raw_, file_);
    mergePoints();
    cutPolygons();
    compact();
    if (raw_.space == Space::ras)
      turnRasIntoLps();
    return finish();
  }

private:
  [[noreturn]] void fail(const Text& problem, const Text& tryThis) const {
    throw DataError(problem, file_, tryThis);
  }

  void mergePoints() {
    const auto used =
        target_.size() - static_cast<std::size_t>(std::count(target_.begin(), target_.end(), kUnusedPoint));
    numberPlaces(raw_, target_, kept_);
    merged_ = used - kept_.size();
    unused_ = target_.size() - used;
    points_.resize(static_cast<Eigen::Index>(kept_.size()), 3);
    for (std::size_t i = 0; i < kept_.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        points_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(axis)) =
            raw_.coordinates[3 * kept_[i] + axis];
  }

  void cutPolygons() {
    triangles_.reserve(raw_.polygonCount());
    std::vector<std::int32_t> polygon;
    std::size_t at = 0;
    for (std::size_t number = 0; number < raw_.polygonCount(); ++number) {
      polygon.clear();
      for (; at < raw_.ends[number]; ++at) {
        const std::int32_t corner = target_[static_cast<std::size_t>(raw_.corners[at])];
        if (polygon.empty() || polygon.back() != corner)
          polygon.push_back(corner);
      }
      while (polygon.size() > 1 && polygon.back() == polygon.front())
        polygon.pop_back();
      if (polygon.size() < 3)
        ++dropped_;
      else
        cut(polygon, number);
    }
    dropped_ +=
        std::erase_if(triangles_, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    if (triangles_.empty())
      fail(diagnostic("It holds no triangle that has three different corners"),
           "check its scale and its number format");
  }

  void cut(const std::vector<std::int32_t>& polygon, std::size_t number) {
    const PolygonCut result = triangulatePolygon(polygon, points_, triangles_);
    if (result == PolygonCut::failed)
      fail(diagnostic("polygon %1 (counted from 0) of %2 corners cannot be divided into triangles: its edges "
                      "cross each other",
                      raw_.polygonsInFile.empty() ? number : raw_.polygonsInFile[number], polygon.size()),
           "divide its polygons into triangles in the program that made it, and export it again");
    if (result == PolygonCut::uneven)
      ++uneven_;
  }

  /// Points may have lost their last triangle.
  void compact() {
    std::vector<std::int32_t> place(kept_.size(), kUnusedPoint);
    for (const auto& triangle : triangles_)
      for (const std::int32_t corner : triangle)
        place[static_cast<std::size_t>(corner)] = 0;
    std::int32_t next = 0;
    for (std::int32_t& p : place)
      if (p != kUnusedPoint)
        p = next++;
    unused_ += kept_.size() - static_cast<std::size_t>(next);

    mesh_.points.resize(next, 3);
    if (!raw_.colors.empty())
      mesh_.colors.resize(next, 3);
    for (std::size_t i = 0; i < place.size(); ++i) {
      if (place[i] == kUnusedPoint)
        continue;
      mesh_.points.row(place[i]) = points_.row(static_cast<Eigen::Index>(i));
      for (std::size_t k = 0; k < 3 && !raw_.colors.empty(); ++k)
        mesh_.colors(place[i], static_cast<Eigen::Index>(k)) = raw_.colors[3 * kept_[i] + k];
    }
    mesh_.triangles.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        mesh_.triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(k)) =
            place[static_cast<std::size_t>(triangles_[t][k])];
  }

  /// Half a turn around the axis from foot to head: nothing is mirrored, triangles keep their orientation.
  void turnRasIntoLps() {
    // Subtracted from zero, so that 0 does not become -0.
    mesh_.points.leftCols<2>() = (0.0 - mesh_.points.leftCols<2>().array()).matrix();
  }

  SurfaceFile finish() {
    SurfaceFile result;
    result.name = printableName(raw_.name);
    if (result.name.empty())
      result.name = stemOf(file_);
    result.space = raw_.space.value_or(Space::lps);
    result.spaceStated = raw_.space.has_value();
    result.warnings = std::move(raw_.warnings);
    auto& warnings = result.warnings;
    if (raw_.ignoredCells > 0)
      warnings.push_back(phrase("%n {line or point cell|line or point cells} ignored", raw_.ignoredCells));
    if (merged_ > 0 && raw_.pointsAreShared)
      warnings.push_back(phrase("%n {point that repeats|points that repeat} another merged", merged_));
    if (dropped_ > 0)
      warnings.push_back(phrase("%n {triangle|triangles} with a repeated corner dropped", dropped_));
    if (unused_ > 0)
      warnings.push_back(phrase("%n {point|points} without a triangle dropped", unused_));
    if (uneven_ > 0)
      warnings.push_back(phrase(
          "%n {polygon that is not flat was|polygons that are not flat were} cut into triangles that overlap",
          uneven_));
    result.mesh = std::move(mesh_);
    appendSurfaceWarnings(result);
    return result;
  }

  RawSurface raw_;
  std::string file_;
  std::vector<std::int32_t>
      target_; ///< For every point of the file its merged point, or kUnusedPoint when unused.
  std::vector<std::size_t> kept_; ///< For every merged point the file's first point at its place.
  Points points_;                 ///< The merged points.
  std::vector<std::array<std::int32_t, 3>> triangles_;
  geometry::TriangleMesh mesh_;
  std::size_t merged_ = 0;
  std::size_t unused_ = 0;
  std::size_t dropped_ = 0;
  std::size_t uneven_ = 0;
};

/// Throws when the sizes are those of no organ.
void requireSizes(const RawSurface& raw, const std::string& file) {
  if (raw.polygonCount() == 0)
    throw DataError(raw.pointCount() > 0 ? "It holds no triangles, only points" : "It holds no triangles",
                    file, "export it as a surface of triangles");
  if (raw.pointCount() > std::numeric_limits<std::int32_t>::max() || raw.corners.size() > kMostCorners)
    throw DataError(phrase("It is too large: %1 points", raw.pointCount()), file, "reduce the surface first");
}

void requireCoordinates(const RawSurface& raw, std::size_t point, const std::string& file) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double value = raw.coordinates[3 * point + axis];
    if (!std::isfinite(value))
      throw DataError(diagnostic("point %1 has a coordinate that is not a finite number", point), file,
                      kExportAgain);
    if (std::abs(value) > kFarthestCornerMm)
      throw DataError(diagnostic("point %1 lies more than 1000 km away: the file is damaged", point), file,
                      kExportAgain);
  }
}

struct PlaceHash {
  std::size_t operator()(const std::array<double, 3>& p) const {
    std::uint64_t hash = 0;
    for (const double value : p) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 29U;
    }
    return static_cast<std::size_t>(hash);
  }
};

} // namespace

std::vector<std::int32_t> usedPoints(const RawSurface& raw, const std::string& file) {
  requireSizes(raw, file);
  const auto count = static_cast<std::int64_t>(raw.pointCount());
  std::vector<std::int32_t> used(raw.pointCount(), kUnusedPoint);
  std::size_t at = 0;
  for (std::size_t polygon = 0; polygon < raw.polygonCount(); ++polygon)
    for (; at < raw.ends[polygon]; ++at) {
      const std::int64_t point = raw.corners[at];
      if (point < 0 || point >= count)
        throw DataError(diagnostic("polygon %1 refers to point %2, but there are %3 (counted from 0)",
                                   polygon, point, count),
                        file, kExportAgain);
      used[static_cast<std::size_t>(point)] = 0;
    }
  for (std::size_t point = 0; point < used.size(); ++point)
    if (used[point] != kUnusedPoint)
      requireCoordinates(raw, point, file);
  return used;
}

void numberPlaces(const RawSurface& raw, std::vector<std::int32_t>& places,
                  std::vector<std::size_t>& firstAt) {
  std::unordered_map<std::array<double, 3>, std::int32_t, PlaceHash> known;
  known.reserve(places.size());
  for (std::size_t point = 0; point < places.size(); ++point) {
    if (places[point] == kUnusedPoint)
      continue;
    // Adding zero makes -0 and 0, which are equal, the same bits.
    const std::array<double, 3> place = {raw.coordinates[3 * point] + 0.0,
                                         raw.coordinates[3 * point + 1] + 0.0,
                                         raw.coordinates[3 * point + 2] + 0.0};
    const auto [found, isNew] = known.try_emplace(place, static_cast<std::int32_t>(firstAt.size()));
    places[point] = found->second;
    if (isNew)
      firstAt.push_back(point);
  }
}

void RawSurface::takeComment(std::string_view comment) {
  if (!space)
    space = findSpace(comment, warnings);
  if (name.empty())
    name = nameInComment(comment);
}

void RawSurface::addStrip(std::span<const std::int64_t> strip) {
  for (std::size_t k = 0; k + 2 < strip.size(); ++k) {
    const std::int64_t a = strip[k];
    const std::int64_t b = strip[k + 1];
    const std::int64_t c = strip[k + 2];
    if (a == b || b == c || c == a)
      continue;
    if (k % 2 == 0)
      addTriangle(a, b, c);
    else
      addTriangle(b, a, c);
  }
}

SurfaceFile assembleSurface(RawSurface&& raw, const std::filesystem::path& file) {
  return Assembly(std::move(raw), file).run();
}

} // namespace viscera::medical_io
