#include "viscera/live/strain_reading.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/geometry/signed_distance.h"
#include "viscera/geometry/volume.h"
#include "viscera/geometry/winding_number.h"
#include "viscera/live/witness_sampling.h"
#include "viscera/strain/wall_measures.h"

#include "strain_confidence.h"

namespace viscera::live {
namespace {

using geometry::TriangleMesh;
using strain::HeartSurface;

/// The part of a cavity's vertices that has to lie in the surface around it.
constexpr double kMostlyInside = 0.95;
constexpr Eigen::Index kTried = 400;
/// A left ventricle that holds more in another phase than in the reference: a part of it.
constexpr double kFuller = 0.03;
/// The outer surface may lie this many times farther from the cavity than its wall: fat is upon it.
constexpr double kBeyondWall = 1.5;

std::size_t organNamed(const MovedOrgans& organs, const std::string& name) {
  for (std::size_t i = 0; i < organs.organs.size(); ++i)
    if (organs.organs[i].name == name)
      return i;
  std::string names;
  for (const SequenceOrgan& organ : organs.organs)
    names += (names.empty() ? "" : ", ") + organ.name;
  throw UsageError(phrase("There is no surface \"%1\"", name), "heart", phrase("there are: %1", names));
}

std::optional<std::size_t> chamberOf(const MovedOrgans& organs, const std::string& given,
                                     const anatomy::Part& chamber) {
  if (!given.empty())
    return organNamed(organs, given);
  for (std::size_t i = 0; i < organs.organs.size(); ++i)
    if (anatomy::chamberNamed(organs.organs[i].name) == chamber)
      return i;
  return std::nullopt;
}

double volumeOf(const TriangleMesh& mesh) {
  return std::abs(geometry::volume(mesh.points, mesh.triangles));
}

bool holds(const TriangleMesh& outer, const TriangleMesh& cavity) {
  const geometry::WindingNumber winding(outer);
  const Eigen::Index step = std::max<Eigen::Index>(1, cavity.points.rows() / kTried);
  int tried = 0, inside = 0;
  for (Eigen::Index row = 0; row < cavity.points.rows(); row += step, ++tried)
    inside += std::abs(winding(cavity.points.row(row).transpose())) > 0.5 ? 1 : 0;
  return inside >= kMostlyInside * tried;
}

/// The smallest surface around the left ventricle's cavity that is no cavity itself.
std::optional<std::size_t> outerOf(const MovedOrgans& organs, const std::string& given, std::size_t left) {
  if (!given.empty())
    return organNamed(organs, given);
  std::optional<std::size_t> best;
  double smallest = 0;
  for (std::size_t i = 0; i < organs.organs.size(); ++i) {
    if (i == left || anatomy::chamberNamed(organs.organs[i].name))
      continue;
    const double volume = volumeOf(*organs.organs[i].mesh);
    if ((!best || volume < smallest) && holds(*organs.organs[i].mesh, *organs.organs[left].mesh)) {
      best = i;
      smallest = volume;
    }
  }
  return best;
}

/// A surface of the heart at rest, with triangles that face outward.
HeartSurface outwardSurface(const SequenceOrgan& organ) {
  HeartSurface surface{organ.name, organ.mesh->triangles, organ.mesh->points, {}};
  if (geometry::volume(surface.rest, surface.triangles) < 0)
    surface.triangles.col(1).swap(surface.triangles.col(2));
  return surface;
}

/// A surface of the heart and how handles move it.
struct BoundSurface {
  std::optional<HeartSurface> strain::HeartSurfaces::*rest;
  std::vector<Points> strain::HeartPhases::*phases;
  std::optional<std::size_t> organ; ///< None: it is no organ, but the sample heart's own wall.
  std::shared_ptr<const coordinates::Binding> binding = nullptr; ///< Never null once it is bound.
};

/// The tetrahedra between the outer surface of a heart and its cavities, with what they were made for.
struct Tissue {
  TriangleMesh outer;
  std::vector<std::shared_ptr<const TriangleMesh>> cavities;
  int wanted = 0; ///< Witness points in the outer surface.
  deformation::WitnessMesh mesh;
  std::vector<Text> remarks;

