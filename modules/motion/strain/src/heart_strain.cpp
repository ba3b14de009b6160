#include "viscera/strain/heart_strain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/strain/surface_strain.h"
#include "viscera/strain/valve_caps.h"
#include "viscera/strain/wall_means.h"
#include "viscera/strain/wall_measures.h"

namespace viscera::strain {
namespace {

using std::numbers::pi;

constexpr double kMmPerCm = 10;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
/// The planes of the three long-axis views, behind the anterior insertion.
struct View {
  const char* name;
  double angle;
};
constexpr View kViews[] = {{"fourChamber", pi / 2}, {"twoChamber", 5 * pi / 6}, {"threeChamber", pi / 6}};
struct Level {
  const char* name;
  double height;
};
constexpr Level kLevels[] = {{"base", 0.25}, {"middle", 0.5}, {"apex", 0.75}};
constexpr int kMeasuredSegments = 16; ///< Without the cap, whose axes mean little.

geometry::Plane alongAxis(const HeartAxes& axes, double angle) {
  return {axes.base(), axes.down().cross(axes.across(angle)).normalized()};
}

/// The vertex of a contour that lies farthest along the axis.
std::size_t lowestOf(const MaterialContour& contour, const Points& rest, const HeartAxes& axes, double sign) {
  Eigen::Index place = 0;
  const Points line = contour.at(rest);
  (sign * (line.rowwise() - axes.base().transpose()) * axes.down()).maxCoeff(&place);
  return static_cast<std::size_t>(place);
}

/// Opens a closed line at its end behind the valves.
MaterialContour opened(MaterialContour contour, const Points& rest, const HeartAxes& axes, double sign) {
  if (!contour.closed)
    return contour;
  const auto top = static_cast<std::ptrdiff_t>(lowestOf(contour, rest, axes, -sign));
  std::rotate(contour.places.begin(), contour.places.begin() + top, contour.places.end());
  contour.closed = false;
  return contour;
}

/// Collects what is measured.
class Measuring {
public:
  Measuring(const MovingHeart& heart, const FoundAxes& found, const std::vector<ListedContour>& listed,
            HeartStrain& result)
      : heart_(heart), axes_(found.axes), cap_(found.cap), listed_(listed), result_(result) {}

  void contours() {
    const MovingSurface& left = *heart_.leftCavity;
    for (const View& view : kViews)
      addLongitudinal(view, left);
    for (const Level& level : kLevels)
      addCircumferential(level, left);
    result_.gls = mean("gls", result_.longitudinal);
    result_.gcs = mean("gcs", result_.circumferential);
    result_.rightFreeWall = rightFreeWall();
    result_.leftReservoir = reservoir();
    for (const ListedContour& listed : listed_)
      if (!hasPlace(listed.name))
        result_.others.push_back(strainOf(listed));
  }

  void areas() {
    for (const MovingSurface* surface : {heart_.leftCavity, heart_.rightCavity, heart_.outer}) {
      if (!surface)
        continue;
      const std::vector<bool> caps = surface == heart_.leftCavity ? cap_ : capsOf(*surface, -axes_.down());
      std::vector<double> areas;
      for (const Points& phase : surface->phases)
        areas.push_back(areaWithout(phase, surface->triangles, caps));
      result_.areas.push_back(withPeak(surface->name, areas));
    }
  }

  void twist() {
    const MovingSurface& left = *heart_.leftCavity;
    const TwistGauge gauge(left.rest, verticesOf(left.rest.rows(), left.triangles, cap_), axes_);
    if (!gauge.complete())
      return;
    const Points& reference = left.phases[heart_.reference];
    for (const Points& phase : left.phases) {
      const double degrees = gauge.between(reference, phase).degrees();
      result_.twistDegrees.push_back(degrees);
      result_.torsionDegreesPerCm.push_back(degrees * kMmPerCm / gauge.distanceMm(reference));
    }
  }

