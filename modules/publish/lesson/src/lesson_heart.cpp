#include "lesson_heart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "carried_parts.h"
#include "viscera/circulation/signs.h"
#include "viscera/heart/beating_heart.h"

namespace viscera::lesson {
namespace {

/// A face is a little paler than the surface, as cut flesh is.
constexpr double kPaler = 0.25;

using Index = Eigen::Index;
using Place = std::array<double, 3>;
using Corners = std::array<std::int32_t, 3>;

Place placeOf(const Points& points, Index row) {
  return {points(row, 0), points(row, 1), points(row, 2)};
}

/// The corners of a triangle, the lowest first, in their order around it.
Corners turned(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::size_t surfaceOf(const Lesson& lesson, document::OrganId organ) {
  const auto& planned = lesson.plan.surfaces;
  return static_cast<std::size_t>(
      std::find_if(planned.begin(), planned.end(), [&](const auto& each) { return each.organ == organ; }) -
      planned.begin());
}

/// The lesson's surfaces of a heart, which carry what is in it.
void addCarriers(const live::SampleHeartOrgans& heart, const Lesson& lesson, PartsToCarry& parts) {
  const auto add = [&](const document::Organ& organ) {
    if (const std::size_t surface = surfaceOf(lesson, organ.id); surface < lesson.surfaces.size()) {
      parts.surfaces.push_back(surface);
      parts.meshes.push_back(&organ.mesh->points);
    }
  };
  add(*heart.outer);
  for (const auto& cavity : heart.cavities)
    add(*cavity);
}

/// The vertices of the tissue: those that are the outer surface's keep their number in the lesson; the others
/// are counted on behind it.
struct Numbered {
  std::vector<std::int32_t> number;
  std::vector<Index> inner; ///< The others.
};

Numbered numbered(const geometry::TriangleMesh& tissue, const Points& outer, const Lesson& lesson,
                  Index firstVertex) {
  std::map<Place, Index> places;
  for (Index i = 0; i < outer.rows(); ++i)
    places.emplace(placeOf(outer, i), i);
  Numbered vertices;
  for (Index i = 0; i < tissue.points.rows(); ++i) {
    const auto found = places.find(placeOf(tissue.points, i));
    const Index number = found != places.end()
                             ? firstVertex + found->second
                             : lesson.vertexCount() + static_cast<Index>(vertices.inner.size());
    if (found == places.end())
      vertices.inner.push_back(i);
    vertices.number.push_back(static_cast<std::int32_t>(number));
  }
  return vertices;
}

/// Parts the tissue's triangles in those of the outer surface and others.
void addTriangles(const geometry::TriangleMesh& tissue, const Numbered& vertices, const Lesson& lesson,
                  LessonTissue& made) {
  const LessonSurface& outer = lesson.surfaces[made.surface];
  std::set<Corners> all;
  for (Index t = 0; t < tissue.triangles.rows(); ++t) {
    Corners corners;
    for (int i = 0; i < 3; ++i)
      corners[static_cast<std::size_t>(i)] =
          vertices.number[static_cast<std::size_t>(tissue.triangles(t, i))];
    all.insert(turned(corners));
  }
  for (Index t = 0; t < outer.triangleCount; ++t) {
    const auto row = lesson.triangles.row(outer.firstTriangle + t);
    if (all.erase(turned({row[0], row[1], row[2]})) == 0)
      made.left.push_back(static_cast<std::int32_t>(t));
  }
  made.triangles.resize(static_cast<Index>(all.size()), 3);
  Index next = 0;
  for (const Corners& corners : all)
    made.triangles.row(next++) << corners[0], corners[1], corners[2];
}

/// The fat between the atria as part of the tissue: a closed surface of its own that reaches into the walls,
/// so that the face of a cut has no gap there. Its vertices follow the others.
void addSeptum(const geometry::TriangleMesh& septum, const Lesson& lesson, PartsToCarry& parts,
               LessonTissue& made) {
  const Index points = parts.rest.rows(), triangles = made.triangles.rows();
  parts.rest.conservativeResize(points + septum.points.rows(), 3);
  parts.rest.bottomRows(septum.points.rows()) = septum.points;
  made.colors.conservativeResize(parts.rest.rows(), 3);
  if (septum.colors.rows() > 0)
    made.colors.bottomRows(septum.points.rows()) = septum.colors;
  else
    made.colors.bottomRows(septum.points.rows()).setConstant(std::numeric_limits<std::uint8_t>::max());
  made.triangles.conservativeResize(triangles + septum.triangles.rows(), 3);
  made.triangles.bottomRows(septum.triangles.rows()) =
      septum.triangles.array() + static_cast<Triangles::Scalar>(lesson.vertexCount() + points);
}

/// The excitation and the electrocardiogram of the beat at a rate.
LessonExcitation excitationOf(const sequences::Sequence& sequence, double rate) {
  LessonExcitation made;
  const auto clock = heart::clockAt(sequence, 0, rate);
  if (!clock || !(clock->ratePerMinute > 0))
    return made;
  circulation::Parameters parameters;
  parameters.rate = clock->ratePerMinute;
  parameters.conduction = clock->conduction;
  const double period = 60 / clock->ratePerMinute;
  const circulation::Excitation at = circulation::excitationOf(parameters);
  const double begins = (at.sinusNode - clock->seconds) / period;
  made.begins = begins - std::floor(begins);
  // The same marks as those of `excitationMs`, which is linear between them; one more before the next beat.
  constexpr double kJustBefore = 1 - 1e-9, kMostAtria = 0.8;
  const double toQ = at.ventriclesBegin - at.sinusNode;
  for (const double seconds : {0.0, std::min(at.atriaDone - at.sinusNode, kMostAtria * toQ), toQ,
                               at.ventriclesDone - at.sinusNode, kJustBefore * period})
    made.marks.push_back(
        {seconds / period, circulation::excitationMs(
                               parameters, at.sinusNode + std::max(seconds, (1 - kJustBefore) * period))});
  for (Index i = 0; i < kEcgSamples; ++i)
    made.ecgMv.push_back(circulation::electrocardiogram(
        parameters, clock->seconds + period * static_cast<double>(i) / static_cast<double>(kEcgSamples)));
  return made;
}

} // namespace

LessonTissue tissueOf(const Lesson& lesson, const LessonSource& source, Progress& progress, Threads threads) {
  const auto heart = live::sampleHeartIn(source.state).value();
  const geometry::TriangleMesh& tissue = *source.tissue->mesh();
  LessonTissue made;
  made.surface = surfaceOf(lesson, heart.outer->id);
  const Numbered vertices =
      numbered(tissue, heart.outer->mesh->points, lesson, lesson.surfaces[made.surface].firstVertex);
  addTriangles(tissue, vertices, lesson, made);
  const auto count = static_cast<Index>(vertices.inner.size());
  PartsToCarry parts;
  parts.rest.resize(count, 3);
  made.colors.resize(count, 3);
  const PlannedSurface& outer = lesson.plan.surfaces[made.surface];
  const Eigen::Matrix<std::uint8_t, 1, 3> uniform =
      (outer.color * 255).array().round().cast<std::uint8_t>().matrix().transpose();
  for (Index i = 0; i < count; ++i) {
    const Index row = vertices.inner[static_cast<std::size_t>(i)];
    parts.rest.row(i) = tissue.points.row(row);
    if (outer.vertexColors && tissue.colors.rows() > 0)
      made.colors.row(i) = tissue.colors.row(row);
    else
      made.colors.row(i) = uniform;
  }
  if (const auto& septum = source.tissue->septum())
    addSeptum(*septum, lesson, parts, made);
  addCarriers(heart, lesson, parts);
  made.chambers.assign(parts.surfaces.begin() + 1, parts.surfaces.end());
  made.face = (1 - kPaler) * heart.outer->look.color + kPaler * Vec3::Ones();
  made.inner = carriedParts(parts, lesson, progress, threads);
  return made;
}

LessonConduction conductionOf(const Lesson& lesson, const LessonSource& source, Progress& progress,
                              Threads threads) {
  LessonConduction made;
  made.points.rest.resize(0, 3);
  for (std::size_t surface = 0; surface < lesson.surfaces.size(); ++surface) {
    const auto organ = source.state.organ(lesson.plan.surfaces[surface].organ);
    if (organ->ways.empty())
      continue;
    PartsToCarry parts;
    parts.rest.resize(0, 3);
    for (const geometry::NamedWay& way : organ->ways) {
      const Index before = parts.rest.rows();
      LessonWay own{made.points.rest.rows() + before, way.points.rows(), way.widthMm, {}};
      own.reachedMs.assign(way.reachedMs.data(), way.reachedMs.data() + way.reachedMs.size());
      made.ways.push_back(std::move(own));
      parts.rest.conservativeResize(before + way.points.rows(), 3);
      parts.rest.bottomRows(way.points.rows()) = way.points;
    }
    parts.surfaces = {surface};
    parts.meshes = {&organ->mesh->points};
    const CarriedParts own = carriedParts(parts, lesson, progress, threads);
    const Index before = made.points.rest.rows(), all = before + own.rest.rows();
    made.points.rest.conservativeResize(all, 3);
    made.points.vertices.conservativeResize(all, CarriedParts::kCarriers);
    made.points.weights.conservativeResize(all, CarriedParts::kCarriers);
    made.points.rest.bottomRows(own.rest.rows()) = own.rest;
    made.points.vertices.bottomRows(own.rest.rows()) = own.vertices;
    made.points.weights.bottomRows(own.rest.rows()) = own.weights;
  }
  for (const double rate : lesson.plan.rates)
    made.beats.push_back(excitationOf(*source.sequence, rate));
  return made;
}

} // namespace viscera::lesson