  bool isOf(const TriangleMesh& surface, const std::vector<std::shared_ptr<const TriangleMesh>>& holes,
            int points) const {
    return wanted == points && cavities == holes && outer.triangles == surface.triangles &&
           outer.points == surface.points;
  }
};

/// Takes `before` where it is of the same surfaces: the tetrahedra take most of the time.
std::shared_ptr<const Tissue> tissueOf(const TriangleMesh& outer, const MovedOrgans& organs,
                                       const TriangleMesh* left, int wanted,
                                       const std::shared_ptr<const Tissue>& before, Progress& progress,
                                       Threads threads) {
  std::vector<std::shared_ptr<const TriangleMesh>> cavities;
  for (const SequenceOrgan& organ : organs.organs)
    if (organ.mesh.get() != &outer && (organ.mesh.get() == left || anatomy::chamberNamed(organ.name)))
      cavities.push_back(organ.mesh);
  if (before && before->isOf(outer, cavities, wanted))
    return before;
  WitnessOptions options;
  options.wanted = wanted;
  options.threads = threads;
  const WitnessSample sample = sampleWitnesses(outer, options, progress);
  deformation::WitnessMesh mesh = deformation::withoutCavities(*sample.mesh, cavities, threads);
  return std::make_shared<const Tissue>(
      Tissue{outer, std::move(cavities), wanted, std::move(mesh), sample.remarks});
}

/// The wall of the left ventricle with the gradients at its points.
struct BoundWall {
  std::shared_ptr<const Tissue> tissue;
  std::shared_ptr<const strain::WallPoints> points;
  std::shared_ptr<const deformation::WitnessGradients> gradients;
  std::vector<Eigen::Matrix3d> atRest; ///< The gradients in the pose of rest.
};

BoundWall boundWall(const MovedOrgans& organs, const strain::WallSurfaces& surfaces,
                    const strain::FoundAxes& axes, const StrainOptions& options,
                    const std::shared_ptr<const Tissue>& before, Progress& progress, Threads threads) {
  BoundWall wall;
  runPart(progress, 0, 0.3, [&](Progress& part) {
    wall.tissue =
        tissueOf(*surfaces.outer, organs, surfaces.leftCavity, options.witnesses, before, part, threads);
  });
  const deformation::WitnessMesh& tissue = wall.tissue->mesh;
  runPart(progress, 0.3, 0.6, [&](Progress& part) {
    wall.points = std::make_shared<const strain::WallPoints>(
        strain::wallPoints(tissue, surfaces, axes.axes, axes.cap, part, threads));
  });
  Points places(wall.points->count(), 3);
  for (Eigen::Index i = 0; i < places.rows(); ++i)
    places.row(i) = tissue.points.row(wall.points->rows[static_cast<std::size_t>(i)]);
  runPart(progress, 0.6, 1, [&](Progress& part) {
    wall.gradients = deformation::bindWitnesses(*organs.system, organs.handles, places,
                                                {organs.parameters, threads}, part);
  });
  wall.gradients->deformationGradients(organs.handles.positions, wall.atRest, threads);
  return wall;
}

/// Contours by the rows that points have now.
std::vector<strain::ListedContour> presentContours(const MovedOrgans& organs, const StrainOptions& options,
                                                   std::size_t left) {
  std::vector<strain::ListedContour> contours = options.contours;
  for (strain::ListedContour& contour : contours) {
    std::size_t surface = left;
    if (const std::optional<anatomy::Part> chamber = anatomy::chamberNamed(contour.surface);
        !contour.surface.empty()) {
      surface = organs.organs.size();
      for (std::size_t i = 0; i < organs.organs.size(); ++i)
        if (organs.organs[i].name == contour.surface)
          surface = i;
      for (std::size_t i = 0; surface == organs.organs.size() && chamber && i < organs.organs.size(); ++i)
        if (anatomy::chamberNamed(organs.organs[i].name) == chamber)
          surface = i;
      if (surface == organs.organs.size())
        surface = organNamed(organs, contour.surface); // Says which there are.
    }
    contour.surface = organs.organs[surface].name;
    if (surface >= organs.rowOfGiven.size() || organs.rowOfGiven[surface].empty())
      continue;
    const std::vector<std::int32_t>& rows = organs.rowOfGiven[surface];
    for (std::int32_t& vertex : contour.vertices) {
      const bool known = vertex >= 0 && static_cast<std::size_t>(vertex) < rows.size();
      if (!known || rows[static_cast<std::size_t>(vertex)] < 0)
        throw DataError(
            diagnostic("There is no vertex %1", vertex), contour.name,
            diagnostic("vertices of %1 are counted from 0 to %2", contour.surface, rows.size() - 1));
      vertex = rows[static_cast<std::size_t>(vertex)];
    }
  }
  return contours;
}

/// The phase in which the left ventricle is clearly fuller than in this one.
std::optional<std::size_t> fullerPhase(const Triangles& triangles, const std::vector<Points>& phases,
                                       std::size_t reference) {
  std::vector<double> volumes;
  for (const Points& phase : phases)
    volumes.push_back(geometry::volume(phase, triangles));
  const auto fullest = std::max_element(volumes.begin(), volumes.end());
  if (reference >= volumes.size() || *fullest <= (1 + kFuller) * volumes[reference])
    return std::nullopt;
  return static_cast<std::size_t>(fullest - volumes.begin());
}

void warn(std::optional<std::size_t> fuller, StrainReading& reading) {
  if (!reading.strain.oriented)
    reading.warnings.push_back(phrase(
        "Without the right ventricle the numbers of segments mean nothing: give its surface, or a point "
        "where it meets the left one in front"));
  if (reading.corresponding == false)
    reading.warnings.push_back(
        phrase("Material points are not known in this motion: lengths of contours can be "
               "read, segments cannot"));
  if (fuller)
    reading.warnings.push_back(
        phrase("The left ventricle is fullest in phase %1, and strain is measured from "
               "phase %2",
               *fuller + 1, reading.strain.reference + 1));
  constexpr StrainDirection kWithRange[] = {StrainDirection::longitudinal, StrainDirection::circumferential,
                                            StrainDirection::radial};
  int uncertain = 0;
  for (const strain::SegmentStrain& segment : reading.strain.segments)
    uncertain += reading.reliable(segment) &&
                 std::any_of(std::begin(kWithRange), std::end(kWithRange), [&](StrainDirection direction) {
                   return !reliablePeak(reading, segment.number, direction);
                 });
  if (uncertain > 0)
    reading.warnings.push_back(
        phrase("In %n {segment|segments} the fit of the motion leaves a peak less certain than its distance "
               "from the range of healthy adults",
               uncertain));
  const auto few = std::count_if(reading.strain.segments.begin(), reading.strain.segments.end(),
                                 [](const strain::SegmentStrain& segment) { return !segment.enough; });
  if (few > 0)
    reading.warnings.push_back(phrase("%n {segment has|segments have} too few points to be read", few));
}

} // namespace

struct StrainGauge::Parts {
  strain::HeartGauge heart;
  std::vector<BoundSurface> surfaces;
  std::optional<BoundWall> wall;
  Points rest; ///< Of the handles.
  std::optional<std::size_t> reference;
  std::vector<std::vector<int>> segments; ///< Of the vertices of each organ.
  std::vector<Text> warnings;

