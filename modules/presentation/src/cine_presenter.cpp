#include "viscera/presentation/cine_presenter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/document/study_item.h"
#include "viscera/presentation/cine_view.h"
#include "viscera/presentation/presenter.h"
#include "viscera/scene/legend.h"

#include "seen_document.h"
#include "slice_cuts.h"
#include "slice_marks.h"
#include "untranslated.h"

namespace viscera::presentation {
namespace {

using medical_io::CineImage;
using medical_io::CineSlice;
using medical_io::CineStudy;

constexpr double kCineRestShade = 0.5;
/// Colour of the lines in which the planes of other panes cut.
const Vec3 kCrossingColor(0.45, 0.5, 0.55);

/// The inputs with which a pane was sampled.
struct CineSampled {
  std::shared_ptr<const document::StudyItem> study;
  std::size_t slice = 0;
  std::optional<std::size_t> phase;
  medical_io::SliceFrame frame;
  bool smooth = true;

  bool operator==(const CineSampled& other) const {
    return study == other.study && slice == other.slice && phase == other.phase && smooth == other.smooth &&
           frame.corner == other.frame.corner && frame.right == other.frame.right &&
           frame.up == other.frame.up && frame.width == other.frame.width &&
           frame.height == other.frame.height;
  }
};

/// One pane, kept.
struct CinePane {
  std::size_t slice = 0;
  std::optional<std::size_t> phase;
  medical_io::SliceFrame frame;
  CineSampled with;
  medical_io::ValueImage values;
  medical_io::ValueWindow window{0, 0};
  scene::SlicePicture picture;
  std::size_t plane = 0; ///< Among those that organs are cut by.
  std::string problem;   ///< Why the picture is not there; empty: it is.
  SliceGrips grips;
};

void addContour(const geometry::PlaneCut& cut, const medical_io::SliceFrame& frame, const Vec3& color,
                bool thin, std::vector<scene::SliceLine>& lines) {
  for (std::size_t i = 0; i < cut.lines(); ++i) {
    scene::SliceLine line{{}, cut.closed[i], color, thin};
    for (Eigen::Index row = cut.first[i]; row < cut.first[i + 1]; ++row)
      line.points.push_back(frame.pixelOf(cut.points.row(row).transpose()));
    lines.push_back(std::move(line));
  }
}

} // namespace

struct CinePresenter::Parts {
  Parts(Threads threadsIn, SlicePresenter::Translate translateIn)
      : threads(threadsIn), language{translateIn ? std::move(translateIn) : untranslated, '.'},
        cuts(threadsIn) {}

  Threads threads;
  SliceLanguage language;
  SliceCuts cuts;
  SeenDocument seen;
  std::array<CinePane, 3> panes;
  std::shared_ptr<const document::StudyItem> proposedBy; ///< Whose proposal `proposed` is.
  medical_io::ValueWindow proposed;
  std::optional<BentContour> bent;
  document::MeasuringMemory regions;

