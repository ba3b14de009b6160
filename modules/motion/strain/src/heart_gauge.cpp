#include "viscera/strain/heart_gauge.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "heart_contours.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/strain/strain_curve.h"
#include "viscera/strain/surface_strain.h"
#include "viscera/strain/valve_caps.h"
#include "viscera/strain/wall_means.h"
#include "viscera/strain/wall_measures.h"

namespace viscera::strain {
namespace {

constexpr double kMmPerCm = 10;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr int kMeasuredSegments = 16; ///< Without the cap, whose axes mean little.

using Thicknesses = std::array<double, kSegments + 1>;

/// A surface at rest with its place among the phases.
struct Place {
  std::optional<HeartSurface> HeartSurfaces::*rest;
  std::vector<Points> HeartPhases::*phases;
};
constexpr Place kPlaces[] = {{&HeartSurfaces::left, &HeartPhases::left},
                             {&HeartSurfaces::right, &HeartPhases::right},
                             {&HeartSurfaces::outer, &HeartPhases::outer},
                             {&HeartSurfaces::atrium, &HeartPhases::atrium}};

HeartSurfaces withCaps(HeartSurfaces surfaces, const FoundAxes& axes) {
  const Vec3& down = axes.axes.down();
  surfaces.left->caps = axes.cap;
  for (const Place& place : kPlaces)
    if (auto& surface = surfaces.*place.rest; surface && surface->caps.empty())
      surface->caps = valveCaps({surface->rest, surface->triangles, {}},
                                place.rest == &HeartSurfaces::atrium ? down : Vec3(-down))
                          .triangles;
  return surfaces;
}

ContourStrain asCurve(const std::string& name, std::vector<double> curve, const std::vector<double>& seconds,
                      bool longest) {
  ContourStrain strain{name, 0, std::move(curve), {}};
  strain.peak = longest ? longestOf(strain.curve, seconds) : shortestOf(strain.curve, seconds);
  return strain;
}

} // namespace

struct HeartGauge::Parts {
  Parts(HeartSurfaces given, FoundAxes found, std::shared_ptr<const WallPoints> points,
        const std::vector<ListedContour>& listed, Threads threads)
      : axes(std::move(found)), surfaces(withCaps(std::move(given), axes)), wall(std::move(points)),
        contours(findContours(surfaces, axes, listed)), twist(left().rest, onWall(), axes.axes),
        thickness(left().rest, left().triangles, axes.cap, axes.axes),
        endocardium(left().rest, left().triangles, axes.cap, axes.axes) {
    if (surfaces.outer)
      thicknessAtRest = thicknessOf(left().rest, surfaces.outer->rest,
                                    surfaces.right ? &surfaces.right->rest : nullptr, threads);
  }

  const HeartSurface& left() const { return *surfaces.left; }
  std::vector<bool> onWall() const { return verticesOf(left().rest.rows(), left().triangles, axes.cap); }

  Thicknesses thicknessOf(const Points& cavity, const Points& outer, const Points* right,
                          Threads threads) const {
    std::vector<ThicknessGauge::Bound> around = {{&outer, &surfaces.outer->triangles, &surfaces.outer->caps}};
    if (right)
      around.push_back({right, &surfaces.right->triangles, nullptr});
    return thickness.at(cavity, around, threads);
  }

  FoundAxes axes;
  HeartSurfaces surfaces;
  std::shared_ptr<const WallPoints> wall;
  HeartContours contours;
  TwistGauge twist;
  ThicknessGauge thickness;
  EndocardialSegments endocardium;
  Thicknesses thicknessAtRest{}; ///< Where an outer surface is known.
};

/// Measures one motion.
class HeartGauge::Measuring {
public:
  Measuring(const Parts& parts, const HeartPhases& phases, Progress& progress, Threads threads)
      : parts_(parts), phases_(phases), progress_(progress), threads_(threads), result_(parts.axes) {
    result_.seconds = phases.seconds;
    result_.reference = phases.reference;
    result_.wall = parts.wall != nullptr;
    for (int i = 0; i < kSegments; ++i)
      result_.segments[static_cast<std::size_t>(i)].number = i + 1;
  }

