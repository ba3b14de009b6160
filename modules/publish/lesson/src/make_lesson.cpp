#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "carried_vertices.h"
#include "grip_handles.h"
#include "lesson_heart.h"
#include "viscera/coordinates/registry.h"
#include "viscera/core/error.h"
#include "viscera/geometry/volume.h"
#include "viscera/lesson/lesson.h"
#include "viscera/live/motion_runner.h"
#include "viscera/live/strain_reading.h"
#include "viscera/presentation/strain_figure.h"

namespace viscera::lesson {
namespace {

constexpr int kAnchors = 40;
constexpr std::array<double, 4> kChecked = {0.131, 0.377, 0.613, 0.871}; ///< Fractions that are no samples.
constexpr double kBetweenSamplesMm = 0.012; ///< How far the motion may be off between samples,
constexpr double kModesMm = 0.01;           ///< and by the modes that are left out.
constexpr double kSampled = 0.5;            ///< Of the progress.
constexpr double kStrainFrom = 0.8;         ///< Likewise.
constexpr int kStrainInstants = 40;         ///< Of a cycle without keys.

/// Rounded as the page will have it.
Points stepped(const Points& points) {
  return ((points.array() / kStepMm).round() * kStepMm).matrix();
}

void addSurfaces(const LessonPlan& plan, const document::DocumentState& state, Lesson& lesson) {
  Eigen::Index vertices = 0, triangles = 0;
  for (const PlannedSurface& planned : plan.surfaces) {
    const auto organ = state.organ(planned.organ);
    LessonSurface surface;
    surface.firstVertex = vertices;
    surface.vertexCount = organ->mesh->points.rows();
    surface.firstTriangle = triangles;
    surface.triangleCount = organ->mesh->triangles.rows();
    surface.closed = organ->closed();
    surface.restMl = organ->restVolumeMm3 / kMm3PerMl;
    lesson.surfaces.push_back(std::move(surface));
    vertices += organ->mesh->points.rows();
    triangles += organ->mesh->triangles.rows();
  }
  lesson.triangles.resize(triangles, 3);
  lesson.colors.resize(vertices, 3);
  for (std::size_t i = 0; i < lesson.surfaces.size(); ++i) {
    const LessonSurface& surface = lesson.surfaces[i];
    const auto organ = state.organ(plan.surfaces[i].organ);
    lesson.triangles.middleRows(surface.firstTriangle, surface.triangleCount) =
        organ->mesh->triangles.array() + static_cast<std::int32_t>(surface.firstVertex);
    auto colors = lesson.colors.middleRows(surface.firstVertex, surface.vertexCount);
    if (plan.surfaces[i].vertexColors)
      colors = organ->mesh->colors;
    else
      colors.rowwise() =
          (plan.surfaces[i].color * 255).array().round().cast<std::uint8_t>().matrix().transpose();
  }
}

/// Vertices spread over a surface, the farthest from its middle first.
std::vector<int> anchorsOf(const Points& points, const LessonSurface& surface) {
  const auto own = points.middleRows(surface.firstVertex, surface.vertexCount);
  Eigen::VectorXd away = (own.rowwise() - own.colwise().mean()).rowwise().norm();
  std::vector<int> anchors;
  for (int i = 0; i < kAnchors; ++i) {
    Eigen::Index farthest = 0;
    away.maxCoeff(&farthest);
    anchors.push_back(static_cast<int>(surface.firstVertex + farthest));
    away = away.cwiseMin((own.rowwise() - own.row(farthest)).rowwise().norm());
  }
  return anchors;
}

void addPlaces(const LessonPlan& plan, const Points& rest, Lesson& lesson) {
  for (std::size_t i = 0; i < lesson.surfaces.size(); ++i) {
    LessonSurface& surface = lesson.surfaces[i];
    surface.anchors = anchorsOf(lesson.rest, surface);
    const auto own = rest.middleRows(surface.firstVertex, surface.vertexCount);
    for (const PlannedLabel& label : plan.surfaces[i].labels) {
      Eigen::Index nearest = 0;
      (own.rowwise() - label.at.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
      surface.labels.push_back(static_cast<int>(surface.firstVertex + nearest));
    }
  }
}

Table inSinglePrecision(const Table& table) {
  return table.cast<float>().cast<double>();
}

void addMotion(const MotionSamples& samples, const SampledMotion& motion, const LessonSource& source,
               Lesson& lesson) {
  lesson.end = samples.end;
  lesson.courseOfRate = samples.trackOfRate;
  for (const Points& mode : motion.modes)
    lesson.modes.push_back(stepped(mode));
  for (const Course& course : motion.courses)
    lesson.courses.push_back(
        {course.instants, inSinglePrecision(course.values), inSinglePrecision(course.slopes)});
  for (const double rate : lesson.plan.rates) {
    std::vector<sequences::Phase> phases = source.sequence->phases(rate);
    for (sequences::Phase& phase : phases)
      for (const PlannedPhase& planned : lesson.plan.phases)
        if (planned.name == phase.name.english()) {
          phase.name = planned.title;
          break;
        }
    lesson.phases.push_back(std::move(phases));
  }
}

/// The vertices as the page will have them.
Points shownPoints(const Lesson& lesson, std::size_t course, double fraction, Eigen::Index first,
                   Eigen::Index count) {
  const Eigen::VectorXd values = valueAt(lesson.courses[course], fraction);
  Points points = lesson.rest.middleRows(first, count);
  for (Eigen::Index k = 0; k < values.size(); ++k)
    points += values[k] * lesson.modes[static_cast<std::size_t>(k)].middleRows(first, count);
  return points;
}

/// The volume of every closed surface at every sample.
void addCurves(Lesson& lesson, Threads threads) {
  constexpr Eigen::Index samples = kCurveSamples;
  const auto courses = static_cast<Eigen::Index>(lesson.courses.size());
  for (LessonSurface& surface : lesson.surfaces)
    if (surface.closed)
      surface.curves.resize(courses, samples);
  parallelRanges(courses * samples, 1, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i)
      for (LessonSurface& surface : lesson.surfaces) {
        if (!surface.closed)
          continue;
        const Points points = shownPoints(lesson, static_cast<std::size_t>(i / samples),
                                          fractionOf(i % samples, samples, lesson.end), surface.firstVertex,
                                          surface.vertexCount);
        const Triangles triangles =
            (lesson.triangles.middleRows(surface.firstTriangle, surface.triangleCount).array() -
             static_cast<std::int32_t>(surface.firstVertex))
                .matrix();
        surface.curves(i / samples, i % samples) =
            geometry::volume(points, triangles, Threads{1}) / kMm3PerMl;
      }
  });
}

/// The strain of the segments in each course, and their places in the bull's eye.
void addStrain(const LessonSource& source, live::PosedOrgans& organs, const MotionSamples& samples,
               Lesson& lesson, Progress& progress, Threads threads) {
  using live::StrainDirection;
  live::MotionRunner runner(source.state, organs, threads);
  runner.setSequence(source.sequence);
  const coordinates::Registry systems = coordinates::builtInRegistry();
  std::optional<live::StrainGauge> gauge;
  for (const MotionSamples::Track& track : samples.tracks) {
    runner.setRatePerMinute(track.rate);
    runner.prescribe(source.prescribed);
    live::MovedOrgans moved = live::movedOrgans(runner, systems, kStrainInstants, progress);
    if (!gauge) {
      live::addOwnWall(source.state, progress, moved);
      gauge.emplace(moved, live::StrainOptions(), progress, threads);
    }
    const live::StrainReading reading = gauge->read(moved, progress, threads);
    const auto eyeAt = [&reading](std::size_t phase) {
      return presentation::strainBullsEye(reading, StrainDirection::longitudinal, live::StrainMoment::instant,
                                          phase);
    };
    lesson.sectors.clear();
    for (const auto& sector : eyeAt(0).sectors)
      lesson.sectors.push_back({sector.ring, sector.fromDegrees, sector.toDegrees});
    LessonStrain strain;
    strain.percent = Table::Constant(static_cast<Eigen::Index>(moved.seconds.size()),
                                     static_cast<Eigen::Index>(lesson.sectors.size()), std::nan(""));
    for (std::size_t phase = 0; phase < moved.seconds.size(); ++phase) {
      strain.fractions.push_back(moved.seconds[phase] / runner.periodSeconds());
      const auto sectors = eyeAt(phase).sectors;
      for (std::size_t segment = 0; segment < sectors.size(); ++segment)
        if (sectors[segment].value)
          strain.percent(static_cast<Eigen::Index>(phase), static_cast<Eigen::Index>(segment)) =
              *sectors[segment].value;
    }
    lesson.strain.push_back(std::move(strain));
  }
}

/// Compares with the organs themselves where the motion is likely to be off the most.
double largestError(const Lesson& lesson, const MotionSamples& samples, const SampledMotion& motion,
                    CarriedVertices& carried) {
  double largest = 0;
  Points pose;
  for (std::size_t course = 0; course < lesson.courses.size(); ++course) {
    std::vector<double> fractions(kChecked.begin(), kChecked.end());
    fractions.push_back(motion.worst[course]);
    for (const double fraction : fractions) {
      carried.poseAt(fraction, samples.tracks[course].rate, pose);
      const Points off = carried.in(pose)-shownPoints(lesson, course, fraction, 0, carried.rest().rows());
      largest = std::max(largest, off.rowwise().norm().maxCoeff());
    }
  }
  return largest;
}

void addHandles(Lesson& lesson, CarriedVertices& carried, const LessonSource& source, Progress& progress,
                Threads threads) {
  LessonPlan& plan = lesson.plan;
  if (plan.ownHandles) {
    lesson.handleLabels = plan.handles;
    lesson.weights = carried.weights().topRows(lesson.vertexCount()).transpose();
    return;
  }
  if (plan.placedHandles == 0)
    return;
  const GripHandles grips = gripHandles(lesson, source.state, plan.placedHandles, progress, threads);
  lesson.weights = grips.weights;
  const Eigen::Index vertices = lesson.rest.rows(), all = vertices + grips.positions.rows();
  lesson.rest.conservativeResize(all, 3);
  lesson.rest.bottomRows(grips.positions.rows()) = stepped(grips.positions);
  for (Points& mode : lesson.modes) {
    mode.conservativeResize(all, 3);
    mode.bottomRows(grips.positions.rows()).setZero();
  }
  for (Eigen::Index i = 0; i < grips.positions.rows(); ++i)
    lesson.handleLabels.push_back(std::to_string(i + 1));
}

} // namespace

