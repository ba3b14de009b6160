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
#include "viscera/document/rig.h"
#include "viscera/geometry/signed_distance.h"
#include "viscera/geometry/volume.h"
#include "viscera/geometry/winding_number.h"
#include "viscera/live/witness_sampling.h"
#include "viscera/strain/wall_measures.h"

#include "strain_confidence.h"

namespace viscera::live {
namespace {

using geometry::TriangleMesh;
using strain::MovingSurface;

/// The part of a cavity's vertices that has to lie in the surface around it.
constexpr double kMostlyInside = 0.95;
constexpr Eigen::Index kTried = 400;
/// A left ventricle that holds more in another phase than in the reference: a part of it.
constexpr double kFuller = 0.03;
/// The outer surface may lie this many times farther from the cavity than its wall: fat is upon it.
constexpr double kBeyondWall = 1.5;
constexpr double kSecondsOfMinute = 60;

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

/// A surface of the heart at rest, with triangles that face outward, and how handles move it.
struct GaugedSurface {
  std::size_t organ = 0;
  MovingSurface rest;
  std::shared_ptr<const coordinates::Binding> binding; ///< Never null.

  GaugedSurface(const MovedOrgans& organs, std::size_t place, Progress& progress, Threads threads)
      : organ(place), rest{organs.organs[place].name,
                           organs.organs[place].mesh->triangles,
                           organs.organs[place].mesh->points,
                           {}} {
    if (geometry::volume(rest.rest, rest.triangles) < 0)
      rest.triangles.col(1).swap(rest.triangles.col(2));
    binding = deformation::bindOrgan(*organs.system, organs.handles, rest.rest, {organs.parameters, threads},
                                     progress);
  }

