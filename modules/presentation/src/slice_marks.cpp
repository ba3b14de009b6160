#include "slice_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "handle_picture.h"
#include "viscera/presentation/presenter.h"

namespace viscera::presentation {
namespace {

/// A handle that is nearer to the plane is drawn on the slice, mm.
constexpr double kHandleReach = 5;
/// The same of a measured point, where voxels are finer.
constexpr double kMeasureReach = 0.5;
/// Logical pixels: as in the 3D view, and of a handle that is just within reach of the plane.
constexpr double kHandleMarkRadius = 6, kActiveMarkRadius = 8, kFarMarkRadius = 3.5;
constexpr double kRim = 1, kSelectedRim = 2.5;
constexpr double kPointRadius = 3;
constexpr int kCircleSteps = 72;
const Vec3 kMeasured(1.0, 0.86, 0.35);
const Vec3 kDark(0.08, 0.08, 0.08);

/// Everything that one slice's marks are made with.
struct Sheet {
  const SliceScene& scene;
  const medical_io::SliceFrame& frame;
  const MarkedPlane& plane;
  scene::SlicePicture& picture;
  SliceGrips& grips;

  double height(const Vec3& place) const { return plane.normal.dot(place - frame.corner); }
  double slab() const { return scene.view.scan.slabMm; }
};

void addHandles(Sheet& sheet) {
  const ViewState& view = sheet.scene.view;
  const document::Rig& rig = *sheet.scene.state.rig;
  if (!view.shown.handles && !view.handles)
    return;
  const Points places = handlePlaces(sheet.scene.state, sheet.scene.organs);
  const Colors colors = handleColors(rig, view.shown.compensating);
  const double reach = std::max(kHandleReach, sheet.slab() / 2);
  const auto& selected = view.selection.handles;
  for (Eigen::Index row = 0; row < places.rows(); ++row) {
    const document::Handle& handle = rig.handles[static_cast<std::size_t>(row)];
    const double away = std::abs(sheet.height(places.row(row).transpose()));
    const bool active = row == sheet.scene.activeHandle;
    if (!handle.visible || (away > reach && !active))
      continue;
    const bool chosen = std::find(selected.begin(), selected.end(), handle.id) != selected.end();
    const Vec3 color = colors.row(row).transpose().cast<double>() / 255;
    const Eigen::Vector2d pixel = sheet.frame.pixelOf(places.row(row).transpose());
    const double radius =
        active ? kActiveMarkRadius
               : kHandleMarkRadius + (kFarMarkRadius - kHandleMarkRadius) * std::min(1.0, away / reach);
    sheet.picture.marks.push_back({pixel, radius, color, chosen ? Vec3(Vec3::Ones()) : Vec3(0.25 * color),
                                   chosen ? kSelectedRim : kRim});
    if (view.shown.movable && !handle.locked)
      sheet.grips.handles.push_back({static_cast<std::size_t>(row), 0, pixel});
  }
}

/// The outline of a measurement on a slice, and beside which place its label stands; no line when it is not
/// seen there.
struct Outline {
  std::vector<Vec3> line;
  bool closed = false;
  Vec3 label = Vec3::Zero();
};

Outline circleOf(const Sheet& sheet, const medical_io::SphereRegion& sphere) {
  const double height = sheet.height(sphere.center);
  const double square = sphere.radius * sphere.radius - height * height;
  Outline outline;
  if (!(square > 0))
    return outline;
  const double radius = std::sqrt(square);
  const Vec3 right = sheet.frame.right.normalized(), up = sheet.frame.up.normalized();
  outline.closed = true;
  for (int i = 0; i < kCircleSteps; ++i) {
    const double angle = 2 * M_PI * i / kCircleSteps;
    outline.line.push_back(sphere.center + radius * (std::cos(angle) * right + std::sin(angle) * up));
  }
  outline.label = outline.line.front();
  return outline;
}

/// `places` are where its points are now, as far as there are any.
Outline outlineOf(const Sheet& sheet, const document::Measurement& measurement,
                  const std::vector<Vec3>& places, double reach) {
  if (measurement.kind == document::MeasurementKind::sphere && places.size() == 2)
    return circleOf(sheet, {places[0], (places[1] - places[0]).norm()});
  Outline outline;
  if (places.empty() || std::any_of(places.begin(), places.end(),
                                    [&](const Vec3& place) { return std::abs(sheet.height(place)) > reach; }))
    return outline;
  outline.line = places;
  if (measurement.kind == document::MeasurementKind::rectangle) {
    if (measurement.axis != sheet.plane.axis)
      return {};
    if (places.size() == 2) {
      const int along = (measurement.axis + 1) % 3;
      Vec3 a = places[0], b = places[1];
      std::swap(a[along], b[along]);
      outline.line = {places[0], a, places[1], b};
      outline.closed = true;
    }
  }
  outline.label =
      *std::max_element(outline.line.begin(), outline.line.end(), [&](const Vec3& a, const Vec3& b) {
        return sheet.frame.pixelOf(a).x() < sheet.frame.pixelOf(b).x();
      });
  return outline;
}

void draw(Sheet& sheet, const Outline& outline, const Vec3& color, std::string words) {
  scene::SliceLine line{{}, outline.closed, color, false};
  for (const Vec3& place : outline.line)
    line.points.push_back(sheet.frame.pixelOf(place));
  Eigen::AlignedBox2d around;
  for (const Eigen::Vector2d& point : line.points)
    around.extend(point);
  sheet.picture.lines.push_back(std::move(line));
  if (!words.empty())
    sheet.picture.texts.push_back({sheet.frame.pixelOf(outline.label), std::move(words), color,
                                   outline.closed ? around : Eigen::AlignedBox2d()});
}

/// Where the next item of a list ends; languages with decimal commas have semicolons between items.
std::size_t endOfItem(const std::string& list, std::size_t from) {
  return std::min(list.find(", ", from), list.find("; ", from));
}

/// Adds the points as marks. Only those of the document can be grabbed.
void markPoints(Sheet& sheet, const document::Measurement& measurement, const std::vector<Vec3>& places,
                double reach, const Vec3& color, std::optional<std::size_t> item) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (std::abs(sheet.height(places[i])) > reach)
      continue;
    const Eigen::Vector2d pixel = sheet.frame.pixelOf(places[i]);
    sheet.picture.marks.push_back({pixel, kPointRadius, color, kDark, kRim});
    if (item && !measurement.points[i].organ)
      sheet.grips.measured.push_back({*item, i, pixel});
  }
}

