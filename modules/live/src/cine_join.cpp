#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "labelled_phases.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/live/cine_motion.h"
#include "viscera/live/contour_corrections.h"

namespace viscera::live {
namespace {

using medical_io::CineGeometry;
using medical_io::CineSlice;
using medical_io::CineStudy;

constexpr double kNearestSlicesMm = 4;     ///< Nearer ones tell the same again.
constexpr double kNearPlaneMm = 5;         ///< Tissue within it is taken as seen in the plane.
constexpr double kAroundMm = 45;           ///< Kept of pictures around the labels.
constexpr double kMostBesidePicture = 0.2; ///< Of a wall in a plane, outside its picture.
constexpr Eigen::Index kPointsOfVoxels = 4000;

// ---- phases -----------------------------------------------------------------------------------------------

/// The slice whose phases number those of the cycle: one that lacks none, with most of them.
const CineSlice& numberingSlice(const CineStudy& study) {
  const CineSlice* best = &study.slices.front();
  for (const CineSlice& slice : study.slices)
    if (slice.phasesInCycle() > best->phasesInCycle() ||
        (slice.phasesInCycle() == best->phasesInCycle() && slice.missing.size() < best->missing.size()))
      best = &slice;
  return *best;
}

double medianInterval(const CineStudy& study) {
  std::vector<double> intervals;
  for (const CineSlice& slice : study.slices)
    if (slice.interval > 0)
      intervals.push_back(slice.interval);
  if (intervals.empty())
    throw UsageError("The duration of one cycle is unknown", "images",
                     "give it with --period-ms, or the rate with --rate");
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

tracking::PhaseTimes timesOfStudy(const CineStudy& study, const CineRequest& request) {
  const CineSlice& slice = numberingSlice(study);
  const double period = request.periodSeconds ? *request.periodSeconds : medianInterval(study);
  if (!(period > 0) || !std::isfinite(period))
    throw UsageError("The period is not a positive time", "--period-ms", "as in --period-ms 829");
  tracking::PhaseTimes times = tracking::PhaseTimes::even(slice.phasesInCycle(), period);
  if (slice.missing.empty())
    for (std::size_t phase = 0; phase < times.count(); ++phase)
      times.seconds[phase] = slice.fractions[phase] * period;
  return times;
}

/// The labels in the order of the cycle. Throws for what the study has not.
std::vector<PhaseLabels> checkedLabels(const CineRequest& request, std::size_t phases) {
  if (request.labels.empty())
    throw UsageError(
        "No phase has labels", "--phase",
        "give those of the ends of diastole and systole, as in --phase 0=ed.nrrd --phase 9=es.nrrd");
  std::vector<PhaseLabels> labels = request.labels;
  std::stable_sort(labels.begin(), labels.end(),
                   [](const PhaseLabels& a, const PhaseLabels& b) { return a.phase < b.phase; });
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i].phase >= phases)
      throw UsageError(
          phrase("The images have no phase %1", labels[i].phase + request.firstPhase), "--phase",
          phrase("their phases are %1 to %2", request.firstPhase, phases - 1 + request.firstPhase));
    if (i > 0 && labels[i].phase == labels[i - 1].phase)
      throw UsageError(phrase("Phase %1 has labels twice", labels[i].phase + request.firstPhase), "--phase",
                       "name each phase once");
  }
  return labels;
}

// ---- labels -----------------------------------------------------------------------------------------------

/// Points of everything that is labelled in a phase.
void addPoints(const MotionSeries& labels, std::size_t phase, std::vector<Vec3>& points) {
  for (std::size_t i = 0; i < labels.names.size(); ++i) {
    if (labels.masks.empty()) {
      const Points& own = labels.meshes[phase][i]->points;
      for (Eigen::Index v = 0; v < own.rows(); ++v)
        points.emplace_back(own.row(v).transpose());
      continue;
    }
    const tracking::Mask& mask = labels.masks[phase][i];
    const auto step = std::max<std::int64_t>(1, mask.count() / kPointsOfVoxels);
    std::int64_t inside = 0;
    for (int c = 0; c < mask.size[2]; ++c)
      for (int b = 0; b < mask.size[1]; ++b)
        for (int a = 0; a < mask.size[0]; ++a)
          if (mask.inside[mask.indexOf(a, b, c)] != 0 && inside++ % step == 0)
            points.emplace_back(mask.indexToLps * Vec3(a, b, c));
  }
}