  const CinePane& pane(int direction) const { return panes[std::size_t(direction)]; }
  void sample(CinePane& pane, const SliceScene& scene);
  void shade(CinePane& pane, const SliceScene& scene);
  void outline(CinePane& pane, const SliceScene& scene, const std::array<std::size_t, 3>& slices);
  void outlinePosed(CinePane& pane, const SliceCuts::Organ& organ);
  void label(CinePane& pane, const SliceScene& scene) const;
  std::string say(const char* pattern, std::initializer_list<std::string> parts) const;
};

/// A translated pattern with its parts in the places of %1 to %9.
std::string CinePresenter::Parts::say(const char* pattern, std::initializer_list<std::string> parts) const {
  std::string words = language.translate(pattern);
  char place[] = "%1";
  for (const std::string& part : parts) {
    if (const std::size_t at = words.find(place); at != std::string::npos)
      words.replace(at, 2, part);
    ++place[1];
  }
  return words;
}

/// A picture that cannot be decoded is as one that is missing.
void CinePresenter::Parts::sample(CinePane& pane, const SliceScene& scene) {
  const CineSampled with{scene.state.study, pane.slice, pane.phase, pane.frame, scene.view.scan.smooth};
  if (with == pane.with)
    return;
  pane.with = with;
  pane.window.width = 0; // Other values have other grey levels.
  pane.values = {};
  pane.problem.clear();
  const CineSlice& slice = scene.state.study->study->slices[pane.slice];
  if (!pane.phase) {
    pane.problem = language.translate("The picture of this phase is missing");
    return;
  }
  try {
    sampleCine(*slice.image(*pane.phase), slice.geometry, pane.frame, scene.view.scan.smooth, pane.values);
  } catch (const DataError&) {
    pane.problem = language.translate("The picture of this phase cannot be read");
  }
}

void CinePresenter::Parts::shade(CinePane& pane, const SliceScene& scene) {
  pane.picture.width = pane.frame.width;
  pane.picture.height = pane.frame.height;
  if (proposedBy != scene.state.study && scene.view.scan.width <= 0) {
    proposedBy = scene.state.study;
    proposed = cineWindow(*proposedBy->study);
  }
  const medical_io::ValueWindow window = windowOf(scene.view.scan, proposed);
  if (window.level == pane.window.level && window.width == pane.window.width)
    return;
  pane.window = window;
  pane.picture.grey.clear();
  if (!pane.values.values.empty())
    medical_io::greyOf(pane.values, window, 0, pane.picture.grey, threads);
}

/// The planes of the other panes lie below the contours at rest, and those below the contours of the pose.
void CinePresenter::Parts::outline(CinePane& pane, const SliceScene& scene,
                                   const std::array<std::size_t, 3>& slices) {
  const CineStudy& study = *scene.state.study->study;
  pane.picture.lines.clear();
  for (const std::size_t other : slices)
    if (const auto ends = cineCross(pane.frame, cinePlane(study.slices[other].geometry)))
      pane.picture.lines.push_back({{(*ends)[0], (*ends)[1]}, false, kCrossingColor, true});
  if (!scene.view.scan.contours)
    return;
  for (const SliceCuts::Organ& organ : cuts.organs())
    if (!organ.rest.empty())
      addContour(organ.rest[pane.plane], pane.frame, kCineRestShade * shownColor(organ.organ->look.color),
                 true, pane.picture.lines);
  for (const SliceCuts::Organ& organ : cuts.organs())
    outlinePosed(pane, organ);
}

/// An organ's contour, thin below the one that a user bends.
void CinePresenter::Parts::outlinePosed(CinePane& pane, const SliceCuts::Organ& organ) {
  const bool isBent = bent && &pane == &panes[std::size_t(bent->direction)] && bent->organ == organ.organ->id;
  const Vec3 color = shownColor(organ.organ->look.color);
  addContour(organ.posed[pane.plane], pane.frame, color, isBent, pane.picture.lines);
  if (!isBent)
    return;
  scene::SliceLine line{{}, bent->closed, color, false};
  for (Eigen::Index row = 0; row < bent->points.rows(); ++row)
    line.points.push_back(pane.frame.pixelOf(bent->points.row(row).transpose()));
  pane.picture.lines.push_back(std::move(line));
}

/// "Short axis 2 of 3, phase 7 of 25", and below level, width and what is missing.
void CinePresenter::Parts::label(CinePane& pane, const SliceScene& scene) const {
  const CineStudy& study = *scene.state.study->study;
  const CineSlice& slice = study.slices[pane.slice];
  scene::SlicePicture& picture = pane.picture;
  const std::vector<std::size_t> group = cineGroup(study, pane.slice);
  picture.title = language.translate(nameOf(slice.plane).c_str());
  const bool isStack = std::all_of(group.begin(), group.end(), [&](std::size_t other) {
    return study.slices[other].plane == slice.plane;
  });
  if (group.size() > 1 && isStack) {
    std::size_t place = 1;
    for (std::size_t i = 0; i < group.size(); ++i)
      place = group[i] == pane.slice ? i + 1 : place;
    picture.title += " " + say("%1 of %2", {std::to_string(place), std::to_string(group.size())});
  }
  if (pane.phase)
    picture.title += "  " + say("phase %1 of %2",
                                {std::to_string(*pane.phase + 1), std::to_string(slice.phasesInCycle())});
  const std::array<std::string, 4> edges = cineEdges(pane.frame);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    picture.edges[i].clear();
    for (const char letter : edges[i])
      picture.edges[i] += language.translate(std::string(1, letter).c_str());
  }
  picture.mmPerPixel = pane.frame.right.norm();
  char note[64];
  std::snprintf(note, sizeof note, "L %.0f  W %.0f", pane.window.level, pane.window.width);
  picture.note = pane.problem.empty() ? note : pane.problem;
}