  std::vector<Points> phasesOf(const BoundSurface& surface, const MovedOrgans& moved, Threads threads) const;
  strain::HeartPhases phasesOf(const MovedOrgans& moved, Progress& progress, Threads threads) const;
  FittedPose fittedPose(const MovedOrgans& moved, std::size_t phase, Threads threads) const;
};

/// The measured points of a surface, else where the handles move it; handles at rest leave it at rest.
std::vector<Points> StrainGauge::Parts::phasesOf(const BoundSurface& surface, const MovedOrgans& moved,
                                                 Threads threads) const {
  if (surface.organ && !moved.measured.empty())
    return moved.measured[*surface.organ];
  std::vector<Points> phases(moved.poses.size());
  for (std::size_t phase = 0; phase < phases.size(); ++phase)
    if (moved.poses[phase] == rest)
      phases[phase] = (heart.surfaces().*surface.rest)->rest;
    else
      surface.binding->deform(moved.poses[phase], phases[phase], threads);
  return phases;
}

strain::HeartPhases StrainGauge::Parts::phasesOf(const MovedOrgans& moved, Progress& progress,
                                                 Threads threads) const {
  strain::HeartPhases phases;
  phases.seconds = moved.seconds;
  for (const BoundSurface& surface : surfaces) {
    progress.throwIfCancelled();
    phases.*surface.phases = phasesOf(surface, moved, threads);
  }
  if (wall)
    phases.gradientsAt = [this, &moved](std::size_t phase, std::vector<Eigen::Matrix3d>& gradients,
                                        Threads inner) {
      if (moved.poses[phase] == rest)
        gradients = wall->atRest;
      else
        wall->gradients->deformationGradients(moved.poses[phase], gradients, inner);
    };
  return phases;
}

/// A pose of a motion that was fitted to measured surfaces, with what it has left at the handles.
FittedPose StrainGauge::Parts::fittedPose(const MovedOrgans& moved, std::size_t phase,
                                          Threads threads) const {
  std::vector<Points> fitted(surfaces.size());
  std::vector<SurfaceResidual> left;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!surfaces[i].organ)
      continue;
    surfaces[i].binding->deform(moved.poses[phase], fitted[i], threads);
    left.push_back({&(heart.surfaces().*surfaces[i].rest)->rest, &fitted[i],
                    &moved.measured[*surfaces[i].organ][phase]});
  }
  return {&moved.poses[phase], handleResiduals(rest, left, threads)};
}

