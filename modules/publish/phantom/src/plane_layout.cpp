#include "viscera/phantom/plane_layout.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include <Eigen/Geometry>

#include "noise.h"

namespace viscera::phantom {
namespace {

constexpr double kFieldOfViewMm = 220;
constexpr double kMiddleMm = 40; ///< Of the left ventricle, below the mitral valve.
constexpr std::uint64_t kShifts = 0x5348;

/// A square around a point, in the plane of two unit vectors.
ImageGrid squareAt(const Vec3& center, const Vec3& row, const Vec3& column, const Vec3& spacing) {
  ImageGrid grid;
  grid.size = {static_cast<int>(std::lround(kFieldOfViewMm / spacing.x())),
               static_cast<int>(std::lround(kFieldOfViewMm / spacing.y())), 1};
  grid.indexToLps.linear() << spacing.x() * row, spacing.y() * column, spacing.z() * row.cross(column);
  grid.indexToLps.translation() =
      center - 0.5 * (grid.size[0] - 1) * spacing.x() * row - 0.5 * (grid.size[1] - 1) * spacing.y() * column;
  return grid;
}

void addShortAxis(const heart::HeartFrame& heart, const PhantomOptions& options,
                  std::vector<StudyPlane>& planes) {
  const Vec3 apex = heart.towardsApex();
  const Vec3 row = (Vec3::UnitX() - apex.x() * apex).normalized();
  const Vec3 column = row.cross(apex); // The normal, row x column, leads to the base.
  const double step = options.spacing.z() + options.slices.gapMm;
  for (int slice = 0; slice < options.slices.shortAxis; ++slice) {
    const double along = kMiddleMm + (slice - 0.5 * (options.slices.shortAxis - 1)) * step;
    char name[16];
    std::snprintf(name, sizeof name, "sax_%02d", slice + 1);
    planes.push_back({name, "cine_sax " + std::to_string(slice + 1),
                      squareAt(heart.toWorld(Vec3(0, 0, along)), row, column, options.spacing)});
  }
}

void addLongAxis(const heart::HeartFrame& heart, const PhantomOptions& options,
                 std::vector<StudyPlane>& planes) {
  struct View {
    const char* name;
    double degrees; ///< From the front wall to the septum.
  };
  const Vec3 apex = heart.towardsApex();
  const Vec3 front = (Vec3::UnitZ() - apex.z() * apex).normalized(), septum = apex.cross(front);
  for (const View view : {View{"2ch", 0}, View{"3ch", 60}, View{"4ch", 120}}) {
    const double angle = view.degrees * std::numbers::pi / 180;
    const Vec3 row = std::cos(angle) * front + std::sin(angle) * septum;
    planes.push_back({std::string("lax_") + view.name, std::string("cine_lax ") + view.name,
                      squareAt(heart.toWorld(Vec3(0, 0, kMiddleMm)), row, apex, options.spacing)});
  }
}

} // namespace

ImageGrid StudyPlane::imaged() const {
  ImageGrid moved = grid;
  moved.indexToLps.translation() -= shift;
  return moved;
}

std::vector<StudyPlane> studyPlanes(const heart::HeartFrame& heart, const PhantomOptions& options) {
  std::vector<StudyPlane> planes;
  addShortAxis(heart, options, planes);
  if (options.slices.longAxis)
    addLongAxis(heart, options, planes);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const Eigen::Vector2d way = normalPair(mixed(options.seed, kShifts, p)).normalized();
    const Eigen::Matrix3d axes = planes[p].grid.indexToLps.linear().colwise().normalized();
    planes[p].shift = options.shiftSlicesMm * (axes.leftCols<2>() * way);
  }
  return planes;
}

} // namespace viscera::phantom
