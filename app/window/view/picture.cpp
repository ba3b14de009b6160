#include "window/view/picture.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "viscera/presentation/slice_presenter.h"
#include "viscera/scene/vtkVisceraHandleSetWidget.h"
#include "window/style/language.h"

namespace viscera::app {

std::string translated(const char* text) {
  // A pattern keeps its places for the caller; a name may have a number behind it.
  const std::string words = text;
  return words.find("%1") == std::string::npos ? inWords(words).toStdString()
                                               : wording().translate(words, std::nullopt);
}

namespace {

/// Whether the change may have changed what is drawn. The circulation and the recorded keys are visible only
/// by the poses that follow, which the organs announce: drawing the old pose once more, while a control
/// moves, would keep the new one waiting for as long as a frame takes.
bool isDrawn(const document::Change& change) {
  document::DocumentState drawnBefore = change.before;
  drawnBefore.circulation = change.after.circulation;
  drawnBefore.keySequence = change.after.keySequence;
  return drawnBefore != change.after || change.before == change.after;
}

/// Hides everything of the document, without changing it.
void hide(document::DocumentState& state, presentation::ViewState& view) {
  auto organs = std::make_shared<document::OrganList>();
  for (const auto& organ : *state.organs) {
    auto hidden = std::make_shared<document::Organ>(*organ);
    hidden->look.visible = false;
    organs->push_back(std::move(hidden));
  }
  state.organs = std::move(organs);
  state.measurements = std::make_shared<const document::MeasurementList>();
  state.stressMarks = std::make_shared<const document::StressMarks>();
  view.shown = {.rest = view.shown.rest};
  view.handles = false;
}

} // namespace

Picture::Picture(Workspace& workspace, ViewModel& model, ViewWidget& view, Role role, QObject* parent)
    : QObject(parent), workspace_(workspace), model_(model), widget_(view), role_(role),
      opener_(workspace, model), presenter_(view.view(), {}, translated) {
  view.view().handleWidget()->SetRenderOnChange(false);
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (isDrawn(change))
      markOutdated();
  }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent& event) {
    if (!event.more)
      markOutdated();
  }));
  subscriptions_.push_back(workspace.stress().onEvent([this](const live::StressEvent&) { markOutdated(); }));
  subscriptions_.push_back(workspace.selection().onChange([this] { markOutdated(); }));
  subscriptions_.push_back(workspace.warp().onChange([this] { markOutdated(); }));
  connect(&model, &ViewModel::changed, this, [this] {
    if (differsFromDocument())
      markOutdated();
  });
  connect(&opener_, &HeartOpener::made, this, &Picture::markOutdated);
  connect(&view, &ViewWidget::themeChanged, this, &Picture::markOutdated);
  view.setContents([this] { bringUpToDate(); });
  view.scheduleRender();
}

Picture::~Picture() {
  widget_.setContents(nullptr);
}

const presentation::Presenter& Picture::presenter() const {
  bringUpToDate();
  return presenter_;
}

/// Whether the view's state requires another picture than the last one. Changes of the slices beside the view
/// do not, so that moving them is quick.
bool Picture::differsFromDocument() const {
  if (!drawn_)
    return true;
  presentation::ViewState now = model_.state();
  if (!now.scan.standing && !drawn_->scan.standing)
    now.scan = drawn_->scan;
  return now != *drawn_;
}

presentation::ViewState Picture::state() const {
  presentation::ViewState state = model_.state();
  const document::Selection& selection = workspace_.selection();
  state.selection = {selection.organ(), selection.group(), selection.handles()};
  if (role_ == Role::showing) {
    state.shown.movable = state.shown.tools = state.shown.regions = false;
    state.stress.probe = -1; // A point of the other view's mesh.
    if (!ofSameOrgans_)
      state.organsSeen.clear(); // By the ids of the other view's document.
  }
  return state;
}

void Picture::setMeasuring(presentation::PendingMeasurement measuring) {
  measuring_ = std::move(measuring);
  markOutdated();
}