namespace {

std::vector<int> segmentsOfCavity(const strain::HeartGauge& heart) {
  const HeartSurface& surface = *heart.surfaces().left;
  const std::vector<bool> onWall =
      strain::verticesOf(surface.rest.rows(), surface.triangles, heart.axes().cap);
  std::vector<int> found(onWall.size(), 0);
  for (std::size_t i = 0; i < found.size(); ++i)
    if (onWall[i])
      found[i] =
          strain::segmentOf(heart.axes().axes, surface.rest.row(static_cast<Eigen::Index>(i)).transpose());
  return found;
}

/// What is nearer to the right cavity than to the left one is the right ventricle's wall; what is far from
/// both is no ventricle.
std::vector<int> segmentsAround(const strain::HeartGauge& heart, const Points& around) {
  const auto meshOf = [](const std::optional<HeartSurface>& surface) {
    return surface ? std::make_shared<const TriangleMesh>(TriangleMesh{surface->rest, surface->triangles, {}})
                   : nullptr;
  };
  const strain::HeartSurfaces& surfaces = heart.surfaces();
  const auto left = meshOf(surfaces.left), outer = meshOf(surfaces.outer), right = meshOf(surfaces.right);
  const strain::HeartAxes& axes = heart.axes().axes;
  const auto reach = strain::reachOfSegments({left.get(), outer.get(), right.get()}, axes, heart.axes().cap);
  const geometry::SignedDistance fromLeft(left);
  std::optional<geometry::SignedDistance> fromRight;
  if (right)
    fromRight.emplace(right);
  std::vector<int> found(static_cast<std::size_t>(around.rows()), 0);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Vec3 place = around.row(static_cast<Eigen::Index>(i)).transpose();
    const double away = std::abs(fromLeft(place));
    const int segment = strain::segmentOf(axes, place);
    if (away <= kBeyondWall * reach[static_cast<std::size_t>(segment)] &&
        (!fromRight || away <= std::abs((*fromRight)(place))))
      found[i] = segment;
  }
  return found;
}

/// The organs that are the surfaces of the heart.
struct ChosenOrgans {
  std::size_t left = 0;
  std::optional<std::size_t> right, outer, atrium;

  ChosenOrgans(const MovedOrgans& organs, const StrainOptions& options) {
    const std::optional<std::size_t> found = chamberOf(organs, options.left, anatomy::kLeftVentricle);
    if (!found)
      throw DataError("No surface is a left ventricle by its name", "heart", "name its cavity with --lv");
    left = *found;
    right = chamberOf(organs, options.right, anatomy::kRightVentricle);
    atrium = chamberOf(organs, options.atrium, anatomy::kLeftAtrium);
    outer = outerOf(organs, options.outer, left);
  }
};

} // namespace