/// The triangles that fill a surface's openings: fans, whose middle has only vertices of one rim around it.
std::vector<Eigen::Index> capsOf(const geometry::TriangleMesh& mesh, const std::vector<tracking::Rim>& rims) {
  std::vector<Eigen::Index> caps;
  for (const tracking::Rim& rim : rims) {
    const std::set<std::int32_t> onRim(rim.begin(), rim.end());
    std::set<std::int32_t> middles, walls;
    const auto restOf = [&](Eigen::Index t) {
      std::vector<std::int32_t> rest;
      for (int k = 0; k < 3; ++k)
        if (!onRim.contains(mesh.triangles(t, k)))
          rest.push_back(mesh.triangles(t, k));
      return rest;
    };
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
      const auto rest = restOf(t);
      if (rest.size() == 1)
        middles.insert(rest.front());
      else
        walls.insert(rest.begin(), rest.end());
    }
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
      if (const auto rest = restOf(t);
          rest.size() == 1 && middles.contains(rest.front()) && !walls.contains(rest.front()))
        caps.push_back(t);
  }
  return caps;
}

/// Reads the labels, as surfaces that are fitted by distances.
void readLabels(const std::vector<PhaseLabels>& labels, const CineRequest& request, LabelledStudy& joined,
                Progress& progress) {
  std::vector<PhaseLabels> numbered = labels; // As texts call them.
  for (PhaseLabels& label : numbered)
    label.phase += request.firstPhase;
  MotionSeries& series = joined.labels = readLabelledPhases(numbered, request.surfaces, progress);
  for (const PhaseLabels& label : labels) {
    joined.phases.push_back(label.phase);
    series.times.seconds[joined.phases.size() - 1] = joined.times.seconds[label.phase];
  }
  series.times.periodSeconds = joined.times.periodSeconds;
  joined.caps.resize(series.names.size());
  if (!series.corresponding.empty()) {
    series.meshes.resize(labels.size());
    for (std::size_t i = 0; i < series.names.size(); ++i) {
      joined.caps[i] = tracking::capTriangles({series.corresponding[i]});
      for (std::size_t phase = 0; phase < labels.size(); ++phase)
        series.meshes[phase].push_back(
            std::make_shared<const geometry::TriangleMesh>(series.corresponding[i].at(phase)));
    }
    series.corresponding.clear();
  } else if (series.masks.empty()) {
    for (std::size_t i = 0; i < series.names.size(); ++i)
      joined.caps[i] = capsOf(*series.meshes[0][i], series.rims[0][i]);
  }
  joined.warnings.insert(joined.warnings.end(), series.warnings.begin(), series.warnings.end());
}

// ---- planes -----------------------------------------------------------------------------------------------

/// How much of what is labelled lies in a slice's plane, and how much of that outside its picture.
struct Crossing {
  bool crosses = false;
  double outside = 0;
};

Crossing crossingOf(const CineGeometry& place, const std::vector<Vec3>& points) {
  const Vec3 normal = place.normal();
  double least = 0, most = 0;
  int near = 0, out = 0;
  for (const Vec3& point : points) {
    const double aside = (point - place.origin).dot(normal);
    least = std::min(least, aside);
    most = std::max(most, aside);
    if (std::abs(aside) > std::max(kNearPlaneMm, place.thickness / 2))
      continue;
    const Eigen::Vector2d pixel = place.pixelOf(point);
    ++near;
    out += pixel[0] < 0 || pixel[1] < 0 || pixel[0] > place.columns - 1 || pixel[1] > place.rows - 1;
  }
  return {least < 0 && most > 0 && near > 0, near > 0 ? static_cast<double>(out) / near : 1};
}