CinePresenter::CinePresenter(Threads threads, SlicePresenter::Translate translate)
    : parts_(std::make_unique<Parts>(threads, std::move(translate))) {}

CinePresenter::~CinePresenter() = default;

void CinePresenter::setDecimalMark(char mark) {
  parts_->language.decimalMark = mark;
}

void CinePresenter::update(const SliceScene& scene, const std::vector<SlicePane>& panes) {
  if (!scene.state.study)
    throw UsageError(misuse("There is no study"));
  Parts& p = *parts_;
  const CineStudy& study = *scene.state.study->study;
  const std::array<std::size_t, 3> slices = cineSlices(study, scene.view.scan.cine);
  std::vector<geometry::Plane> planes;
  for (const SlicePane& wanted : panes) {
    const auto place = std::size_t(wanted.direction);
    CinePane& pane = p.panes[place];
    pane.slice = slices[place];
    const CineSlice& slice = study.slices[pane.slice];
    pane.phase = cinePhase(slice, scene.view.scan.cine.fraction);
    pane.frame = cineFrame(slice.geometry, scene.view.scan.framings[place], std::max(1, wanted.width),
                           std::max(1, wanted.height));
    pane.plane = planes.size();
    planes.push_back(cinePlane(slice.geometry));
    p.sample(pane, scene);
    p.shade(pane, scene);
  }
  p.cuts.update(p.seen.of(scene.state, scene.view.organsSeen), scene.organs,
                scene.view.scan.contours ? planes : std::vector<geometry::Plane>(), scene.view.scan.rest);
  for (const SlicePane& wanted : panes) {
    CinePane& pane = p.panes[std::size_t(wanted.direction)];
    p.outline(pane, scene, slices);
    p.label(pane, scene);
    const MarkedPlane marked{pane.frame.plane().normal, -1, study.slices[pane.slice].geometry.thickness};
    pane.grips = addMarks(scene, marked, pane.frame, p.regions, p.language, pane.picture);
  }
}

int CinePresenter::handleAt(int direction, const Eigen::Vector2d& pixel, double reach) const {
  const auto* grip = nearestGrip(parts_->pane(direction).grips.handles, pixel, reach);
  return grip ? static_cast<int>(grip->item) : -1;
}

std::optional<scene::MeasurementGlyphs::Mark>
CinePresenter::measuredAt(int direction, const Eigen::Vector2d& pixel, double reach) const {
  const auto* grip = nearestGrip(parts_->pane(direction).grips.measured, pixel, reach);
  return grip ? std::optional(scene::MeasurementGlyphs::Mark{grip->item, grip->point}) : std::nullopt;
}

const scene::SlicePicture& CinePresenter::picture(int direction) const {
  return parts_->pane(direction).picture;
}

const medical_io::SliceFrame& CinePresenter::frame(int direction) const {
  return parts_->pane(direction).frame;
}

