#pragma once

#include <array>
#include <filesystem>
#include <optional>
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

/// Points beside a lesson's surfaces that go along with some of their vertices: a point is off its place at
/// rest by a weighted mean of what four vertices are off theirs.
struct CarriedParts {
  static constexpr int kCarriers = 4;
  Points rest; ///< `n x 3` mm, LPS.
  Eigen::Matrix<std::int32_t, Eigen::Dynamic, kCarriers, Eigen::RowMajor> vertices;
  Table weights; ///< `n x 4`, multiples of `kCarriedStep`; the sum of a row is 1.
};

/// The walls of a heart that can be cut open, as one closed surface: its outer surface but for some triangles
/// of that, and what lies inside.
struct LessonTissue {
  std::size_t surface = 0;           ///< The outer one, among the lesson's.
  std::vector<std::size_t> chambers; ///< The cavities in it.
  Vec3 face = Vec3::Ones();          ///< Of the walls where they are cut; red green blue, 0 to 1.
  std::vector<std::int32_t> left;    ///< Its triangles that do not belong to the walls, ascending from 0.
  CarriedParts inner;                ///< The walls' other vertices.
  Colors colors;                     ///< `inner x 3`.
  Triangles triangles;               ///< The walls' others, over the lesson's vertices, then `inner`.
};

/// A way of a heart's conduction system, as a range of the points that are carried.
struct LessonWay {
  Eigen::Index first = 0;
  Eigen::Index count = 0;
  double widthMm = 1;            ///< The radius that it is drawn with.
  std::vector<double> reachedMs; ///< `count`, ascending.
};

/// How the excitation goes along the ways in the beat of one rate.
struct LessonExcitation {
  double begins = 0; ///< The fraction of the cycle at which the sinus node fires.
  /// Fractions of the cycle after that, ascending from 0 to 1, and how far the excitation is then, ms in the
  /// time of the ways; linear in between.
  std::vector<std::array<double, 2>> marks;
  std::vector<double> ecgMv; ///< `kEcgSamples` over the cycle, from fraction 0.
};

struct LessonConduction {
  CarriedParts points;
  std::vector<LessonWay> ways;
  std::vector<LessonExcitation> beats; ///< One a rate.
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
  Table weights;                              ///< `handles x vertices`: how far a vertex goes with a handle.
  std::optional<LessonTissue> tissue;         ///< Where the plan has a cut.
  std::optional<LessonConduction> conduction; ///< Where it has conduction.
  double largestErrorMm = 0; ///< Of a vertex at any rate, at and between samples, as the page computes it.

  Eigen::Index vertexCount() const { return colors.rows(); }
  /// The instants of all courses.
  std::size_t instants() const;
};

/// How finely curves of volumes are drawn: instants spread evenly over the cycle.
inline constexpr Eigen::Index kCurveSamples = 96;

/// Samples of the electrocardiogram over a cycle.
inline constexpr Eigen::Index kEcgSamples = 192;

/// Steps to which a lesson's numbers are rounded.
inline constexpr double kStepMm = 0.01;
inline constexpr double kWeightStep = 1.0 / 1024;
inline constexpr double kInnerStepMm = 0.05;      ///< Places of `CarriedParts`,
inline constexpr double kCarriedStep = 1.0 / 128; ///< and their weights.
inline constexpr double kEcgStepMv = 0.01;

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