/// The columns and rows of a picture that are near the labels.
struct PictureWindow {
  int column = 0, row = 0, columns = 0, rows = 0;
};

PictureWindow windowAround(const CineGeometry& place, const std::vector<Vec3>& points) {
  Eigen::Array2d low = place.pixelOf(points.front()).array(), high = low;
  for (const Vec3& point : points) {
    low = low.min(place.pixelOf(point).array());
    high = high.max(place.pixelOf(point).array());
  }
  const Eigen::Array2d margin(kAroundMm / place.betweenColumns, kAroundMm / place.betweenRows);
  const Eigen::Array2i from = (low - margin).floor().max(0).cast<int>();
  const Eigen::Array2i to =
      (high + margin).ceil().min(Eigen::Array2d(place.columns - 1, place.rows - 1)).cast<int>();
  return {from[0], from[1], to[0] - from[0] + 1, to[1] - from[1] + 1};
}

/// A slice as a plane; pixels that were not measured have the least value of their picture. Pictures whose
/// pixels are all alike show nothing: their phases are `empty`.
tracking::CinePlane planeOf(const CineSlice& slice, const std::string& name, const std::vector<Vec3>& points,
                            std::vector<Text>& empty, Progress& progress) {
  const CineGeometry& place = slice.geometry;
  const PictureWindow window = windowAround(place, points);
  tracking::CinePlane plane{name,
                            place.at(window.column, window.row),
                            place.row,
                            place.column,
                            {place.betweenColumns, place.betweenRows},
                            {},
                            {}};
  for (std::size_t phase = 0; phase < slice.fractions.size(); ++phase) {
    progress.throwIfCancelled();
    const auto picture = slice.image(phase);
    tracking::CineImage image =
        picture->block(window.row, window.column, window.rows, window.columns).array();
    if (!image.allFinite()) {
      const float least = image.isFinite().select(image, std::numeric_limits<float>::max()).minCoeff();
      image = image.isFinite().select(image, least < std::numeric_limits<float>::max() ? least : 0.0F);
    }
    if (image.minCoeff() == image.maxCoeff()) {
      empty.push_back(std::to_string(phase));
      continue;
    }
    plane.fractions.push_back(slice.fractions[phase]);
    plane.images.push_back(std::move(image));
  }
  return plane;
}

/// Slices of stacks that lie too near to the one kept before.
std::set<std::size_t> tooNear(const CineStudy& study) {
  std::set<std::size_t> left;
  for (const medical_io::CineStack& stack : study.stacks) {
    double since = 0;
    for (std::size_t i = 1; i < stack.slices.size(); ++i) {
      since += stack.distances[i - 1];
      if (since < kNearestSlicesMm)
        left.insert(stack.slices[i]);
      else
        since = 0;
    }
  }
  return left;
}

/// Whether points would cross the planes in the other axes.
bool crossesTurned(const CineStudy& study, std::vector<Vec3> points) {
  for (Vec3& point : points)
    point = Vec3(-point.x(), -point.y(), point.z());
  return std::any_of(study.slices.begin(), study.slices.end(), [&](const CineSlice& slice) {
    const Crossing crossing = crossingOf(slice.geometry, points);
    return crossing.crosses && crossing.outside < kMostBesidePicture;
  });
}

std::set<int> leftOutSeries(const CineStudy& study, const CineRequest& request) {
  std::set<int> left;
  for (const int number : request.leftOutSeries) {
    if (std::none_of(study.slices.begin(), study.slices.end(),
                     [&](const CineSlice& slice) { return slice.number == number; }))
      throw UsageError(phrase("The images have no series %1", number), "--leave-out-series",
                       "viscera info lists the series of a study");
    left.insert(number);
  }
  return left;
}

/// What tells a slice from the others.
Text planeName(const CineStudy& study, std::size_t index) {
  const CineSlice& slice = study.slices[index];
  const auto count = std::count_if(study.slices.begin(), study.slices.end(),
                                   [&](const CineSlice& each) { return each.number == slice.number; });
  const std::string view = nameOf(slice.plane);
  return count == 1 && slice.number > 0 ? phrase("series %1, %2", slice.number, named(view))
                                        : phrase("slice %1, %2", index, named(view));
}