StrainGauge::StrainGauge(const MovedOrgans& organs, const StrainOptions& options, Progress& progress,
                         Threads threads, const StrainGauge* before) {
  const ChosenOrgans chosen(organs, options);
  progress.report(0, "surfaces in motion");
  // 1. The surfaces at rest and what moves them.
  std::vector<BoundSurface> bound = {{&strain::HeartSurfaces::left, &strain::HeartPhases::left, chosen.left}};
  if (chosen.right)
    bound.push_back({&strain::HeartSurfaces::right, &strain::HeartPhases::right, chosen.right});
  const bool own = organs.wall && options.outer.empty();
  if (own || chosen.outer)
    bound.push_back(
        {&strain::HeartSurfaces::outer, &strain::HeartPhases::outer, own ? std::nullopt : chosen.outer});
  if (chosen.atrium)
    bound.push_back({&strain::HeartSurfaces::atrium, &strain::HeartPhases::atrium, chosen.atrium});
  strain::HeartSurfaces surfaces;
  Progress quiet;
  for (BoundSurface& surface : bound) {
    progress.throwIfCancelled();
    surfaces.*surface.rest = outwardSurface(surface.organ ? organs.organs[*surface.organ] : *organs.wall);
    surface.binding = deformation::bindOrgan(*organs.system, organs.handles, (surfaces.*surface.rest)->rest,
                                             {organs.parameters, threads}, quiet);
  }
  // 2. Axes and wall.
  const auto meshOf = [&](std::optional<std::size_t> organ) {
    return organ ? organs.organs[*organ].mesh.get() : nullptr;
  };
  const TriangleMesh leftMesh{surfaces.left->rest, surfaces.left->triangles, {}};
  strain::FoundAxes axes = strain::findAxes(leftMesh, meshOf(chosen.right), options.landmarks);
  const TriangleMesh* outer = own ? organs.wall->mesh.get() : meshOf(chosen.outer);
  std::optional<BoundWall> wall;
  if (outer)
    runPart(progress, 0.1, 0.9, [&](Progress& part) {
      wall =
          boundWall(organs, {meshOf(chosen.left), outer, meshOf(chosen.right)}, axes, options,
                    before && before->parts_->wall ? before->parts_->wall->tissue : nullptr, part, threads);
    });
  const std::vector<Text> warnings = wall ? wall->tissue->remarks : std::vector<Text>();
  const strain::HeartGauge heart(std::move(surfaces), std::move(axes), wall ? wall->points : nullptr,
                                 presentContours(organs, options, chosen.left), threads);
  // 3. Segments of the organs that are seen.
  std::vector<std::vector<int>> segments(organs.organs.size());
  segments[chosen.left] = segmentsOfCavity(heart);
  if (chosen.outer)
    segments[*chosen.outer] = segmentsAround(heart, organs.organs[*chosen.outer].mesh->points);
  parts_ =
      std::make_shared<const Parts>(Parts{heart, std::move(bound), std::move(wall), organs.handles.positions,
                                          options.reference, std::move(segments), warnings});
}

const std::vector<int>& StrainGauge::segmentsOn(std::size_t organ) const {
  return parts_->segments[organ];
}

StrainReading StrainGauge::read(const MovedOrgans& moved, Progress& progress, Threads threads,
                                std::optional<std::size_t> reference) const {
  const Parts& parts = *parts_;
  const strain::HeartSurfaces& surfaces = parts.heart.surfaces();
  strain::HeartPhases phases = parts.phasesOf(moved, progress, threads);
  const auto fullerThan = [&](std::size_t phase) {
    return fullerPhase(surfaces.left->triangles, phases.left, phase);
  };
  phases.reference = reference.value_or(parts.reference.value_or(fullerThan(0).value_or(0)));
  StrainReading reading(parts.heart.axes());
  const auto nameOf = [](const std::optional<HeartSurface>& surface) {
    return surface ? surface->name : std::string();
  };
  reading.left = nameOf(surfaces.left);
  reading.right = nameOf(surfaces.right);
  reading.outer = nameOf(surfaces.outer);
  reading.atrium = nameOf(surfaces.atrium);
  reading.corresponding = moved.corresponding;
  reading.warnings = parts.warnings;
  if (parts.wall)
    reading.witnesses = static_cast<int>(parts.wall->points->count());
  reading.strain = parts.heart.read(phases, progress, threads);
  if (parts.wall && !moved.measured.empty() && moved.corresponding.value_or(false)) {
    const std::size_t peak = reading.strain.gls ? reading.strain.gls->peak.phase : phases.reference;
    reading.deviations = drawnDeviations(*parts.wall->points, *parts.wall->gradients,
                                         parts.fittedPose(moved, phases.reference, threads),
                                         parts.fittedPose(moved, peak, threads), progress, threads);
  }
  warn(fullerThan(phases.reference), reading);
  return reading;
}

StrainReading readStrain(const MovedOrgans& organs, const StrainOptions& options, Progress& progress,
                         Threads threads) {
  std::optional<StrainGauge> gauge;
  runPart(progress, 0, 0.7, [&](Progress& part) { gauge.emplace(organs, options, part, threads); });
  std::optional<StrainReading> reading;
  runPart(progress, 0.7, 1, [&](Progress& part) { reading = gauge->read(organs, part, threads); });
  return std::move(*reading);
}

} // namespace viscera::live
