#include "heart_contours.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::strain {
namespace {

using std::numbers::pi;

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
constexpr const char* kRightFreeWall = "rightFreeWall";
constexpr const char* kReservoir = "leftReservoir";

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

/// Cuts the contours of one heart, or takes them from a list.
class ContourCutter {
public:
  ContourCutter(const HeartSurfaces& surfaces, const HeartAxes& axes,
                const std::vector<ListedContour>& listed)
      : surfaces_(surfaces), axes_(axes), listed_(listed) {}

  std::optional<HeartContour> longitudinal(const View& view) const {
    if (auto listed = listedNamed(view.name))
      return listed;
    const HeartSurface& left = *surfaces_.left;
    const auto lines = cutContours(left.rest, left.triangles, left.caps, alongAxis(axes_, view.angle));
    if (lines.empty())
      return std::nullopt;
    return HeartContour{view.name, opened(lines.front(), left.rest, axes_, 1), &HeartPhases::left};
  }

  std::optional<HeartContour> circumferential(const Level& level) const {
    if (auto listed = listedNamed(level.name))
      return listed;
    const HeartSurface& left = *surfaces_.left;
    const geometry::Plane plane{axes_.base() + level.height * axes_.length() * axes_.down(), axes_.down()};
    const auto lines = cutContours(left.rest, left.triangles, left.caps, plane);
    if (lines.empty())
      return std::nullopt;
    return HeartContour{level.name, lines.front(), &HeartPhases::left};
  }

  /// The contour runs from the tricuspid annulus to the right ventricle's apex, on the side away from the
  /// left one.
  std::optional<HeartContour> rightFreeWall() const {
    if (auto listed = listedNamed(kRightFreeWall))
      return listed;
    if (!surfaces_.right)
      return std::nullopt;
    const HeartSurface& right = *surfaces_.right;
    const auto lines =
        cutContours(right.rest, right.triangles, right.caps, alongAxis(axes_, kViews[0].angle));
    if (lines.empty())
      return std::nullopt;
    const MaterialContour line = opened(lines.front(), right.rest, axes_, 1);
    const std::size_t tip = lowestOf(line, right.rest, axes_, 1);
    const MaterialContour one = partUpTo(line, tip), other = partFrom(line, tip);
    const MaterialContour& free = fromAxis(one, right.rest) > fromAxis(other, right.rest) ? one : other;
    if (free.places.size() < 2)
      return std::nullopt;
    return HeartContour{kRightFreeWall, free, &HeartPhases::right};
  }

  /// The contours run from one side of the mitral annulus over the roof of the atrium to the other, in two
  /// planes.
  std::vector<HeartContour> reservoir() const {
    if (auto listed = listedNamed(kReservoir))
      return {std::move(*listed)};
    std::vector<HeartContour> found;
    for (const View& view : {kViews[0], kViews[1]}) {
      if (!surfaces_.atrium)
        break;
      const HeartSurface& atrium = *surfaces_.atrium;
      const auto lines =
          cutContours(atrium.rest, atrium.triangles, atrium.caps, alongAxis(axes_, view.angle));
      if (!lines.empty())
        found.push_back({view.name, opened(lines.front(), atrium.rest, axes_, -1), &HeartPhases::atrium});
    }
    return found;
  }

  /// Listed contours whose names are none of those above.
  std::vector<HeartContour> others() const {
    const auto hasPlace = [](const std::string& name) {
      const auto has = [&name](const auto& place) { return name == place.name; };
      return std::any_of(std::begin(kViews), std::end(kViews), has) ||
             std::any_of(std::begin(kLevels), std::end(kLevels), has) || name == kRightFreeWall ||
             name == kReservoir;
    };
    std::vector<HeartContour> found;
    for (const ListedContour& listed : listed_)
      if (!hasPlace(listed.name))
        found.push_back(through(listed));
    return found;
  }

private:
  double fromAxis(const MaterialContour& line, const Points& rest) const {
    double sum = 0;
    const Points places = line.at(rest);
    for (const auto& row : places.rowwise())
      sum += axes_.distanceOf(row.transpose());
    return sum / static_cast<double>(std::max<Eigen::Index>(places.rows(), 1));
  }

  std::optional<HeartContour> listedNamed(const std::string& name) const {
    for (const ListedContour& listed : listed_)
      if (listed.name == name)
        return through(listed);
    return std::nullopt;
  }

  HeartContour through(const ListedContour& listed) const {
    const std::pair<const std::optional<HeartSurface>*, std::vector<Points> HeartPhases::*> all[] = {
        {&surfaces_.left, &HeartPhases::left},
        {&surfaces_.right, &HeartPhases::right},
        {&surfaces_.outer, &HeartPhases::outer},
        {&surfaces_.atrium, &HeartPhases::atrium}};
    for (const auto& [surface, phases] : all)
      if (*surface && (*surface)->name == listed.surface)
        return {listed.name, through(listed, **surface), phases};
    throw DataError(phrase("There is no surface \"%1\"", listed.surface), listed.name,
                    "name one of the surfaces of the heart");
  }

  static MaterialContour through(const ListedContour& listed, const HeartSurface& surface) {
    for (const std::int32_t vertex : listed.vertices)
      if (vertex < 0 || vertex >= surface.rest.rows())
        throw DataError(
            diagnostic("There is no vertex %1", vertex), listed.name,
            diagnostic("vertices of %1 are counted from 0 to %2", surface.name, surface.rest.rows() - 1));
    if (listed.vertices.size() < 2)
      throw DataError(diagnostic("A contour has two vertices at least"), listed.name);
    return MaterialContour::through(listed.vertices, listed.closed);
  }

  const HeartSurfaces& surfaces_;
  const HeartAxes& axes_;
  const std::vector<ListedContour>& listed_;
};

} // namespace

HeartContours findContours(const HeartSurfaces& surfaces, const FoundAxes& axes,
                           const std::vector<ListedContour>& listed) {
  const ContourCutter cutter(surfaces, axes.axes, listed);
  HeartContours found;
  for (const View& view : kViews)
    if (auto contour = cutter.longitudinal(view))
      found.longitudinal.push_back(std::move(*contour));
  for (const Level& level : kLevels)
    if (auto contour = cutter.circumferential(level))
      found.circumferential.push_back(std::move(*contour));
  found.rightFreeWall = cutter.rightFreeWall();
  found.reservoir = cutter.reservoir();
  found.others = cutter.others();
  return found;
}

} // namespace viscera::strain