/// The slices that show what is labelled, as planes.
void addPlanes(const CineStudy& study, const CineRequest& request, LabelledStudy& joined,
               Progress& progress) {
  const std::set<int> left = leftOutSeries(study, request);
  const std::set<std::size_t> near = tooNear(study);
  std::vector<Vec3> points;
  for (std::size_t phase = 0; phase < joined.phases.size(); ++phase)
    addPoints(joined.labels, phase, points);
  int beside = 0;
  for (std::size_t i = 0; i < study.slices.size(); ++i) {
    const CineSlice& slice = study.slices[i];
    progress.report(static_cast<double>(i) / static_cast<double>(study.slices.size()), "reading the images");
    if (left.contains(slice.number) || near.contains(i))
      continue;
    const Crossing crossing = crossingOf(slice.geometry, points);
    if (!crossing.crosses || crossing.outside >= 1) {
      ++beside;
      continue;
    }
    const Text name = planeName(study, i);
    if (crossing.outside > kMostBesidePicture)
      joined.warnings.push_back(phrase("%1 % of what is labelled in the plane of %2 lies outside its "
                                       "images",
                                       std::lround(100 * crossing.outside), name));
    std::vector<Text> empty;
    tracking::CinePlane plane = planeOf(slice, name.english(), points, empty, progress);
    if (!empty.empty()) {
      const std::size_t count = empty.size();
      joined.warnings.push_back(phrase("%n {picture|pictures} of %2 {is|are} empty and left out: %3", count,
                                       name, listOf(std::move(empty))));
    }
    if (plane.images.empty())
      continue;
    joined.planes.push_back(std::move(plane));
    joined.sources.push_back({i, slice.number, name, slice.plane});
  }
  if (joined.planes.empty())
    throw DataError(
        crossesTurned(study, points)
            ? "No image shows what is labelled: the labels seem to be in RAS where the images are in LPS"
            : "No image shows what is labelled: it lies beside all planes, or outside their pictures",
        "images", "take labels and images of one patient and one study, in the same axes");
  if (beside > 0)
    joined.warnings.push_back(
        phrase("%n {plane|planes} of the study {does|do} not cross what is labelled", beside));
  if (!near.empty())
    joined.warnings.push_back(
        phrase("%n {slice|slices} nearer than 4 mm to the one before {is|are} not used", near.size()));
}

} // namespace

std::size_t phasesOf(const CineStudy& study) {
  return study.slices.empty() ? 0 : numberingSlice(study).phasesInCycle();
}

LabelledStudy joinStudy(const medical_io::CineStudy& study, const CineRequest& request, Progress& progress) {
  LabelledStudy joined;
  for (std::size_t i = 0; i < study.slices.size(); ++i) {
    const CineGeometry& place = study.slices[i].geometry;
    joined.slices.push_back({{place.origin, place.normal()}, study.slices[i].number, planeName(study, i)});
  }
  joined.warnings = study.findings;
  joined.firstPhase = request.firstPhase;
  joined.times = timesOfStudy(study, request);
  const std::vector<PhaseLabels> labels = checkedLabels(request, joined.times.count());
  runPart(progress, 0, 0.5, [&](Progress& part) { readLabels(labels, request, joined, part); });
  for (const ContourCorrection& correction : request.corrections)
    joined.corrections.push_back(resolved(joined, correction));
  runPart(progress, 0.5, 1, [&](Progress& part) { addPlanes(study, request, joined, part); });
  progress.report(1);
  return joined;
}

LabelledStudy readLabelledStudy(const CineRequest& request, Progress& progress) {
  std::optional<medical_io::CineStudy> study;
  runPart(progress, 0, 0.5,
          [&](Progress& part) { study.emplace(medical_io::readCineStudy(request.images, part)); });
  LabelledStudy joined;
  runPart(progress, 0.5, 1, [&](Progress& part) { joined = joinStudy(*study, request, part); });
  return joined;
}

} // namespace viscera::live