std::string wordsOf(const document::Measurement& measurement, const document::MeasuredValues& values,
                    const document::DocumentState& state, const SliceLanguage& language) {
  const std::string unit = document::unitOf(measurement, state);
  const bool region = document::isRegion(measurement.kind);
  std::string words =
      formatMeasured(measurement.kind, region ? values.rest : values.now, unit, language.decimalMark);
  if (!measurement.name.empty())
    words = measurement.name + ": " + words;
  std::string spread = describeSpread(measurement, values, unit, language.translate, language.decimalMark);
  // Values in one line, size in the next: a slice is not wide.
  if (const std::size_t size = endOfItem(spread, endOfItem(spread, 0) + 1); size != std::string::npos)
    spread.replace(size, 2, "\n");
  return spread.empty() ? words : words + '\n' + spread;
}

void addMeasured(Sheet& sheet, document::MeasuringMemory& memory, const SliceLanguage& language) {
  const SliceScene& scene = sheet.scene;
  std::vector<std::shared_ptr<const Points>> kept;
  const auto pointsOf = [&](document::OrganId organ) -> const Points& {
    return *kept.emplace_back(scene.organs.sharedPoints(organ));
  };
  const document::TissueMotion tissue =
      scene.warping && scene.view.scan.warped ? scene.warping->posed : document::TissueMotion();
  const double reach = std::max({kMeasureReach, sheet.slab() / 2, sheet.plane.stepMm / 2});
  const auto show = [&](const document::Measurement& measurement, bool highlighted,
                        std::optional<std::size_t> item) {
    const bool whole = measurement.points.size() == document::pointCount(measurement.kind);
    document::MeasuredValues values;
    if (whole)
      values = document::measure(measurement, scene.state, pointsOf, &memory, tissue);
    else
      values.places = document::placesNow(measurement, scene.state, pointsOf, tissue);
    const Outline outline = outlineOf(sheet, measurement, values.places, reach);
    if (outline.line.empty())
      return;
    const Vec3 color = highlighted ? scene::darkTheme().accent : kMeasured;
    draw(sheet, outline, color, whole ? wordsOf(measurement, values, scene.state, language) : std::string());
    markPoints(sheet, measurement, values.places, reach, color, item);
  };
  for (std::size_t i = 0; i < scene.state.measurements->size(); ++i) {
    const document::Measurement& measurement = (*scene.state.measurements)[i];
    const auto* now = scene.measuring;
    show(measurement, now && std::count(now->highlighted.begin(), now->highlighted.end(), measurement.id) > 0,
         i);
  }
  if (scene.measuring && !scene.measuring->pending.points.empty())
    show(scene.measuring->pending, true, std::nullopt);
}

} // namespace

SliceGrips addMarks(const SliceScene& scene, const MarkedPlane& plane, const medical_io::SliceFrame& frame,
                    document::MeasuringMemory& memory, const SliceLanguage& language,
                    scene::SlicePicture& picture) {
  SliceGrips grips;
  Sheet sheet{scene, frame, plane, picture, grips};
  picture.marks.clear();
  picture.texts.clear();
  addHandles(sheet);
  if (scene.view.measurements)
    addMeasured(sheet, memory, language);
  return grips;
}

const SliceGrips::Grip* nearestGrip(const std::vector<SliceGrips::Grip>& grips, const Eigen::Vector2d& pixel,
                                    double reach) {
  const SliceGrips::Grip* nearest = nullptr;
  for (const SliceGrips::Grip& grip : grips)
    if (const double away = (grip.pixel - pixel).norm(); away <= reach) {
      reach = away;
      nearest = &grip;
    }
  return nearest;
}

} // namespace viscera::presentation