  MovingSurface in(const MovedOrgans& moved, Threads threads) const {
    MovingSurface surface = rest;
    if (!moved.measured.empty()) {
      surface.phases = moved.measured[organ];
      return surface;
    }
    surface.phases.resize(moved.poses.size());
    for (std::size_t phase = 0; phase < moved.poses.size(); ++phase)
      binding->deform(moved.poses[phase], surface.phases[phase], threads);
    return surface;
  }
};

/// A pose of a motion that was fitted to measured surfaces, with what it has left at the handles.
FittedPose fittedPose(const MovedOrgans& moved, const std::vector<const GaugedSurface*>& surfaces,
                      std::size_t phase, Threads threads) {
  std::vector<Points> fitted(surfaces.size());
  std::vector<SurfaceResidual> left;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    surfaces[i]->binding->deform(moved.poses[phase], fitted[i], threads);
    left.push_back({&surfaces[i]->rest.rest, &fitted[i], &moved.measured[surfaces[i]->organ][phase]});
  }
  return {&moved.poses[phase], handleResiduals(moved.handles.positions, left, threads)};
}

/// The wall of the left ventricle with the gradients at its points.
struct BoundWall {
  strain::WallPoints points;
  std::shared_ptr<const deformation::WitnessGradients> gradients;
};

BoundWall boundWall(const MovedOrgans& organs, const strain::WallSurfaces& surfaces,
                    const strain::FoundAxes& axes, const StrainOptions& options, std::vector<Text>& warnings,
                    Progress& progress, Threads threads) {
  WitnessOptions wanted;
  wanted.wanted = options.witnesses;
  wanted.threads = threads;
  WitnessSample sample;
  runPart(progress, 0, 0.3, [&](Progress& part) { sample = sampleWitnesses(*surfaces.outer, wanted, part); });
  warnings.insert(warnings.end(), sample.remarks.begin(), sample.remarks.end());
  std::vector<std::shared_ptr<const TriangleMesh>> cavities;
  for (const SequenceOrgan& organ : organs.organs)
    if (organ.mesh.get() != surfaces.outer &&
        (organ.mesh.get() == surfaces.leftCavity || anatomy::chamberNamed(organ.name)))
      cavities.push_back(organ.mesh);
  const deformation::WitnessMesh tissue = deformation::withoutCavities(*sample.mesh, cavities, threads);
  BoundWall wall;
  runPart(progress, 0.3, 0.6, [&](Progress& part) {
    wall.points = strain::wallPoints(tissue, surfaces, axes.axes, axes.cap, part, threads);
  });
  Points places(wall.points.count(), 3);
  for (Eigen::Index i = 0; i < places.rows(); ++i)
    places.row(i) = tissue.points.row(wall.points.rows[static_cast<std::size_t>(i)]);
  runPart(progress, 0.6, 1, [&](Progress& part) {
    wall.gradients = deformation::bindWitnesses(*organs.system, organs.handles, places,
                                                {organs.parameters, threads}, part);
  });
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
std::optional<std::size_t> fullerPhase(const MovingSurface& left, std::size_t reference) {
  std::vector<double> volumes;
  for (const Points& phase : left.phases)
    volumes.push_back(geometry::volume(phase, left.triangles));
  const auto fullest = std::max_element(volumes.begin(), volumes.end());
  if (reference >= volumes.size() || *fullest <= (1 + kFuller) * volumes[reference])
    return std::nullopt;
  return static_cast<std::size_t>(fullest - volumes.begin());
}

void warn(const strain::MovingSurface& left, const strain::FoundAxes& axes, StrainReading& reading) {
  if (!axes.oriented)
    reading.warnings.push_back(phrase(
        "Without the right ventricle the numbers of segments mean nothing: give its surface, or a point "
        "where it meets the left one in front"));
  if (reading.corresponding == false)
    reading.warnings.push_back(
        phrase("Material points are not known in this motion: lengths of contours can be "
               "read, segments cannot"));
  if (const auto fuller = fullerPhase(left, reading.strain.reference))
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

coordinates::HandleSet handlesOf(const SequenceFile& file) {
  coordinates::HandleSet handles;
  handles.positions = file.track.restHandles;
  for (const sequences::HandleGroup& group : file.track.groups)
    handles.groups.push_back({group.name, group.handles});
  return handles;
}

} // namespace

MovedOrgans movedOrgans(const SequenceFile& file, const coordinates::Registry& systems) {
  if (file.organs.empty())
    throw UsageError("It holds no organ", file.track.name.empty() ? "sequence" : file.track.name,
                     "name one with --organ");
  MovedOrgans moved;
  moved.organs = file.organs;
  moved.handles = handlesOf(file);
  const document::SystemChoice choice = file.system.value_or(document::SystemChoice());
  moved.system = systems.find(choice.id);
  moved.parameters = choice.parameters;
  for (const auto& key : file.track.keys) {
    moved.seconds.push_back(key.seconds);
    moved.poses.push_back(key.pose);
  }
  return moved;
}

MovedOrgans movedOrgans(const MotionSeries& series, const PatientMotion& found,
                        const coordinates::Registry& systems) {
  MovedOrgans moved = movedOrgans(found.sequence, systems);
  moved.corresponding = found.corresponding;
  for (const tracking::SurfaceSeries& surface : series.corresponding) {
    moved.measured.push_back(surface.phases);
    moved.rowOfGiven.push_back(surface.rowOfGiven);
  }
  return moved;
}

MovedOrgans movedOrgans(MotionRunner& runner, const coordinates::Registry& systems, int instants,
                        Progress& progress) {
  runner.requireMovable();
  const document::DocumentState& state = runner.state();
  MovedOrgans moved;
  for (const auto& organ : *state.organs)
    if (runner.organs().bound(organ->id))
      moved.organs.push_back({organ->name, organ->mesh});
  moved.handles = document::handleSet(*state.rig);
  moved.system = systems.find(state.system->id);
  moved.parameters = state.system->parameters;
  const double rate = runner.ratePerMinute();
  for (const double key : runner.sequence()->keys())
    moved.seconds.push_back(key * runner.sequence()->standardRatePerMinute() / rate);
  if (moved.seconds.empty()) {
    moved.corresponding = true; // A motion that is computed moves material points.
    for (int i = 0; i < instants; ++i)
      moved.seconds.push_back(i * kSecondsOfMinute / rate / instants);
  }
  for (const double seconds : moved.seconds) {
    progress.throwIfCancelled();
    const std::optional<Points> pose = runner.poseAt(seconds);
    if (!pose)
      throw DataError(runner.obstacle(), runner.sequence()->id());
    moved.poses.push_back(*pose);
  }
  return moved;
}

struct StrainGauge::Parts {
  explicit Parts(strain::FoundAxes found) : axes(std::move(found)) {}

  std::optional<GaugedSurface> left, right, outer, atrium;
  strain::FoundAxes axes;
  std::optional<std::size_t> reference;
  std::vector<strain::ListedContour> contours;
  std::optional<BoundWall> wall;
  std::vector<std::vector<int>> segments; ///< Of the vertices of each organ.
  std::vector<Text> warnings;

  std::vector<int> segmentsOfCavity() const;
  std::vector<int> segmentsAround() const;
};

std::vector<int> StrainGauge::Parts::segmentsOfCavity() const {
  const MovingSurface& surface = left->rest;
  const std::vector<bool> onWall = strain::verticesOf(surface.rest.rows(), surface.triangles, axes.cap);
  std::vector<int> found(onWall.size(), 0);
  for (std::size_t i = 0; i < found.size(); ++i)
    if (onWall[i])
      found[i] = strain::segmentOf(axes.axes, surface.rest.row(static_cast<Eigen::Index>(i)).transpose());
  return found;
}

/// What is nearer to the right cavity than to the left one is the right ventricle's wall; what is far from
/// both is no ventricle.
std::vector<int> StrainGauge::Parts::segmentsAround() const {
  const auto meshOf = [](const GaugedSurface& surface) {
    return std::make_shared<const TriangleMesh>(TriangleMesh{surface.rest.rest, surface.rest.triangles, {}});
  };
  const auto leftMesh = meshOf(*left), outerMesh = meshOf(*outer),
             rightMesh = right ? meshOf(*right) : nullptr;
  const auto reach =
      strain::reachOfSegments({leftMesh.get(), outerMesh.get(), rightMesh.get()}, axes.axes, axes.cap);
  const geometry::SignedDistance fromLeft(leftMesh);
  std::optional<geometry::SignedDistance> fromRight;
  if (right)
    fromRight.emplace(rightMesh);
  std::vector<int> found(static_cast<std::size_t>(outerMesh->points.rows()), 0);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Vec3 place = outerMesh->points.row(static_cast<Eigen::Index>(i)).transpose();
    const double away = std::abs(fromLeft(place));
    const int segment = strain::segmentOf(axes.axes, place);
    if (away <= kBeyondWall * reach[static_cast<std::size_t>(segment)] &&
        (!fromRight || away <= std::abs((*fromRight)(place))))
      found[i] = segment;
  }
  return found;
}

StrainGauge::StrainGauge(const MovedOrgans& organs, const StrainOptions& options, Progress& progress,
                         Threads threads) {
  const std::optional<std::size_t> left = chamberOf(organs, options.left, anatomy::kLeftVentricle);
  if (!left)
    throw DataError("No surface is a left ventricle by its name", "heart", "name its cavity with --lv");
  const std::optional<std::size_t> right = chamberOf(organs, options.right, anatomy::kRightVentricle);
  const std::optional<std::size_t> atrium = chamberOf(organs, options.atrium, anatomy::kLeftAtrium);
  const std::optional<std::size_t> outer = outerOf(organs, options.outer, *left);
  progress.report(0, "surfaces in motion");
  Progress quiet;
  const GaugedSurface leftSurface(organs, *left, quiet, threads);
  const TriangleMesh leftMesh{leftSurface.rest.rest, leftSurface.rest.triangles, {}};
  auto parts = std::make_shared<Parts>(
      strain::findAxes(leftMesh, right ? organs.organs[*right].mesh.get() : nullptr, options.landmarks));
  parts->left = leftSurface;
  for (const auto& [place, target] : {std::pair(right, &parts->right), std::pair(outer, &parts->outer),
                                      std::pair(atrium, &parts->atrium)}) {
    progress.throwIfCancelled();
    if (!place)
      continue;
    target->emplace(organs, *place, quiet, threads);
    const Vec3& down = parts->axes.axes.down();
    (*target)->rest.caps = strain::capsOf((*target)->rest, target == &parts->atrium ? down : Vec3(-down));
  }
  parts->reference = options.reference;
  parts->contours = presentContours(organs, options, *left);
  if (outer)
    runPart(progress, 0.1, 0.9, [&](Progress& part) {
      parts->wall = boundWall(organs,
                              {organs.organs[*left].mesh.get(), organs.organs[*outer].mesh.get(),
                               right ? organs.organs[*right].mesh.get() : nullptr},
                              parts->axes, options, parts->warnings, part, threads);
    });
  parts->segments.resize(organs.organs.size());
  parts->segments[*left] = parts->segmentsOfCavity();
  if (outer)
    parts->segments[*outer] = parts->segmentsAround();
  parts_ = std::move(parts);
}

const std::vector<int>& StrainGauge::segmentsOn(std::size_t organ) const {
  return parts_->segments[organ];
}

StrainReading StrainGauge::read(const MovedOrgans& moved, Progress& progress, Threads threads,
                                std::optional<std::size_t> reference) const {
  const Parts& parts = *parts_;
  const MovingSurface left = parts.left->in(moved, threads);
  std::optional<MovingSurface> right, outer, atrium;
  for (const auto& [surface, target] : {std::pair(&parts.right, &right), std::pair(&parts.outer, &outer),
                                        std::pair(&parts.atrium, &atrium)}) {
    progress.throwIfCancelled();
    if (*surface)
      *target = (*surface)->in(moved, threads);
  }
  strain::MovingHeart heart;
  heart.leftCavity = &left;
  heart.rightCavity = right ? &*right : nullptr;
  heart.outer = outer ? &*outer : nullptr;
  heart.leftAtrium = atrium ? &*atrium : nullptr;
  heart.seconds = moved.seconds;
  heart.reference = reference.value_or(parts.reference.value_or(fullerPhase(left, 0).value_or(0)));
  StrainReading reading(parts.axes);
  const auto nameOf = [](const std::optional<MovingSurface>& surface) {
    return surface ? surface->name : std::string();
  };
  reading.left = left.name;
  reading.right = nameOf(right);
  reading.outer = nameOf(outer);
  reading.atrium = nameOf(atrium);
  reading.corresponding = moved.corresponding;
  reading.warnings = parts.warnings;
  strain::MovingWall movingWall;
  if (parts.wall) {
    movingWall.points = &parts.wall->points;
    movingWall.gradientsAt = [&](std::size_t phase, std::vector<Eigen::Matrix3d>& gradients) {
      parts.wall->gradients->deformationGradients(moved.poses[phase], gradients, Threads{1});
    };
    reading.witnesses = static_cast<int>(parts.wall->points.count());
  }
  reading.strain = strain::heartStrain(heart, parts.axes, parts.wall ? &movingWall : nullptr, parts.contours,
                                       progress, threads);
  if (parts.wall && !moved.measured.empty() && moved.corresponding.value_or(false)) {
    std::vector<const GaugedSurface*> surfaces;
    for (const auto* surface : {&parts.left, &parts.right, &parts.outer, &parts.atrium})
      if (*surface)
        surfaces.push_back(&**surface);
    const std::size_t peak = reading.strain.gls ? reading.strain.gls->peak.phase : heart.reference;
    reading.deviations = drawnDeviations(parts.wall->points, *parts.wall->gradients,
                                         fittedPose(moved, surfaces, heart.reference, threads),
                                         fittedPose(moved, surfaces, peak, threads), progress, threads);
  }
  warn(left, parts.axes, reading);
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
