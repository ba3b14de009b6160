#include "page_json.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "mesh_differences.h"
#include "page_strings.h"

namespace viscera::lesson {
namespace {

using nlohmann::ordered_json;

constexpr int kVersion = 2;
constexpr double kStrainRange = 30;      ///< Per cent at the ends of the bull's eye's colours.
constexpr double kShownOfDiagonal = 0.4; ///< The radius of what the page shows.

double threeDecimals(double value) {
  return std::round(value * 1000) / 1000;
}

ordered_json jsonOf(const Vec3& place) {
  return {threeDecimals(place.x()), threeDecimals(place.y()), threeDecimals(place.z())};
}

ordered_json jsonOf(const PackedArray& array) {
  return {{"at", array.at},
          {"count", array.count},
          {"width", array.width},
          {"stride", array.stride},
          {"step", array.step}};
}

template <class Matrix>
std::vector<typename Matrix::Scalar> inOrder(const Matrix& rowMajor) {
  return {rowMajor.data(), rowMajor.data() + rowMajor.size()};
}

ordered_json surfaceJson(const PlannedSurface& planned, const LessonSurface& surface) {
  ordered_json json = {{"title", planned.title},
                       {"color", jsonOf(planned.color)},
                       {"opacity", planned.opacity},
                       {"wall", planned.wall},
                       {"charted", planned.charted},
                       {"ejects", planned.ejects},
                       {"output", planned.output},
                       {"closed", surface.closed},
                       {"firstVertex", surface.firstVertex},
                       {"vertexCount", surface.vertexCount},
                       {"firstTriangle", surface.firstTriangle},
                       {"triangleCount", surface.triangleCount},
                       {"restMl", threeDecimals(surface.restMl)},
                       {"curves", ordered_json::array()},
                       {"anchors", surface.anchors},
                       {"labels", ordered_json::array()}};
  for (const auto& curve : surface.curves.rowwise()) {
    std::vector<double> milliliters;
    for (const double ml : curve)
      milliliters.push_back(threeDecimals(ml));
    json["curves"].push_back(std::move(milliliters));
  }
  for (std::size_t i = 0; i < planned.labels.size(); ++i) {
    ordered_json label = {{"text", planned.labels[i].text}, {"vertex", surface.labels[i]}};
    if (planned.labels[i].ringMm > 0)
      label["ring"] = threeDecimals(planned.labels[i].ringMm);
    json["labels"].push_back(std::move(label));
  }
  return json;
}

ordered_json motionJson(const Lesson& lesson) {
  if (lesson.courses.empty())
    return nullptr;
  const LessonPlan& plan = lesson.plan;
  ordered_json phases = ordered_json::array();
  for (const auto& atRate : lesson.phases) {
    ordered_json list = ordered_json::array();
    for (const sequences::Phase& phase : atRate)
      list.push_back({phase.name.english(), threeDecimals(phase.begin), threeDecimals(phase.end)});
    phases.push_back(std::move(list));
  }
  ordered_json instants = ordered_json::array();
  for (const Course& course : lesson.courses)
    instants.push_back(course.instants);
  const auto rate = std::find(plan.rates.begin(), plan.rates.end(), plan.rate) - plan.rates.begin();
  return {{"modes", lesson.modes.size()},
          {"instants", std::move(instants)},
          {"cycles", lesson.end == CourseEnd::cycles},
          {"rates", plan.rates},
          {"rate", rate},
          {"courses", lesson.courseOfRate},
          {"phases", std::move(phases)}};
}

/// Numbers to a tenth of a per cent; null where there is none.
ordered_json strainJson(const Lesson& lesson, const PageWords& words) {
  ordered_json json = {{"title", words.named("Longitudinal strain")}, {"range", kStrainRange}};
  for (const LessonSector& sector : lesson.sectors)
    json["sectors"].push_back({sector.ring, sector.fromDegrees, sector.toDegrees});
  for (const LessonStrain& strain : lesson.strain) {
    ordered_json course;
    for (std::size_t i = 0; i < strain.fractions.size(); ++i) {
      course["at"].push_back(threeDecimals(strain.fractions[i]));
      ordered_json values = ordered_json::array();
      for (const double value : strain.percent.row(static_cast<Eigen::Index>(i)))
        values.push_back(std::isfinite(value) ? ordered_json(std::round(10 * value) / 10)
                                              : ordered_json(nullptr));
      course["percent"].push_back(std::move(values));
    }
    json["courses"].push_back(std::move(course));
  }
  return json;
}

/// The first vertex of an organ that the lesson shows, or -1.
Eigen::Index firstVertexOf(const Lesson& lesson, document::OrganId organ) {
  for (std::size_t i = 0; i < lesson.surfaces.size(); ++i)
    if (lesson.plan.surfaces[i].organ == organ)
      return lesson.surfaces[i].firstVertex;
  return -1;
}

ordered_json measurementJson(const Lesson& lesson, const PlannedMeasurement& planned) {
  ordered_json points = ordered_json::array();
  for (const document::MeasuredPoint& point : planned.measurement.points) {
    const Eigen::Index first = firstVertexOf(lesson, point.organ);
    if (first < 0 || point.triangle < 0) {
      points.push_back(ordered_json{{"at", jsonOf(point.rest)}});
      continue;
    }
    Eigen::Index triangle = point.triangle;
    for (const LessonSurface& surface : lesson.surfaces)
      if (surface.firstVertex == first)
        triangle += surface.firstTriangle;
    const auto corners = lesson.triangles.row(triangle);
    points.push_back({{"vertices", {corners[0], corners[1], corners[2]}},
                      {"weights", {point.weights.x(), point.weights.y(), point.weights.z()}}});
  }
  return {{"title", planned.title},
          {"kind", document::nameOf(planned.measurement.kind)},
          {"points", std::move(points)}};
}

/// The middle of a phase at a rate of the plan, as a fraction of the cycle.
double middleOf(const Lesson& lesson, std::size_t rate, const std::string& phase) {
  std::string title = phase;
  for (const PlannedPhase& planned : lesson.plan.phases)
    if (planned.name == phase)
      title = planned.title;
  for (const sequences::Phase& each : lesson.phases[rate])
    if (each.name == title)
      return (each.begin + each.end) / 2;
  return 0;
}

std::size_t nearestRate(const std::vector<double>& rates, double wanted) {
  return static_cast<std::size_t>(
      std::min_element(rates.begin(), rates.end(),
                       [&](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); }) -
      rates.begin());
}

ordered_json cutJson(const PlannedCut& cut) {
  return {
      {"origin", jsonOf(cut.origin)}, {"normal", jsonOf(cut.normal)}, {"on", cut.on}, {"blood", cut.blood}};
}

ordered_json slideJson(const Lesson& lesson, const PlannedSlide& slide) {
  ordered_json json = {{"title", slide.title},
                       {"text", slide.text},
                       {"handles", slide.handles},
                       {"hidden", slide.hiddenSurfaces}};
  if (slide.names)
    json["names"] = *slide.names;
  if (!slide.side.empty())
    json["side"] = slide.side;
  if (slide.eye) {
    json["position"] = jsonOf(slide.eye->position);
    json["focus"] = jsonOf(slide.eye->focus);
  }
  if (slide.cut && lesson.tissue)
    json["cut"] = cutJson(*slide.cut);
  if (slide.seeThrough)
    json["seeThrough"] = *slide.seeThrough;
  if (lesson.courses.empty())
    return json;
  const std::size_t rate = nearestRate(lesson.plan.rates, slide.rate.value_or(lesson.plan.rate));
  if (slide.rate)
    json["rate"] = rate;
  if (!slide.phase.empty())
    json["fraction"] = threeDecimals(middleOf(lesson, rate, slide.phase));
  if (slide.fraction)
    json["fraction"] = threeDecimals(*slide.fraction);
  return json;
}

ordered_json conductionJson(const Lesson& lesson) {
  const LessonConduction& conduction = *lesson.conduction;
  ordered_json ways = ordered_json::array(), beats = ordered_json::array();
  for (const LessonWay& way : conduction.ways)
    ways.push_back(
        {{"first", way.first}, {"count", way.count}, {"width", way.widthMm}, {"reached", way.reachedMs}});
  for (const LessonExcitation& beat : conduction.beats) {
    ordered_json marks = ordered_json::array();
    for (const auto& [fraction, ms] : beat.marks)
      marks.push_back({fraction, threeDecimals(ms)});
    beats.push_back({{"begins", beat.begins}, {"marks", std::move(marks)}});
  }
  return {{"on", lesson.plan.conduction->on}, {"ways", std::move(ways)}, {"beats", std::move(beats)}};
}

/// Carried points: those of the tissue, then those of the conduction system.
void addCarried(const Lesson& lesson, ArrayPacker& packer, ordered_json& arrays) {
  std::vector<double> rest, weights, ecg;
  std::vector<std::int32_t> vertices;
  const auto add = [&](const CarriedParts& parts) {
    rest.insert(rest.end(), parts.rest.data(), parts.rest.data() + parts.rest.size());
    vertices.insert(vertices.end(), parts.vertices.data(), parts.vertices.data() + parts.vertices.size());
    for (const auto& row : parts.weights.rowwise()) // The last is what is left of 1.
      weights.insert(weights.end(), row.begin(), row.end() - 1);
  };
  if (lesson.tissue)
    add(lesson.tissue->inner);
  if (lesson.conduction) {
    add(lesson.conduction->points);
    for (const LessonExcitation& beat : lesson.conduction->beats)
      ecg.insert(ecg.end(), beat.ecgMv.begin(), beat.ecgMv.end());
    arrays["ecg"] = jsonOf(packer.add(ecg, 1, kEcgStepMv));
  }
  arrays["inner"] = jsonOf(packer.add(rest, 3, kInnerStepMm));
  arrays["carriers"] = jsonOf(packer.add(vertices, CarriedParts::kCarriers));
  arrays["carried"] = jsonOf(packer.add(weights, CarriedParts::kCarriers - 1, kCarriedStep));
  if (!lesson.tissue)
    return;
  const LessonTissue& tissue = *lesson.tissue;
  const std::vector<std::int32_t> colors(tissue.colors.data(), tissue.colors.data() + tissue.colors.size());
  arrays["innerColors"] = jsonOf(packer.add(colors, 3));
  arrays["innerTriangles"] = jsonOf(packer.add(inOrder(tissue.triangles), 3));
  arrays["left"] = jsonOf(packer.add(tissue.left, 1));
}

/// Fields over all vertices, or over the first of them.
ordered_json overMesh(const Lesson& lesson, Eigen::Index vertices, int components,
                      const std::vector<double>& fields, double step, ArrayPacker& packer) {
  const std::vector<std::int32_t> differences =
      MeshDifferences(lesson.triangles, vertices).of(wholeSteps(fields, step), components);
  PackedArray array = packer.add(differences, static_cast<int>(differences.size())); // As they are.
  array.step = step;
  return jsonOf(array);
}

ordered_json arraysJson(const Lesson& lesson, ArrayPacker& packer) {
  ordered_json arrays;
  arrays["rest"] = jsonOf(packer.add(inOrder(lesson.rest), 3, kStepMm));
  if (!lesson.courses.empty()) {
    std::vector<double> modes;
    std::vector<float> courses;
    for (const Points& mode : lesson.modes)
      modes.insert(modes.end(), mode.data(), mode.data() + mode.size());
    for (const Course& course : lesson.courses)
      for (Eigen::Index i = 0; i < course.values.rows(); ++i)
        for (const Table* table : {&course.values, &course.slopes})
          for (const double value : table->row(i))
            courses.push_back(static_cast<float>(value));
    arrays["motion"] = overMesh(lesson, lesson.rest.rows(), 3, modes, kStepMm, packer);
    arrays["course"] = jsonOf(packer.addFloats(courses));
  }
  arrays["triangles"] = jsonOf(packer.add(inOrder(lesson.triangles), 3));
  std::vector<std::int32_t> colors(lesson.colors.data(), lesson.colors.data() + lesson.colors.size());
  arrays["colors"] = jsonOf(packer.add(colors, 3));
  if (!lesson.handleLabels.empty())
    arrays["weights"] =
        overMesh(lesson, lesson.vertexCount(), 1, inOrder(lesson.weights), kWeightStep, packer);
  if (lesson.tissue || lesson.conduction)
    addCarried(lesson, packer, arrays);
  return arrays;
}

/// JSON that can stand in a script element.
std::string scriptSafe(const ordered_json& json) {
  std::string safe;
  for (const char c : json.dump(-1, ' ', true, ordered_json::error_handler_t::replace)) {
    static constexpr std::array<std::pair<char, const char*>, 3> kEscapes = {
        {{'<', "\\u003c"}, {'>', "\\u003e"}, {'&', "\\u0026"}}};
    const auto* found =
        std::find_if(kEscapes.begin(), kEscapes.end(), [c](const auto& e) { return e.first == c; });
    if (found == kEscapes.end())
      safe += c;
    else
      safe += found->second;
  }
  return safe;
}

} // namespace

