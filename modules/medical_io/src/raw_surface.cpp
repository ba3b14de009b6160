#include "raw_surface.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <unordered_map>
#include <utility>

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolygon.h>

#include "file_bytes.h"
#include "quiet_vtk.h"
#include "space_tag.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/plausible_size.h"

namespace viscera::medical_io {
namespace {

/// Larger numbers of polygon corners do not come from an organ, but a few kilobytes of glTF can ask for them.
constexpr std::size_t kMostCorners = 600'000'000;

/// 1000 km: a coordinate beyond is a damaged number, and its cube would not be a volume any more.
constexpr double kFarthestCornerMm = 1e9;

constexpr std::int32_t kNone = -1;
constexpr auto kExportAgain = "export the surface again";

constexpr std::size_t kLargestEarCut = 2000;

Vec3 normalOf(const Points& points, std::int32_t a, std::int32_t b, std::int32_t c) {
  const Vec3 pa = points.row(a);
  const Vec3 pb = points.row(b);
  const Vec3 pc = points.row(c);
  return (pb - pa).cross(pc - pa);
}

void cutQuadrilateral(std::span<const std::int32_t> q, const Points& points,
                      std::vector<std::array<std::int32_t, 3>>& out) {
  const bool straight = normalOf(points, q[0], q[1], q[2]).dot(normalOf(points, q[0], q[2], q[3])) > 0;
  const bool crossed = normalOf(points, q[1], q[2], q[3]).dot(normalOf(points, q[1], q[3], q[0])) > 0;
  const double firstDiagonal = (points.row(q[0]) - points.row(q[2])).squaredNorm();
  const double secondDiagonal = (points.row(q[1]) - points.row(q[3])).squaredNorm();
  if (straight != crossed ? straight : firstDiagonal <= secondDiagonal) {
    out.push_back({q[0], q[1], q[2]});
    out.push_back({q[0], q[2], q[3]});
  } else {
    out.push_back({q[1], q[2], q[3]});
    out.push_back({q[1], q[3], q[0]});
  }
}

bool cutEars(std::span<const std::int32_t> polygon, const Points& points,
             std::vector<std::array<std::int32_t, 3>>& out) {
  vtkNew<vtkPolygon> cutter;
  const QuietVtk quiet(cutter);
  cutter->GetPoints()->SetDataTypeToDouble();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    cutter->GetPoints()->InsertNextPoint(points.row(polygon[k]).data());
    cutter->GetPointIds()->InsertNextId(static_cast<vtkIdType>(k));
  }
  vtkNew<vtkIdList> ears;
  const bool cut = cutter->Triangulate(ears) != 0;
  if (!cut || static_cast<std::size_t>(ears->GetNumberOfIds()) != 3 * (polygon.size() - 2))
    return false;
  for (vtkIdType i = 0; i < ears->GetNumberOfIds(); i += 3)
    out.push_back({polygon[static_cast<std::size_t>(ears->GetId(i))],
                   polygon[static_cast<std::size_t>(ears->GetId(i + 1))],
                   polygon[static_cast<std::size_t>(ears->GetId(i + 2))]});
  return true;
}

} // namespace

bool triangulatePolygon(std::span<const std::int32_t> polygon, const Points& points,
                        std::vector<std::array<std::int32_t, 3>>& out) {
  if (polygon.size() == 3) {
    out.push_back({polygon[0], polygon[1], polygon[2]});
    return true;
  }
  if (polygon.size() == 4) {
    cutQuadrilateral(polygon, points, out);
    return true;
  }
  if (polygon.size() <= kLargestEarCut && cutEars(polygon, points, out))
    return true;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    out.push_back({polygon[0], polygon[k], polygon[k + 1]});
  return false;
}

namespace {

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
    checkSizes();
    markUsed();
    checkCoordinates();
    mergePoints();
    cutPolygons();
    compact();
    if (raw_.space == Space::ras)
      turnRasIntoLps();
    return finish();
  }