std::size_t Lesson::instants() const {
  std::size_t count = 0;
  for (const Course& course : courses)
    count += course.instants.size();
  return count;
}

Lesson makeLesson(const LessonPlan& plan, const LessonSource& source, live::PosedOrgans& organs,
                  Progress& progress, Threads threads) {
  Lesson lesson;
  lesson.plan = plan;
  CarriedVertices carried(plan, source, organs, threads);
  if (carried.weights().cols() == 0) // Handles that are no weights cannot be dragged in the page.
    lesson.plan.ownHandles = false;
  addSurfaces(plan, source.state, lesson);
  lesson.rest = stepped(source.sequence ? carried.rest() : carried.in(*source.state.pose));
  addPlaces(plan, carried.rest(), lesson);
  if (source.sequence) {
    const MotionSamples samples =
        sampleMotion(plan.rates, carried.weights(), carried.carriersAt(), kBetweenSamplesMm, progress);
    progress.report(kSampled, "motion");
    const SampledMotion motion = motionOf(samples, carried.weights(), kModesMm, progress, threads);
    addMotion(samples, motion, source, lesson);
    lesson.largestErrorMm = largestError(lesson, samples, motion, carried);
    if (plan.strain)
      runPart(progress, kStrainFrom, 1,
              [&](Progress& part) { addStrain(source, organs, samples, lesson, part, threads); });
  }
  addCurves(lesson, threads);
  progress.throwIfCancelled();
  addHandles(lesson, carried, source, progress, threads);
  if (plan.cut)
    lesson.tissue = tissueOf(lesson, source, progress, threads);
  if (plan.conduction)
    lesson.conduction = conductionOf(lesson, source, progress, threads);
  progress.report(1);
  return lesson;
}

} // namespace viscera::lesson
