#include "viscera/presentation/slice_presenter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "untranslated.h"
#include "viscera/presentation/presenter.h"
#include "viscera/scene/legend.h"

#include "seen_document.h"
#include "slice_cuts.h"
#include "slice_marks.h"
#include "slice_values.h"

namespace viscera::presentation {
namespace {

constexpr double kEmptyHalfSize = 100;
/// The box with this much room fits into the picture.
constexpr double kRoom = 1.04;
constexpr double kRestShade = 0.5;
/// Between slices without a scan, mm.
constexpr double kStepMm = 1;

std::string formatted(const char* format, double a, double b) {
  char text[64];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

bool equal(const medical_io::SliceFrame& a, const medical_io::SliceFrame& b) {
  return a.corner == b.corner && a.right == b.right && a.up == b.up && a.width == b.width &&
         a.height == b.height;
}

/// The inputs with which a slice was sampled.
struct SampledWith {
  std::shared_ptr<const medical_io::Scan> scan; ///< Of the phase that is shown; null: there is none.
  medical_io::SliceFrame frame;
  double slabMm = 0;
  bool maximum = false;
  bool smooth = true;
  std::optional<std::uint64_t> warped;

  bool operator==(const SampledWith& other) const {
    return scan == other.scan && equal(frame, other.frame) && slabMm == other.slabMm &&
           maximum == other.maximum && smooth == other.smooth && warped == other.warped;
  }
};

/// One slice, kept.
struct Slice {
  medical_io::SliceFrame frame;
  SampledWith with;
  SliceValues values;
  medical_io::ValueWindow window{0, 0};
  scene::SlicePicture picture;
  std::size_t plane = 0; ///< Among those that organs are cut by.
  SliceGrips grips;
};

medical_io::SliceFrame frameOf(const SlicePane& pane, const Bounds& box, const Vec3& focus,
                               const SliceFraming& framing) {
  const auto direction = medical_io::sliceDirections()[std::size_t(pane.direction)];
  const Vec3 extent = box.high - box.low;
  const double mmPerPixel = kRoom / framing.zoom *
                            std::max(direction.right.cwiseAbs().dot(extent) / std::max(1, pane.width),
                                     direction.up.cwiseAbs().dot(extent) / std::max(1, pane.height));
  Vec3 center = box.center() + framing.rightMm * direction.right + framing.upMm * direction.up;
  center[direction.axis] = focus[direction.axis];
  return medical_io::frameAround(direction, center, mmPerPixel, std::max(1, pane.width),
                                 std::max(1, pane.height));
}

void addLines(const geometry::PlaneCut& cut, const medical_io::SliceFrame& frame, const Vec3& color,
              bool thin, std::vector<scene::SliceLine>& lines) {
  for (std::size_t i = 0; i < cut.lines(); ++i) {
    scene::SliceLine line{{}, cut.closed[i], color, thin};
    line.points.reserve(std::size_t(cut.first[i + 1] - cut.first[i]));
    for (Eigen::Index row = cut.first[i]; row < cut.first[i + 1]; ++row)
      line.points.push_back(frame.pixelOf(cut.points.row(row).transpose()));
    lines.push_back(std::move(line));
  }
}

} // namespace

struct SlicePresenter::Parts {
  Parts(Threads threadsIn, Translate translateIn)
      : threads(threadsIn), language{translateIn ? std::move(translateIn) : untranslated, '.'},
        cuts(threadsIn) {}

  Threads threads;
  SliceLanguage language;
  SliceCuts cuts;
  SeenDocument seen;
  std::array<Slice, 3> slices;
  std::shared_ptr<const document::ScanItem> proposedBy; ///< Whose proposal `proposed` is.
  medical_io::ValueWindow proposed;
  document::MeasuringMemory regions;
  std::shared_ptr<const medical_io::Scan> shown; ///< The volume of the present phase.