  HeartStrain measured() {
    progress_.report(0, "strain");
    contours();
    areas();
    twist();
    progress_.report(0.2, "strain");
    thickness();
    endocardium();
    progress_.report(0.5, "strain");
    if (parts_.wall)
      material();
    for (SegmentStrain& segment : result_.segments)
      segment.enough = segment.witnesses >= kFewestWitnesses;
    dispersion();
    progress_.report(1);
    return std::move(result_);
  }

private:
  void contours() {
    const HeartContours& found = parts_.contours;
    result_.longitudinal = strainsOf(found.longitudinal);
    result_.circumferential = strainsOf(found.circumferential);
    result_.others = strainsOf(found.others);
    result_.gls = mean("gls", result_.longitudinal);
    result_.gcs = mean("gcs", result_.circumferential);
    if (found.rightFreeWall)
      result_.rightFreeWall = strainOf(*found.rightFreeWall);
    result_.leftReservoir = mean("leftReservoir", strainsOf(found.reservoir));
    if (result_.leftReservoir)
      result_.leftReservoir->peak = longestOf(result_.leftReservoir->curve, phases_.seconds);
  }

  void areas() {
    for (const Place& place : kPlaces) {
      const auto& surface = parts_.surfaces.*place.rest;
      if (!surface || place.rest == &HeartSurfaces::atrium)
        continue;
      std::vector<double> areas;
      for (const Points& phase : phases_.*place.phases)
        areas.push_back(areaWithout(phase, surface->triangles, surface->caps));
      ContourStrain strain = curve(surface->name, changeFrom(areas, phases_.reference));
      strain.referenceMm = areas[phases_.reference];
      result_.areas.push_back(std::move(strain));
    }
  }

  void twist() {
    if (!parts_.twist.complete())
      return;
    const Points& reference = phases_.left[phases_.reference];
    for (const Points& phase : phases_.left) {
      const double degrees = parts_.twist.between(reference, phase).degrees();
      result_.twistDegrees.push_back(degrees);
      result_.torsionDegreesPerCm.push_back(degrees * kMmPerCm / parts_.twist.distanceMm(reference));
    }
  }

  /// Whether all surfaces between which thickness is measured are at rest.
  bool atRest(std::size_t phase) const {
    const HeartSurfaces& rest = parts_.surfaces;
    return phases_.left[phase] == rest.left->rest && phases_.outer[phase] == rest.outer->rest &&
           (!rest.right || phases_.right[phase] == rest.right->rest);
  }

  void thickness() {
    if (!parts_.surfaces.outer)
      return;
    std::vector<Thicknesses> found(phases_.seconds.size(), parts_.thicknessAtRest);
    std::vector<std::size_t> moved;
    for (std::size_t phase = 0; phase < found.size(); ++phase)
      if (!atRest(phase))
        moved.push_back(phase);
    forEach(moved, [&](std::size_t phase, Threads threads) {
      found[phase] = parts_.thicknessOf(phases_.left[phase], phases_.outer[phase],
                                        parts_.surfaces.right ? &phases_.right[phase] : nullptr, threads);
    });
    for (SegmentStrain& segment : result_.segments) {
      for (const Thicknesses& phase : found)
        segment.thicknessMm.push_back(phase[static_cast<std::size_t>(segment.number)]);
      segment.thickening = changeFrom(segment.thicknessMm, phases_.reference);
    }
  }

  void endocardium() {
    const EndocardialSegments& gauge = parts_.endocardium;
    std::vector<EndocardialSegments::Means> means(phases_.seconds.size());
    parallelRanges(static_cast<Eigen::Index>(means.size()), 1, threads_,
                   [&](Eigen::Index begin, Eigen::Index) {
                     const auto phase = static_cast<std::size_t>(begin);
                     means[phase] = gauge.between(phases_.left[phases_.reference], phases_.left[phase]);
                   });
    for (SegmentStrain& segment : result_.segments) {
      const auto place = static_cast<std::size_t>(segment.number);
      const bool known = gauge.triangles(segment.number) > 0;
      for (const auto& phase : means)
        segment.area.push_back(known ? phase.area[place] : kUnknown);
      if (parts_.wall)
        continue;
      segment.witnesses = gauge.triangles(segment.number);
      for (const auto& phase : means) {
        segment.longitudinal.push_back(known ? phase.longitudinal[place] : kUnknown);
        segment.circumferential.push_back(known ? phase.circumferential[place] : kUnknown);
      }
    }
    if (parts_.wall)
      return;
    std::vector<double> along, around;
    for (const auto& phase : means) {
      along.push_back(phase.longitudinal[0]);
      around.push_back(phase.circumferential[0]);
    }
    result_.materialLongitudinal = curve("materialLongitudinal", along);
    result_.materialCircumferential = curve("materialCircumferential", around);
  }

