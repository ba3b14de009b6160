#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/lesson/course.h"
#include "viscera/lesson/lesson_plan.h"
#include "viscera/live/posed_organs.h"

/// Makes lessons: organs in motion as one file that opens in a browser without this program.
namespace viscera::lesson {

/// An organ of a lesson, as a range of its vertices and triangles.
struct LessonSurface {
  Eigen::Index firstVertex = 0;
  Eigen::Index vertexCount = 0;
  Eigen::Index firstTriangle = 0;
  Eigen::Index triangleCount = 0;
  bool closed = false;
  double restMl = 0;
  Table curves;             ///< `courses x kCurveSamples`, ml; empty when it is not closed.
  std::vector<int> anchors; ///< Vertices spread over it, for the line of its name.
  std::vector<int> labels;  ///< The vertex of each of the plan's labels.
};

/// A sector of the bull's eye of the left ventricle's segments.
struct LessonSector {
  int ring = 0;                            ///< 0 is the outermost of four.
  double fromDegrees = 0, toDegrees = 360; ///< Anticlockwise from the right.
};

/// The longitudinal strain of the segments over one course.
struct LessonStrain {
  std::vector<double> fractions; ///< Of the cycle, ascending.
  Table percent;                 ///< `fractions x segments`; NaN where a segment has too few points.
};

/// All data of a lesson: vertices, triangles, motion and curves. Vertices of all surfaces lie one behind the
/// other, then the handles' places.
struct Lesson {
  LessonPlan plan;
  Points rest;         ///< `(vertices + handles) x 3` mm, LPS.
  Triangles triangles; ///< Over all vertices.
  Colors colors;       ///< `vertices x 3`.
  std::vector<LessonSurface> surfaces;
  std::vector<Points> modes; ///< As `rest`; mm.
  CourseEnd end = CourseEnd::cycles;
  std::vector<Course> courses;                       ///< Of the modes; the rates share some.
  std::vector<int> courseOfRate;                     ///< One for each rate.
  std::vector<std::vector<sequences::Phase>> phases; ///< One list a rate, with the names that the plan gives.
  std::vector<LessonSector> sectors;                 ///< Of the segments; empty without strain.
  std::vector<LessonStrain> strain;                  ///< One a course; empty without.
  std::vector<std::string> handleLabels;
  Table weights;             ///< `handles x vertices`: how far a vertex goes with a handle.
  double largestErrorMm = 0; ///< Of a vertex at any rate, at and between samples, as the page computes it.

  Eigen::Index vertexCount() const { return colors.rows(); }
  /// Of all courses.
  std::size_t instants() const;
};

/// How finely curves of volumes are drawn: instants spread evenly over the cycle.
inline constexpr Eigen::Index kCurveSamples = 96;

/// Steps to which a lesson's numbers are rounded.
inline constexpr double kStepMm = 0.01;
inline constexpr double kWeightStep = 1.0 / 1024;

/// Makes a lesson: samples the motion at the plan's rates until cubic pieces between the samples reproduce
/// it, finds its modes, and the weights of the handles to drag. `organs` are those of `source.state`, bound;
/// they are moved to keep volumes, and are in an arbitrary pose afterwards. Some seconds. Throws `DataError`
/// for volumes that cannot be kept and for an organ that is still being bound; where the plan
/// wants strain, what `live::readStrain` throws and `UsageError` for coordinates of a plugin; `Cancelled`.
/// For the thread of the organs.
Lesson makeLesson(const LessonPlan& plan, const LessonSource& source, live::PosedOrgans& organs,
                  Progress& progress, Threads threads = {});

/// The page, complete (docs/lessons.md).
std::string pageOf(const Lesson& lesson);
/// Writes the page to a file. Atomic. Throws `CannotCreateError`.
void writePage(const std::filesystem::path& file, const Lesson& lesson);

} // namespace viscera::lesson