private:
  [[noreturn]] void fail(const Text& problem, const char* tryThis = kExportAgain) const {
    throw DataError(problem, file_, tryThis);
  }

  void checkSizes() const {
    if (raw_.polygonCount() == 0)
      fail(raw_.pointCount() > 0 ? "It holds no triangles, only points" : "It holds no triangles",
           "export it as a surface of triangles");
    if (raw_.pointCount() > std::numeric_limits<std::int32_t>::max() || raw_.corners.size() > kMostCorners)
      fail(phrase("It is too large: %1 points", raw_.pointCount()), "reduce the surface first");
  }

  void markUsed() {
    const auto count = static_cast<std::int64_t>(raw_.pointCount());
    target_.assign(raw_.pointCount(), kNone);
    std::size_t at = 0;
    for (std::size_t polygon = 0; polygon < raw_.polygonCount(); ++polygon)
      for (; at < raw_.ends[polygon]; ++at) {
        const std::int64_t point = raw_.corners[at];
        if (point < 0 || point >= count)
          fail(diagnostic("polygon %1 refers to point %2, but there are %3 (counted from 0)", polygon, point,
                          count));
        target_[static_cast<std::size_t>(point)] = 0;
      }
  }

  void checkCoordinates() const {
    for (std::size_t point = 0; point < target_.size(); ++point)
      for (std::size_t axis = 0; axis < 3 && target_[point] != kNone; ++axis) {
        const double value = raw_.coordinates[3 * point + axis];
        if (!std::isfinite(value))
          fail(diagnostic("point %1 has a coordinate that is not a finite number", point));
        if (std::abs(value) > kFarthestCornerMm)
          fail(diagnostic("point %1 lies more than 1000 km away: the file is damaged", point));
      }
  }

  void mergePoints() {
    struct Hash {
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
    std::unordered_map<std::array<double, 3>, std::int32_t, Hash> places;
    places.reserve(target_.size());
    std::size_t used = 0;
    for (std::size_t point = 0; point < target_.size(); ++point) {
      if (target_[point] == kNone)
        continue;
      ++used;
      // Adding zero makes -0 and 0, which are equal, the same bits.
      const std::array<double, 3> place = {raw_.coordinates[3 * point] + 0.0,
                                           raw_.coordinates[3 * point + 1] + 0.0,
                                           raw_.coordinates[3 * point + 2] + 0.0};
      const auto [found, isNew] = places.try_emplace(place, static_cast<std::int32_t>(kept_.size()));
      target_[point] = found->second;
      if (isNew)
        kept_.push_back(point);
    }
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
    for (const std::size_t end : raw_.ends) {
      polygon.clear();
      for (; at < end; ++at) {
        const std::int32_t corner = target_[static_cast<std::size_t>(raw_.corners[at])];
        if (polygon.empty() || polygon.back() != corner)
          polygon.push_back(corner);
      }
      while (polygon.size() > 1 && polygon.back() == polygon.front())
        polygon.pop_back();
      if (polygon.size() < 3)
        ++dropped_;
      else if (!triangulatePolygon(polygon, points_, triangles_))
        ++fans_;
    }
    dropped_ +=
        std::erase_if(triangles_, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    if (triangles_.empty())
      fail(diagnostic("It holds no triangle that has three different corners"),
           "check its scale and its number format");
  }

  /// Points may have lost their last triangle.
  void compact() {
    std::vector<std::int32_t> place(kept_.size(), kNone);
    for (const auto& triangle : triangles_)
      for (const std::int32_t corner : triangle)
        place[static_cast<std::size_t>(corner)] = 0;
    std::int32_t next = 0;
    for (std::int32_t& p : place)
      if (p != kNone)
        p = next++;
    unused_ += kept_.size() - static_cast<std::size_t>(next);

    mesh_.points.resize(next, 3);
    if (!raw_.colors.empty())
      mesh_.colors.resize(next, 3);
    for (std::size_t i = 0; i < place.size(); ++i) {
      if (place[i] == kNone)
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
    result.name = raw_.name.empty() ? stemOf(file_) : raw_.name;
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
    if (fans_ > 0)
      warnings.push_back(
          phrase("%n {polygon|polygons} cut into fans, which is wrong where they are not convex", fans_));
    result.mesh = std::move(mesh_);
    appendSurfaceWarnings(result);
    return result;
  }

  RawSurface raw_;
  std::string file_;
  std::vector<std::int32_t> target_; ///< For every point of the file its merged point, or kNone when unused.
  std::vector<std::size_t> kept_;    ///< For every merged point the file's first point at its place.
  Points points_;                    ///< The merged points.
  std::vector<std::array<std::int32_t, 3>> triangles_;
  geometry::TriangleMesh mesh_;
  std::size_t merged_ = 0;
  std::size_t unused_ = 0;
  std::size_t dropped_ = 0;
  std::size_t fans_ = 0;
};

} // namespace

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