  void thickness(Threads threads, Progress& progress) {
    if (!heart_.outer)
      return;
    const MovingSurface& left = *heart_.leftCavity;
    const ThicknessGauge gauge(left.rest, left.triangles, cap_, axes_);
    const std::vector<bool> outerCap = capsOf(*heart_.outer, -axes_.down());
    std::vector<std::array<double, kSegments + 1>> found(heart_.seconds.size());
    parallelRanges(
        static_cast<Eigen::Index>(found.size()), 1, threads, [&](Eigen::Index begin, Eigen::Index) {
          progress.throwIfCancelled();
          const auto phase = static_cast<std::size_t>(begin);
          std::vector<ThicknessGauge::Bound> around = {
              {&heart_.outer->phases[phase], &heart_.outer->triangles, &outerCap}};
          if (heart_.rightCavity)
            around.push_back({&heart_.rightCavity->phases[phase], &heart_.rightCavity->triangles, nullptr});
          found[phase] = gauge.at(left.phases[phase], around);
        });
    for (SegmentStrain& segment : result_.segments) {
      for (const auto& phase : found)
        segment.thicknessMm.push_back(phase[static_cast<std::size_t>(segment.number)]);
      segment.thickening = changeFrom(segment.thicknessMm, heart_.reference);
    }
  }

  void endocardium(bool asSegments, Threads threads) {
    const MovingSurface& left = *heart_.leftCavity;
    const EndocardialSegments gauge(left.rest, left.triangles, cap_, axes_);
    std::vector<EndocardialSegments::Means> means(heart_.seconds.size());
    parallelRanges(static_cast<Eigen::Index>(means.size()), 1, threads,
                   [&](Eigen::Index begin, Eigen::Index) {
                     const auto phase = static_cast<std::size_t>(begin);
                     means[phase] = gauge.between(left.phases[heart_.reference], left.phases[phase]);
                   });
    for (SegmentStrain& segment : result_.segments) {
      const auto place = static_cast<std::size_t>(segment.number);
      const bool known = gauge.triangles(segment.number) > 0;
      for (const auto& phase : means)
        segment.area.push_back(known ? phase.area[place] : kUnknown);
      if (!asSegments)
        continue;
      segment.witnesses = gauge.triangles(segment.number);
      for (const auto& phase : means) {
        segment.longitudinal.push_back(known ? phase.longitudinal[place] : kUnknown);
        segment.circumferential.push_back(known ? phase.circumferential[place] : kUnknown);
      }
    }
    if (!asSegments)
      return;
    std::vector<double> along, around;
    for (const auto& phase : means) {
      along.push_back(phase.longitudinal[0]);
      around.push_back(phase.circumferential[0]);
    }
    result_.materialLongitudinal = asCurve("materialLongitudinal", along, false);
    result_.materialCircumferential = asCurve("materialCircumferential", around, false);
  }

  void material(const MovingWall& wall, Threads threads, Progress& progress) {
    const WallPoints& points = *wall.points;
    std::vector<Eigen::Matrix3d> rest;
    wall.gradientsAt(heart_.reference, rest);
    const WallReference reference(points, std::move(rest));
    std::vector<WallMeans> means(heart_.seconds.size());
    parallelRanges(static_cast<Eigen::Index>(means.size()), 1, threads,
                   [&](Eigen::Index begin, Eigen::Index) {
                     progress.throwIfCancelled();
                     const auto phase = static_cast<std::size_t>(begin);
                     std::vector<Eigen::Matrix3d> gradients;
                     wall.gradientsAt(phase, gradients);
                     means[phase] = reference.meansAt(gradients);
                   });
    addMaterial(points, means);
  }

  void dispersion() {
    std::vector<double> along, around;
    for (int number = 1; number <= kMeasuredSegments; ++number) {
      const SegmentStrain& segment = result_.segment(number);
      if (!segment.enough)
        continue;
      along.push_back(shortestOf(segment.longitudinal, result_.seconds).seconds);
      around.push_back(shortestOf(segment.circumferential, result_.seconds).seconds);
    }
    result_.dispersionLongitudinal = deviationOf(along);
    result_.dispersionCircumferential = deviationOf(around);
  }

private:
  void addMaterial(const WallPoints& points, const std::vector<WallMeans>& means) {
    for (SegmentStrain& segment : result_.segments) {
      const auto k = static_cast<std::size_t>(segment.number);
      segment.witnesses =
          static_cast<int>(std::count(points.segments.begin(), points.segments.end(), segment.number));
      for (const WallMeans& phase : means) {
        segment.longitudinal.push_back(phase.longitudinal[k]);
        segment.circumferential.push_back(phase.circumferential[k]);
        segment.radial.push_back(phase.radial[k]);
      }
    }
    const auto overall = [&means](const std::array<double, kSegments + 1> WallMeans::*values) {
      std::vector<double> curve;
      for (const WallMeans& phase : means)
        curve.push_back((phase.*values)[0]);
      return curve;
    };
    result_.materialLongitudinal = asCurve("materialLongitudinal", overall(&WallMeans::longitudinal), false);
    result_.materialCircumferential =
        asCurve("materialCircumferential", overall(&WallMeans::circumferential), false);
    result_.grs = asCurve("grs", overall(&WallMeans::radial), true);
  }