void Picture::setTransientSurfaces(std::vector<presentation::TransientSurface> transient, bool alone) {
  transient_ = std::move(transient);
  transientAlone_ = alone && !transient_.empty();
  markOutdated();
}

void Picture::setMeasured(std::vector<presentation::TransientSurface> surfaces) {
  measured_ = std::move(surfaces);
  markOutdated();
}

void Picture::setOfSameOrgans(bool same) {
  if (std::exchange(ofSameOrgans_, same) != same)
    markOutdated();
}

void Picture::setNamedParts(std::optional<std::vector<presentation::Part>> parts) {
  namedParts_ = std::move(parts);
  markOutdated();
}

void Picture::setPointedOrgan(document::OrganId organ) {
  if (pointedOrgan_ == organ)
    return;
  pointedOrgan_ = organ;
  // Where no handle is seen, nothing is another picture.
  const presentation::ViewState& view = model_.state();
  if (view.shown.handles || view.handles)
    markOutdated();
}

void Picture::setValves(Valves valves) {
  valves_ = std::move(valves);
  markOutdated();
}

void Picture::setClock(Clock clock) {
  clock_ = std::move(clock);
  markOutdated();
}

void Picture::setStressRange(std::optional<scene::ValueRange> range, bool legend) {
  if (stressRange_ == range && stressLegend_ == legend)
    return;
  stressRange_ = range;
  stressLegend_ = legend;
  markOutdated();
}

void Picture::setMap(std::optional<presentation::SurfaceMap> map) {
  map_ = std::move(map);
  markOutdated();
}

void Picture::setSegments(std::optional<presentation::SurfaceMap> segments) {
  if (!segments && !segments_)
    return;
  segments_ = std::move(segments);
  markOutdated();
}

bool Picture::hasMoreThanMovies() const {
  const presentation::ScanLook& scan = model_.state().scan;
  return map_ || !transient_.empty() || !measured_.empty() || (scan.standing && scan.warped);
}

void Picture::markOutdated() {
  outdated_ = true;
  widget_.scheduleRender();
}

/// An observer of `changed` may set something that the picture shows, such as the range of a map that another
/// picture shares.
void Picture::bringUpToDate() const {
  while (std::exchange(outdated_, false))
    update();
}

/// A surface that was exchanged has the segments of the one before, until they are found anew.
bool Picture::segmentsFit() const {
  return segments_ &&
         std::all_of(segments_->values.begin(), segments_->values.end(), [this](const auto& part) {
           const auto organ = workspace_.document().organ(part.first);
           return !organ || organ->mesh->points.rows() == part.second->size();
         });
}

void Picture::update() const {
  workspace_.guarded([this] {
    presentation::ViewState view = state();
    document::DocumentState shown = workspace_.state();
    if (transientAlone_)
      hide(shown, view);
    const live::StressFrame stress = workspace_.stress().frame();
    std::optional<presentation::Warping> warping;
    if (shown.scan && view.scan.warped)
      warping = presentation::warpingOf(workspace_.warp());
    std::vector<presentation::TransientSurface> transient = transient_;
    if (!view.shown.stress) // They would cover the map.
      transient.insert(transient.end(), measured_.begin(), measured_.end());
    const presentation::SurfaceMap* map = map_ ? &*map_ : segmentsFit() ? &*segments_ : nullptr;
    presenter_.update({shown, workspace_.live(), view, workspace_.registry(), &stress, map, &measuring_,
                       &transient, namedParts_ ? &*namedParts_ : nullptr, warping ? &*warping : nullptr,
                       valves_ && !transientAlone_ ? valves_() : std::nullopt, stressRange_, stressLegend_,
                       pointedOrgan_, clock_ && !transientAlone_ ? clock_() : std::nullopt,
                       opener_.tissue()});
  });
  drawn_ = model_.state();
  Q_EMIT changed();
}

} // namespace viscera::app
