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
#include "viscera/geometry/volume.h"
#include "viscera/geometry/winding_number.h"
#include "viscera/live/witness_sampling.h"

namespace viscera::live {
namespace {

using geometry::TriangleMesh;
using strain::MovingSurface;

/// The part of a cavity's vertices that has to lie in the surface around it.
constexpr double kMostlyInside = 0.95;
constexpr Eigen::Index kTried = 400;
/// A left ventricle that holds more in another phase than in the reference: a part of it.
constexpr double kFuller = 0.03;

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

/// A surface in all phases: measured, or where the handles move it. Triangles face outward.
MovingSurface moving(const MovedOrgans& organs, std::size_t i, Progress& progress, Threads threads) {
  const TriangleMesh& mesh = *organs.organs[i].mesh;
  MovingSurface surface{organs.organs[i].name, mesh.triangles, mesh.points, {}};
  if (geometry::volume(mesh.points, mesh.triangles) < 0)
    surface.triangles.col(1).swap(surface.triangles.col(2));
  if (!organs.measured.empty()) {
    surface.phases = organs.measured[i];
    return surface;
  }
  const auto binding = deformation::bindOrgan(*organs.system, organs.handles, mesh.points,
                                              {organs.parameters, threads}, progress);
  surface.phases.resize(organs.poses.size());
  for (std::size_t phase = 0; phase < organs.poses.size(); ++phase)
    binding->deform(organs.poses[phase], surface.phases[phase], threads);
  return surface;
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

StrainReading readStrain(const MovedOrgans& organs, const StrainOptions& options, Progress& progress,
                         Threads threads) {
  const std::optional<std::size_t> left = chamberOf(organs, options.left, anatomy::kLeftVentricle);
  if (!left)
    throw DataError("No surface is a left ventricle by its name", "heart", "name its cavity with --lv");
  const std::optional<std::size_t> right = chamberOf(organs, options.right, anatomy::kRightVentricle);
  const std::optional<std::size_t> atrium = chamberOf(organs, options.atrium, anatomy::kLeftAtrium);
  const std::optional<std::size_t> outer = outerOf(organs, options.outer, *left);
  progress.report(0, "surfaces in motion");
  Progress quiet;
  const MovingSurface leftSurface = moving(organs, *left, quiet, threads);
  std::optional<MovingSurface> rightSurface, outerSurface, atriumSurface;
  for (const auto& [place, target] : {std::pair(right, &rightSurface), std::pair(outer, &outerSurface),
                                      std::pair(atrium, &atriumSurface)}) {
    progress.throwIfCancelled();
    if (place)
      *target = moving(organs, *place, quiet, threads);
  }
  const TriangleMesh leftMesh{leftSurface.rest, leftSurface.triangles, {}};
  const strain::FoundAxes axes =
      strain::findAxes(leftMesh, right ? organs.organs[*right].mesh.get() : nullptr, options.landmarks);
  strain::MovingHeart heart;
  heart.leftCavity = &leftSurface;
  heart.rightCavity = rightSurface ? &*rightSurface : nullptr;
  heart.outer = outerSurface ? &*outerSurface : nullptr;
  heart.leftAtrium = atriumSurface ? &*atriumSurface : nullptr;
  heart.seconds = organs.seconds;
  heart.reference = options.reference.value_or(fullerPhase(leftSurface, 0).value_or(0));
  StrainReading reading(axes);
  reading.left = organs.organs[*left].name;
  reading.corresponding = organs.corresponding;
  const auto nameAt = [&organs](const std::optional<std::size_t>& place) {
    return place ? organs.organs[*place].name : std::string();
  };
  reading.right = nameAt(right);
  reading.outer = nameAt(outer);
  reading.atrium = nameAt(atrium);
  std::optional<BoundWall> wall;
  if (outer)
    runPart(progress, 0.1, 0.7, [&](Progress& part) {
      wall = boundWall(organs,
                       {organs.organs[*left].mesh.get(), organs.organs[*outer].mesh.get(),
                        right ? organs.organs[*right].mesh.get() : nullptr},
                       axes, options, reading.warnings, part, threads);
    });
  strain::MovingWall movingWall;
  if (wall) {
    movingWall.points = &wall->points;
    movingWall.gradientsAt = [&](std::size_t phase, std::vector<Eigen::Matrix3d>& gradients) {
      wall->gradients->deformationGradients(organs.poses[phase], gradients, Threads{1});
    };
    reading.witnesses = static_cast<int>(wall->points.count());
  }
  runPart(progress, 0.7, 1, [&](Progress& part) {
    reading.strain = strain::heartStrain(heart, axes, wall ? &movingWall : nullptr,
                                         presentContours(organs, options, *left), part, threads);
  });
  warn(leftSurface, axes, reading);
  return reading;
}

} // namespace viscera::live