std::string pageJson(const Lesson& lesson, ArrayPacker& packer) {
  const LessonPlan& plan = lesson.plan;
  const PageWords words(plan.language);
  const Bounds bounds = boundsOf(lesson.rest.topRows(lesson.vertexCount()));
  ordered_json json = {{"format", "viscera-lesson"},
                       {"version", kVersion},
                       {"language", words.said(kLanguageCode)},
                       {"title", plan.title},
                       {"notes", plan.notes},
                       {"strings", words.pageStrings()},
                       {"vertices", lesson.vertexCount()},
                       {"center", jsonOf(bounds.center())},
                       {"radius", threeDecimals(bounds.diagonal() * kShownOfDiagonal)},
                       {"handles", lesson.handleLabels}};
  for (const char* key : {"surfaces", "ranges", "measurements", "slides"})
    json[key] = ordered_json::array();
  for (std::size_t i = 0; i < lesson.surfaces.size(); ++i)
    json["surfaces"].push_back(surfaceJson(plan.surfaces[i], lesson.surfaces[i]));
  for (const PlannedRange& range : plan.ranges)
    json["ranges"].push_back({{"surface", range.surface},
                              {"kind", range.kind},
                              {"low", threeDecimals(range.low)},
                              {"high", threeDecimals(range.high)},
                              {"text", range.text}});
  for (const PlannedMeasurement& planned : plan.measurements)
    json["measurements"].push_back(measurementJson(lesson, planned));
  for (const PlannedSlide& slide : plan.slides)
    json["slides"].push_back(slideJson(lesson, slide));
  if (plan.eye)
    json["eye"] = {{"position", jsonOf(plan.eye->position)}, {"focus", jsonOf(plan.eye->focus)}};
  json["motion"] = motionJson(lesson);
  if (!lesson.strain.empty())
    json["strain"] = strainJson(lesson, words);
  if (lesson.tissue)
    json["tissue"] = {{"surface", lesson.tissue->surface},
                      {"chambers", lesson.tissue->chambers},
                      {"face", jsonOf(lesson.tissue->face)},
                      {"vertices", lesson.tissue->inner.rest.rows()},
                      {"cut", cutJson(*plan.cut)}};
  if (lesson.conduction)
    json["conduction"] = conductionJson(lesson);
  json["arrays"] = arraysJson(lesson, packer);
  return scriptSafe(json);
}

} // namespace viscera::lesson