std::size_t CinePresenter::slice(int direction) const {
  return parts_->pane(direction).slice;
}

std::optional<std::size_t> CinePresenter::phase(int direction) const {
  return parts_->pane(direction).phase;
}

SliceReading CinePresenter::read(int direction, const Eigen::Vector2d& pixel) const {
  const CinePane& pane = parts_->pane(direction);
  SliceReading reading;
  reading.position = pane.frame.at(pixel.x(), pixel.y());
  const auto x = std::lround(pixel.x()), y = std::lround(pixel.y());
  if (!pane.values.values.empty() && x >= 0 && y >= 0 && x < pane.values.width && y < pane.values.height) {
    const float value = pane.values.values[std::size_t(y) * std::size_t(pane.values.width) + std::size_t(x)];
    if (std::isfinite(value))
      reading.value = value;
  }
  // A cavity lies within its organ: the shorter outline is the inner one.
  double shortest = 0;
  for (const SliceCuts::Organ& item : parts_->cuts.organs()) {
    if (pane.plane >= item.posed.size())
      continue;
    const geometry::PlaneCut& cut = item.posed[pane.plane];
    if ((reading.organ && cut.lengthMm >= shortest) ||
        !geometry::isInside(cut, pane.frame.plane(), reading.position))
      continue;
    shortest = cut.lengthMm;
    reading.organ = item.organ->id;
  }
  return reading;
}

std::optional<ContourPlace> CinePresenter::contourAt(int direction, const Eigen::Vector2d& pixel,
                                                     double reach) const {
  const CinePane& pane = parts_->pane(direction);
  std::optional<ContourPlace> nearest;
  double least = reach;
  const auto ask = [&](document::OrganId organ, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d along = b - a;
    const double part = std::clamp((pixel - a).dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
    const Eigen::Vector2d place = a + part * along;
    if (const double apart = (pixel - place).norm(); apart <= least) {
      least = apart;
      nearest = {organ, pane.frame.at(place.x(), place.y())};
    }
  };
  for (const SliceCuts::Organ& item : parts_->cuts.organs()) {
    if (pane.plane >= item.posed.size())
      continue;
    const geometry::PlaneCut& cut = item.posed[pane.plane];
    for (std::size_t i = 0; i < cut.lines(); ++i)
      for (Eigen::Index row = cut.first[i]; row < cut.first[i + 1]; ++row) {
        const Eigen::Index next = row + 1 < cut.first[i + 1] ? row + 1 : cut.closed[i] ? cut.first[i] : row;
        ask(item.organ->id, pane.frame.pixelOf(cut.points.row(row).transpose()),
            pane.frame.pixelOf(cut.points.row(next).transpose()));
      }
  }
  return nearest;
}

geometry::PlaneCut CinePresenter::cut(int direction, document::OrganId organ) const {
  const std::size_t plane = parts_->pane(direction).plane;
  for (const SliceCuts::Organ& item : parts_->cuts.organs())
    if (item.organ->id == organ && plane < item.posed.size())
      return item.posed[plane];
  return {};
}

void CinePresenter::setBent(std::optional<BentContour> bent) {
  parts_->bent = std::move(bent);
}

std::vector<ContourFigure> CinePresenter::contours(int direction) const {
  const std::size_t plane = parts_->pane(direction).plane;
  std::vector<ContourFigure> figures;
  for (const SliceCuts::Organ& item : parts_->cuts.organs())
    if (plane < item.posed.size() && item.posed[plane].lines() > 0)
      figures.push_back(
          {item.organ->id, item.organ->name, item.posed[plane].points.rows(), item.posed[plane].lengthMm});
  return figures;
}

medical_io::ValueWindow windowOf(const ScanLook& look, const medical_io::ValueWindow& proposed) {
  return look.width > 0 ? medical_io::ValueWindow{look.level, look.width} : proposed;
}

} // namespace viscera::presentation