  medical_io::ValueWindow windowFor(const SliceScene& scene);
  void sample(Slice& slice, const SliceScene& scene);
  void shade(Slice& slice, const SliceScene& scene);
  void outline(Slice& slice);
  void label(Slice& slice, const medical_io::SliceDirection& direction, const SliceScene& scene,
             const Vec3& focus) const;
  std::string phaseTitle(const medical_io::ScanOverTime& time, double fraction) const;
};

/// "phase 7 of 20", counted with those that are damaged; empty for these.
std::string SlicePresenter::Parts::phaseTitle(const medical_io::ScanOverTime& time, double fraction) const {
  const std::optional<std::size_t> phase = time.shownAt(fraction);
  if (!phase)
    return {};
  const double here = time.fractions[*phase];
  const auto before = std::count_if(time.missing.begin(), time.missing.end(),
                                    [here](double missing) { return missing < here; });
  std::string title = language.translate("phase %1 of %2");
  const auto put = [&title](const char* place, std::size_t number) {
    if (const std::size_t at = title.find(place); at != std::string::npos)
      title.replace(at, 2, std::to_string(number));
  };
  put("%1", *phase + 1 + static_cast<std::size_t>(before));
  put("%2", time.phasesInCycle());
  return title;
}

/// The proposal of a scan is cached, because it may need all of its voxels.
medical_io::ValueWindow SlicePresenter::Parts::windowFor(const SliceScene& scene) {
  if (scene.view.scan.width > 0)
    return {scene.view.scan.level, scene.view.scan.width};
  if (proposedBy != scene.state.scan) {
    proposedBy = scene.state.scan;
    proposed = proposedBy->scan->firstWindow();
  }
  return proposed;
}

void SlicePresenter::Parts::sample(Slice& slice, const SliceScene& scene) {
  const ScanLook& look = scene.view.scan;
  const bool warped = look.warped && scene.warping;
  SampledWith with{shown, slice.frame, look.slabMm, look.maximum, look.smooth, {}};
  if (warped)
    with.warped = scene.warping->revision;
  if (with == slice.with)
    return;
  slice.with = with;
  slice.window.width = 0; // Other values have other grey levels.
  if (!shown)
    return slice.values.clear();
  medical_io::SampleOptions options;
  options.nearest = !look.smooth;
  options.slabMm = look.slabMm;
  options.maximum = look.maximum;
  options.threads = threads;
  slice.values.take(*shown, slice.frame, options, warped ? scene.warping : nullptr);
}

void SlicePresenter::Parts::shade(Slice& slice, const SliceScene& scene) {
  slice.picture.width = slice.frame.width;
  slice.picture.height = slice.frame.height;
  if (!shown) {
    slice.picture.grey.clear();
    return;
  }
  const medical_io::ValueWindow window = windowFor(scene);
  if (window.level == slice.window.level && window.width == slice.window.width)
    return;
  slice.window = window;
  slice.values.shade(window, slice.picture.grey, threads);
}

/// Contours at rest lie below those of the pose.
void SlicePresenter::Parts::outline(Slice& slice) {
  slice.picture.lines.clear();
  for (const SliceCuts::Organ& organ : cuts.organs())
    if (!organ.rest.empty())
      addLines(organ.rest[slice.plane], slice.frame, kRestShade * shownColor(organ.organ->look.color), true,
               slice.picture.lines);
  for (const SliceCuts::Organ& organ : cuts.organs())
    addLines(organ.posed[slice.plane], slice.frame, shownColor(organ.organ->look.color), false,
             slice.picture.lines);
}

void SlicePresenter::Parts::label(Slice& slice, const medical_io::SliceDirection& direction,
                                  const SliceScene& scene, const Vec3& focus) const {
  scene::SlicePicture& picture = slice.picture;
  const ScanLook& look = scene.view.scan;
  picture.cross = slice.frame.pixelOf(focus);
  for (std::size_t i = 0; i < 4; ++i)
    picture.edges[i] = language.translate(direction.edges[i]);
  picture.title = language.translate(direction.name) + "  " +
                  formatSlicePosition(direction.axis, focus[direction.axis], language.decimalMark);
  picture.mmPerPixel = slice.frame.right.norm();
  picture.note.clear();
  if (!scene.state.scan)
    return;
  if (scene.state.scan->time)
    picture.title += "  " + phaseTitle(*scene.state.scan->time, look.cine.fraction);
  if (!shown) {
    const bool damaged = !scene.state.scan->time->shownAt(look.cine.fraction);
    picture.note = language.translate(damaged ? "The picture of this phase is missing"
                                              : "The picture of this phase cannot be read");
    return;
  }
  picture.note = formatted("L %.0f  W %.0f", slice.window.level, slice.window.width);
  if (look.slabMm > 0) {
    std::string over =
        look.maximum ? language.translate("Maximum of %1 mm") : language.translate("Mean of %1 mm");
    if (const std::size_t at = over.find("%1"); at != std::string::npos)
      over.replace(at, 2, scene::withDecimalMark(formatted("%g", look.slabMm, 0), language.decimalMark));
    picture.note += "  " + over;
  }
  if (slice.with.warped)
    picture.note += "  " + language.translate("Warped");
  if (slice.values.anyFolded())
    picture.note += ", " + language.translate("folded where it is hatched");
}

SlicePresenter::SlicePresenter(Threads threads, Translate translate)
    : parts_(std::make_unique<Parts>(threads, std::move(translate))) {}

SlicePresenter::~SlicePresenter() = default;

void SlicePresenter::setDecimalMark(char mark) {
  parts_->language.decimalMark = mark;
}

void SlicePresenter::update(const SliceScene& scene, const std::vector<SlicePane>& panes) {
  Parts& p = *parts_;
  const Bounds box = boxOfSlices(scene.state);
  const Vec3 focus = focusOf(scene.state, scene.view.scan);
  p.shown = scene.state.scan ? document::scanAt(*scene.state.scan, scene.view.scan.cine.fraction) : nullptr;
  std::vector<geometry::Plane> planes;
  for (const SlicePane& pane : panes) {
    Slice& slice = p.slices[std::size_t(pane.direction)];
    slice.frame = frameOf(pane, box, focus, scene.view.scan.framings[std::size_t(pane.direction)]);
    slice.plane = planes.size();
    // The plane hangs on the focus alone: panning and zooming cut nothing anew.
    planes.push_back({focus, slice.frame.plane().normal});
    p.sample(slice, scene);
    p.shade(slice, scene);
  }
  p.cuts.update(p.seen.of(scene.state, scene.view.organsSeen), scene.organs,
                scene.view.scan.contours ? planes : std::vector<geometry::Plane>(), scene.view.scan.rest);
  for (const SlicePane& pane : panes) {
    Slice& slice = p.slices[std::size_t(pane.direction)];
    if (scene.view.scan.contours)
      p.outline(slice);
    else
      slice.picture.lines.clear();
    const medical_io::SliceDirection direction = medical_io::sliceDirections()[std::size_t(pane.direction)];
    p.label(slice, direction, scene, focus);
    slice.grips = addMarks(
        scene, {Vec3(Vec3::Unit(direction.axis)), direction.axis, stepAlong(scene.state, direction.axis)},
        slice.frame, p.regions, p.language, slice.picture);
  }
}

const scene::SlicePicture& SlicePresenter::picture(int direction) const {
  return parts_->slices[std::size_t(direction)].picture;
}

const medical_io::SliceFrame& SlicePresenter::frame(int direction) const {
  return parts_->slices[std::size_t(direction)].frame;
}

const geometry::PlaneCut* SlicePresenter::cut(int direction, document::OrganId organ) const {
  const std::size_t plane = parts_->slices[std::size_t(direction)].plane;
  for (const SliceCuts::Organ& item : parts_->cuts.organs())
    if (item.organ->id == organ && plane < item.posed.size())
      return &item.posed[plane];
  return nullptr;
}

SliceReading SlicePresenter::read(int direction, const Eigen::Vector2d& pixel) const {
  const Slice& slice = parts_->slices[std::size_t(direction)];
  SliceReading reading;
  reading.position = slice.frame.at(pixel.x(), pixel.y());
  const auto x = std::lround(pixel.x()), y = std::lround(pixel.y());
  reading.value = slice.values.at(x, y);
  reading.folded = slice.values.foldedAt(x, y);
  // A cavity lies within its organ: the shorter outline is the inner one.
  double shortest = 0;
  for (const SliceCuts::Organ& item : parts_->cuts.organs()) {
    if (slice.plane >= item.posed.size())
      continue;
    const geometry::PlaneCut& cut = item.posed[slice.plane];
    if ((reading.organ && cut.lengthMm >= shortest) ||
        !geometry::isInside(cut, slice.frame.plane(), reading.position))
      continue;
    shortest = cut.lengthMm;
    reading.organ = item.organ->id;
  }
  return reading;
}

int SlicePresenter::handleAt(int direction, const Eigen::Vector2d& pixel, double reach) const {
  const auto* grip = nearestGrip(parts_->slices[std::size_t(direction)].grips.handles, pixel, reach);
  return grip ? static_cast<int>(grip->item) : -1;
}

std::optional<scene::MeasurementGlyphs::Mark>
SlicePresenter::measuredAt(int direction, const Eigen::Vector2d& pixel, double reach) const {
  const auto* grip = nearestGrip(parts_->slices[std::size_t(direction)].grips.measured, pixel, reach);
  return grip ? std::optional(scene::MeasurementGlyphs::Mark{grip->item, grip->point}) : std::nullopt;
}

std::vector<ContourFigure> SlicePresenter::contours(int direction) const {
  const std::size_t plane = parts_->slices[std::size_t(direction)].plane;
  std::vector<ContourFigure> figures;
  for (const SliceCuts::Organ& item : parts_->cuts.organs())
    if (plane < item.posed.size() && item.posed[plane].lines() > 0)
      figures.push_back(
          {item.organ->id, item.organ->name, item.posed[plane].points.rows(), item.posed[plane].lengthMm});
  return figures;
}

Bounds boxOfSlices(const document::DocumentState& state) {
  if (state.scan)
    return state.scan->scan->bounds();
  if (state.organs->empty())
    return {Vec3::Constant(-kEmptyHalfSize), Vec3::Constant(kEmptyHalfSize)};
  Bounds box = boundsOf(state.organs->front()->mesh->points);
  for (const auto& organ : *state.organs) {
    const Bounds one = boundsOf(organ->mesh->points);
    box = {box.low.cwiseMin(one.low), box.high.cwiseMax(one.high)};
  }
  return box;
}

Vec3 focusOf(const document::DocumentState& state, const ScanLook& look) {
  return look.focus ? *look.focus : boxOfSlices(state).center();
}

std::optional<Warping> warpingOf(live::LiveWarp& warp) {
  if (!warp.map())
    return std::nullopt;
  return Warping{[&warp](const deformation::SamplePlane& plane, deformation::RestPoints& rest) {
                   warp.restPlane(plane, rest);
                 },
                 warp.revision(), live::tissueMotionOf(warp)};
}

double stepAlong(const document::DocumentState& state, int axis) {
  if (!state.scan)
    return kStepMm;
  const Eigen::Matrix3d steps = state.scan->scan->indexToLps.linear();
  const Eigen::Matrix3d directions = steps.colwise().normalized();
  Eigen::Index along = 0;
  directions.row(axis).cwiseAbs().maxCoeff(&along);
  return steps.col(along).norm();
}

namespace {

/// "R 110.1"
std::string sided(int axis, double mm, char decimalMark) {
  constexpr const char* kLetters[3][2] = {{"L", "R"}, {"P", "A"}, {"S", "I"}};
  constexpr double kShown = 0.05; // What is nearer to the middle has no other side.
  return kLetters[axis][mm <= -kShown ? 1 : 0] +
         scene::withDecimalMark(formatted(" %.1f", std::abs(mm), 0), decimalMark);
}

} // namespace

std::string formatSlicePosition(int axis, double mm, char decimalMark) {
  return sided(axis, mm, decimalMark) + " mm";
}

std::string formatPlace(const Vec3& place, char decimalMark) {
  const std::string between = decimalMark == ',' ? "; " : ", ";
  return sided(0, place.x(), decimalMark) + between + sided(1, place.y(), decimalMark) + between +
         sided(2, place.z(), decimalMark);
}

medical_io::ValueWindow windowOf(const medical_io::Scan& scan, const ScanLook& look) {
  return look.width > 0 ? medical_io::ValueWindow{look.level, look.width} : scan.firstWindow();
}

} // namespace viscera::presentation