  void material() {
    std::vector<Eigen::Matrix3d> atReference;
    phases_.gradientsAt(phases_.reference, atReference, threads_);
    const WallReference reference(*parts_.wall, atReference);
    std::vector<WallMeans> means(phases_.seconds.size());
    std::vector<std::size_t> others;
    for (std::size_t phase = 0; phase < means.size(); ++phase)
      if (phase != phases_.reference)
        others.push_back(phase);
    means[phases_.reference] = reference.meansAt(atReference);
    forEach(others, [&](std::size_t phase, Threads threads) {
      std::vector<Eigen::Matrix3d> gradients;
      phases_.gradientsAt(phase, gradients, threads);
      means[phase] = reference.meansAt(gradients);
    });
    addMaterial(means);
  }

  void addMaterial(const std::vector<WallMeans>& means) {
    const std::vector<int>& places = parts_.wall->segments;
    for (SegmentStrain& segment : result_.segments) {
      const auto k = static_cast<std::size_t>(segment.number);
      segment.witnesses = static_cast<int>(std::count(places.begin(), places.end(), segment.number));
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
    result_.materialLongitudinal = curve("materialLongitudinal", overall(&WallMeans::longitudinal));
    result_.materialCircumferential = curve("materialCircumferential", overall(&WallMeans::circumferential));
    result_.grs = asCurve("grs", overall(&WallMeans::radial), phases_.seconds, true);
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

  /// Several phases at once; a single one, the pose of a drag, has all threads to itself.
  void forEach(const std::vector<std::size_t>& phases,
               const std::function<void(std::size_t phase, Threads threads)>& body) const {
    const Threads inner = phases.size() == 1 ? threads_ : Threads{1};
    parallelRanges(static_cast<Eigen::Index>(phases.size()), 1, phases.size() == 1 ? Threads{1} : threads_,
                   [&](Eigen::Index begin, Eigen::Index) {
                     progress_.throwIfCancelled();
                     body(phases[static_cast<std::size_t>(begin)], inner);
                   });
  }

  ContourStrain curve(const std::string& name, std::vector<double> values) const {
    return asCurve(name, std::move(values), phases_.seconds, false);
  }

  ContourStrain strainOf(const HeartContour& contour) const {
    return contourStrain(contour.name, contour.line, phases_.*contour.surface, phases_.seconds,
                         phases_.reference);
  }

  std::vector<ContourStrain> strainsOf(const std::vector<HeartContour>& contours) const {
    std::vector<ContourStrain> strains;
    for (const HeartContour& contour : contours)
      strains.push_back(strainOf(contour));
    return strains;
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
    ContourStrain strain = curve(name, meanOf(curves));
    strain.referenceMm = length;
    return strain;
  }

  const Parts& parts_;
  const HeartPhases& phases_;
  Progress& progress_;
  const Threads threads_;
  HeartStrain result_;
};

HeartGauge::HeartGauge(HeartSurfaces surfaces, FoundAxes axes, std::shared_ptr<const WallPoints> wall,
                       const std::vector<ListedContour>& listed, Threads threads)
    : parts_(std::make_shared<const Parts>(std::move(surfaces), std::move(axes), std::move(wall), listed,
                                           threads)) {}

const HeartSurfaces& HeartGauge::surfaces() const {
  return parts_->surfaces;
}
const FoundAxes& HeartGauge::axes() const {
  return parts_->axes;
}
const std::shared_ptr<const WallPoints>& HeartGauge::wall() const {
  return parts_->wall;
}

HeartStrain HeartGauge::read(const HeartPhases& phases, Progress& progress, Threads threads) const {
  if (phases.seconds.empty() || phases.reference >= phases.seconds.size())
    throw DataError(phrase("There is no phase %1", phases.reference + 1), "heart",
                    phrase("phases are counted from 1 to %1", phases.seconds.size()));
  for (const Place& place : kPlaces)
    if (const auto& surface = parts_->surfaces.*place.rest;
        surface && (phases.*place.phases).size() != phases.seconds.size())
      throw DataError(misuse("A surface needs its points in each phase"), surface->name);
  return Measuring(*parts_, phases, progress, threads).measured();
}

} // namespace viscera::strain