  ContourStrain asCurve(const std::string& name, std::vector<double> curve, bool longest) const {
    ContourStrain strain{name, 0, std::move(curve), {}};
    strain.peak =
        longest ? longestOf(strain.curve, heart_.seconds) : shortestOf(strain.curve, heart_.seconds);
    return strain;
  }

  ContourStrain withPeak(const std::string& name, const std::vector<double>& sizes) const {
    ContourStrain strain = asCurve(name, changeFrom(sizes, heart_.reference), false);
    strain.referenceMm = sizes[heart_.reference];
    return strain;
  }

  std::optional<ContourStrain> mean(const std::string& name, const std::vector<ContourStrain>& of) const {
    if (of.empty())
      return std::nullopt;
    std::vector<const std::vector<double>*> curves;
    double length = 0;
    for (const ContourStrain& contour : of) {
      curves.push_back(&contour.curve);
      length += contour.referenceMm / static_cast<double>(of.size());
    }
    ContourStrain strain = asCurve(name, meanOf(curves), false);
    strain.referenceMm = length;
    return strain;
  }

  const MovingSurface* surfaceNamed(const std::string& name) const {
    for (const MovingSurface* surface :
         {heart_.leftCavity, heart_.rightCavity, heart_.outer, heart_.leftAtrium})
      if (surface && surface->name == name)
        return surface;
    return nullptr;
  }

  ContourStrain strainOf(const ListedContour& listed) const {
    const MovingSurface* surface = surfaceNamed(listed.surface);
    if (!surface)
      throw DataError(phrase("There is no surface \"%1\"", listed.surface), listed.name,
                      "name one of the surfaces of the heart");
    for (const std::int32_t vertex : listed.vertices)
      if (vertex < 0 || vertex >= surface->rest.rows())
        throw DataError(
            diagnostic("There is no vertex %1", vertex), listed.name,
            diagnostic("vertices of %1 are counted from 0 to %2", surface->name, surface->rest.rows() - 1));
    if (listed.vertices.size() < 2)
      throw DataError(diagnostic("A contour has two vertices at least"), listed.name);
    return contourStrain(listed.name, MaterialContour::through(listed.vertices, listed.closed),
                         surface->phases, heart_.seconds, heart_.reference);
  }

  std::optional<ContourStrain> listedNamed(const std::string& name) const {
    for (const ListedContour& listed : listed_)
      if (listed.name == name)
        return strainOf(listed);
    return std::nullopt;
  }

  static bool hasPlace(const std::string& name) {
    for (const View& view : kViews)
      if (name == view.name)
        return true;
    for (const Level& level : kLevels)
      if (name == level.name)
        return true;
    return name == "rightFreeWall" || name == "leftReservoir";
  }

  void addLongitudinal(const View& view, const MovingSurface& left) {
    if (auto listed = listedNamed(view.name)) {
      result_.longitudinal.push_back(std::move(*listed));
      return;
    }
    const auto lines = cutContours(left.rest, left.triangles, cap_, alongAxis(axes_, view.angle));
    if (!lines.empty())
      result_.longitudinal.push_back(contourStrain(view.name, opened(lines.front(), left.rest, axes_, 1),
                                                   left.phases, heart_.seconds, heart_.reference));
  }

  void addCircumferential(const Level& level, const MovingSurface& left) {
    if (auto listed = listedNamed(level.name)) {
      result_.circumferential.push_back(std::move(*listed));
      return;
    }
    const geometry::Plane plane{axes_.base() + level.height * axes_.length() * axes_.down(), axes_.down()};
    const auto lines = cutContours(left.rest, left.triangles, cap_, plane);
    if (!lines.empty())
      result_.circumferential.push_back(
          contourStrain(level.name, lines.front(), left.phases, heart_.seconds, heart_.reference));
  }

  /// The contour runs from the tricuspid annulus to the right ventricle's apex, on the side away from the
  /// left one.
  std::optional<ContourStrain> rightFreeWall() const {
    if (auto listed = listedNamed("rightFreeWall"))
      return listed;
    if (!heart_.rightCavity)
      return std::nullopt;
    const MovingSurface& right = *heart_.rightCavity;
    const auto lines = cutContours(right.rest, right.triangles, capsOf(right, -axes_.down()),
                                   alongAxis(axes_, kViews[0].angle));
    if (lines.empty())
      return std::nullopt;
    const MaterialContour line = opened(lines.front(), right.rest, axes_, 1);
    const std::size_t tip = lowestOf(line, right.rest, axes_, 1);
    const MaterialContour one = partUpTo(line, tip), other = partFrom(line, tip);
    const auto away = [&](const MaterialContour& part) {
      double sum = 0;
      const Points places = part.at(right.rest);
      for (const auto& row : places.rowwise())
        sum += axes_.distanceOf(row.transpose());
      return sum / static_cast<double>(std::max<Eigen::Index>(places.rows(), 1));
    };
    const MaterialContour& free = away(one) > away(other) ? one : other;
    if (free.places.size() < 2)
      return std::nullopt;
    return contourStrain("rightFreeWall", free, right.phases, heart_.seconds, heart_.reference);
  }

  /// The contours run from one side of the mitral annulus over the roof of the atrium to the other, in two
  /// planes.
  std::optional<ContourStrain> reservoir() const {
    if (auto listed = listedNamed("leftReservoir")) {
      listed->peak = longestOf(listed->curve, heart_.seconds);
      return listed;
    }
    if (!heart_.leftAtrium)
      return std::nullopt;
    const MovingSurface& atrium = *heart_.leftAtrium;
    const std::vector<bool> caps = capsOf(atrium, axes_.down());
    std::vector<ContourStrain> found;
    for (const View& view : {kViews[0], kViews[1]}) {
      const auto lines = cutContours(atrium.rest, atrium.triangles, caps, alongAxis(axes_, view.angle));
      if (!lines.empty())
        found.push_back(contourStrain(view.name, opened(lines.front(), atrium.rest, axes_, -1), atrium.phases,
                                      heart_.seconds, heart_.reference));
    }
    std::optional<ContourStrain> strain = mean("leftReservoir", found);
    if (strain)
      strain->peak = longestOf(strain->curve, heart_.seconds);
    return strain;
  }

  const MovingHeart& heart_;
  const HeartAxes& axes_;
  const std::vector<bool>& cap_;
  const std::vector<ListedContour>& listed_;
  HeartStrain& result_;
};

void requirePhases(const MovingHeart& heart) {
  if (heart.seconds.empty() || heart.reference >= heart.seconds.size())
    throw DataError(phrase("There is no phase %1", heart.reference + 1), "heart",
                    phrase("phases are counted from 1 to %1", heart.seconds.size()));
  for (const MovingSurface* surface : {heart.leftCavity, heart.rightCavity, heart.outer, heart.leftAtrium})
    if (surface && surface->phases.size() != heart.seconds.size())
      throw DataError(misuse("A surface needs its points in each phase"), surface->name);
}

} // namespace

std::vector<bool> capsOf(const MovingSurface& surface, const Vec3& towardsBase) {
  return surface.caps.empty() ? valveCaps({surface.rest, surface.triangles, {}}, towardsBase).triangles
                              : surface.caps;
}

ContourStrain contourStrain(const std::string& name, const MaterialContour& contour,
                            const std::vector<Points>& phases, const std::vector<double>& seconds,
                            std::size_t reference) {
  std::vector<double> lengths;
  for (const Points& phase : phases)
    lengths.push_back(contour.lengthAt(phase));
  ContourStrain strain{name, lengths[reference], changeFrom(lengths, reference), {}};
  strain.peak = shortestOf(strain.curve, seconds);
  return strain;
}

HeartStrain heartStrain(const MovingHeart& heart, const FoundAxes& axes, const MovingWall* wall,
                        const std::vector<ListedContour>& listed, Progress& progress, Threads threads) {
  requirePhases(heart);
  HeartStrain result(axes);
  result.seconds = heart.seconds;
  result.reference = heart.reference;
  result.wall = wall != nullptr;
  for (int i = 0; i < kSegments; ++i)
    result.segments[static_cast<std::size_t>(i)].number = i + 1;
  Measuring measuring(heart, axes, listed, result);
  progress.report(0, "strain");
  measuring.contours();
  measuring.areas();
  measuring.twist();
  progress.report(0.2, "strain");
  measuring.thickness(threads, progress);
  measuring.endocardium(!wall, threads);
  progress.report(0.5, "strain");
  if (wall)
    measuring.material(*wall, threads, progress);
  for (SegmentStrain& segment : result.segments)
    segment.enough = segment.witnesses >= kFewestWitnesses;
  measuring.dispersion();
  progress.report(1);
  return result;
}

} // namespace viscera::strain
