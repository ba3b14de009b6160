#include "viscera/presentation/presenter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <set>
#include <utility>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "conduction_picture.h"
#include "cut_picture.h"
#include "handle_picture.h"
#include "heart_picture.h"
#include "organ_picture.h"
#include "seen_document.h"
#include "standing_picture.h"
#include "stress_picture.h"
#include "untranslated.h"
#include "valve_picture.h"
#include "viscera/anatomy/part.h"
#include "viscera/presentation/slice_presenter.h"
#include "viscera/presentation/space_parts.h"
#include "viscera/scene/legend.h"

namespace viscera::presentation {
namespace {

constexpr double kPercent = 100;
/// Areas and volumes below are written with two decimals.
constexpr double kSmall = 10;
constexpr double kGlassOpacity = 0.15;
constexpr const char* kChords = "Chordae tendineae";
constexpr const char* kSpread = "\u00b1 %1, %2 to %3, %4, %5 voxels";

Vec3 missingColor(const scene::ColorMap& colors) {
  return Vec3(colors.missing[0], colors.missing[1], colors.missing[2]) / 255;
}

/// The organs and parts that are labelled in the view.
struct LabelChoice {
  std::shared_ptr<const document::OrganList> organs;
  bool ofOrgans = false;
  bool ofParts = false;
  std::optional<std::vector<Part>> parts; ///< Of these alone.
  bool ofConduction = false;
  std::vector<std::pair<document::OrganId, Eigen::Index>> chords = {}; ///< See `ValvePicture::chordNames`.
  std::vector<HeartPicture::VesselName> vessels = {};
  std::vector<HeartPicture::SeptumName> septa = {};
  /// Cavities of the opened heart that the cut does not open: what is on their walls cannot be seen.
  std::vector<document::OrganId> closed = {};
  bool full = false; ///< Blood hides what is in the heart's cavities.

  bool operator==(const LabelChoice&) const = default;
};

/// The texts of the legend.
struct LegendText {
  std::string title;
  std::string unit;
  std::string mark;
  scene::ColorMap colors;
  scene::ValueRange range;

  bool operator==(const LegendText& other) const {
    return title == other.title && unit == other.unit && mark == other.mark && range == other.range &&
           colors.name == other.colors.name;
  }
};

/// Whether the cut takes something away of a surface.
bool takesFrom(const Points& points, const scene::CutPlane& plane) {
  return (points * plane.normal).minCoeff() < plane.origin.dot(plane.normal);
}

/// Whether a part is on the inside of a cavity that is closed; a valve is seen from the other side, too.
bool isShutAway(const Part& part, const document::OrganList& organs,
                const std::vector<document::OrganId>& closed) {
  if (std::find(closed.begin(), closed.end(), part.organ) == closed.end())
    return false;
  const auto organ =
      std::find_if(organs.begin(), organs.end(), [&](const auto& other) { return other->id == part.organ; });
  return organ != organs.end() && (*organ)->places[part.place].ringMm <= 0;
}

OrgansSeen organsSeenIn(const Scene& scene) {
  OrgansSeen seen = scene.view.organsSeen;
  if (!scene.map || !scene.map->glassAround)
    return seen;
  for (const auto& organ : *scene.state.organs)
    if (scene.map->values.count(organ->id) == 0) {
      OrganSeen& glass =
          seen.try_emplace(organ->id, OrganSeen{organ->look.visible, organ->look.opacity}).first->second;
      glass.opacity = std::min(glass.opacity, kGlassOpacity);
    }
  return seen;
}

} // namespace

struct Presenter::Parts {
  Parts(scene::OrganView& viewIn, Threads threads, Translate translateIn)
      : view(viewIn), translate(translateIn ? std::move(translateIn) : untranslated), organs(viewIn, threads),
        handles(viewIn), stress(viewIn), heart(viewIn, threads), cut(viewIn), valves(viewIn),
        conduction(viewIn), labels(viewIn), measurements(viewIn), standing(viewIn, threads) {}

  scene::OrganView& view;
  Translate translate;
  SeenDocument seen;
  OrganPicture organs;
  HandlePicture handles;
  StressPicture stress;
  HeartPicture heart;
  CutPicture cut;
  ValvePicture valves;
  ConductionPicture conduction;
  scene::OrganLabels labels;
  scene::MeasurementGlyphs measurements;
  document::MeasuringMemory measured; ///< Gaps are measured in every frame of a drag.
  StandingPicture standing;

  LabelChoice labelled; ///< Whose names are written.
  /// Rig of the hulls that are drawn.
  std::shared_ptr<const document::Rig> hullRig;
  std::shared_ptr<const document::SystemChoice> hullSystem;
  std::optional<scene::LayoutParts> hullParts;
  /// What the influences that are drawn depend on.
  document::HandleId influenceOf;
  std::map<document::OrganId, std::shared_ptr<const Points>> influenceBound;
  SurfaceMap influence;
  std::uint64_t mapsMade = 0;
  std::optional<LegendText> legend;

  void update(const Scene& scene);
  void updateInfluence(const Scene& scene);
  const SurfaceMap* mapOf(const Scene& scene) const;
  void updateLooks(const Scene& scene, std::map<document::OrganId, Appearance>& appearances,
                   const MapColors& colors);
  void updateColors(const Scene& scene);
  void updateLegend(std::optional<LegendText> wanted);
  void updateRegions(const Scene& scene);
  void updateLabels(const Scene& scene, bool others);
  void addConduction(const Scene& scene, std::vector<scene::OrganLabels::Item>& items) const;
  void addOpened(std::vector<scene::OrganLabels::Item>& items) const;
  void updateMeasurements(const Scene& scene);
  std::optional<LegendText> stressLegend(const Scene& scene) const;
};

/// The influence of the current handle on all organs. It hangs on the bindings alone, so it is asked for only
/// when one of them is another.
void Presenter::Parts::updateInfluence(const Scene& scene) {
  const auto& selected = scene.view.selection.handles;
  const document::HandleId handle = selected.empty() ? document::HandleId{} : selected.back();
  const int row = scene.state.rig->indexOf(handle);
  std::map<document::OrganId, std::shared_ptr<const Points>> bound;
  if (scene.view.influence && !scene.view.shown.stress && row >= 0)
    for (const auto& organ : *scene.state.organs)
      bound[organ->id] = scene.organs.sharedPoints(organ->id);
  if (handle != influenceOf || bound != influenceBound) {
    influence.values.clear();
    for (const auto& [id, points] : bound)
      if (Values values = scene.organs.influence(id, handle); values.size() > 0)
        influence.values[id] = std::make_shared<const Values>(kPercent * values);
    influenceOf = handle;
    influenceBound = std::move(bound);
    ++mapsMade;
  }
  if (influence.values.empty())
    return;
  influence.range = {0, 0};
  for (const auto& [id, values] : influence.values)
    if (scene.state.organ(id)->look.visible)
      influence.range.high = std::max(influence.range.high, values->maxCoeff());
  if (influence.range.high <= 0)
    influence.range.high = kPercent;
  influence.colors = scene::viridis();
  std::string title = translate("Influence of %1");
  title.replace(title.find("%1"), 2,
                translate(scene.state.rig->handles[static_cast<std::size_t>(row)].label.c_str()));
  influence.title = std::move(title);
  influence.unit = "%";
}

/// The numbers that organs show as colours; null: their own colours, or the stress.
const SurfaceMap* Presenter::Parts::mapOf(const Scene& scene) const {
  if (scene.map)
    return scene.map;
  return influence.values.empty() ? nullptr : &influence;
}

void Presenter::Parts::updateLooks(const Scene& scene, std::map<document::OrganId, Appearance>& appearances,
                                   const MapColors& colors) {
  cut.apply(scene, appearances);
  heart.apply(appearances);
  organs.updateLooks(scene, appearances, colors);
  if (!heart.opened() || !cut.plane())
    return;
  for (const auto& cavity : heart.opened()->heart.cavities)
    organs.actorOf(cavity->id)->setRole(scene::SurfaceRole::hollow);
  heart.updateLook(*organs.actorOf(heart.opened()->heart.outer->id), *cut.plane());
  heart.updateSepta(*cut.plane(), scene.organs);
}

/// Whatever colours the organs: a map that is given, the stress, an influence, or their own looks.
void Presenter::Parts::updateColors(const Scene& scene) {
  const SurfaceMap* map = mapOf(scene);
  auto appearances = stress.appearances(scene);
  if (!map || !appearances.empty()) {
    valves.apply(scene, appearances);
    conduction.apply(scene, appearances);
    updateLooks(scene, appearances, stress.colors());
    return updateLegend(stressLegend(scene));
  }
  for (const auto& [id, values] : map->values)
    if (const auto organ = scene.state.organ(id))
      appearances[id] = {organ->look.visible, organ->look.opacity, std::nullopt, values};
  updateLooks(scene, appearances, {map->colors, map->range, mapsMade});
  updateLegend(LegendText{map->title, map->unit, map->mark, map->colors, map->range});
}

std::optional<LegendText> Presenter::Parts::stressLegend(const Scene& scene) const {
  const StressValues& values = stress.values();
  if (!scene.view.shown.stress || !stress.drawn() || !scene.stressLegend)
    return std::nullopt;
  const live::StressQuantityDescription& quantity = live::describe(values.quantity());
  const Wording wording{
      [this](const std::string& pattern, std::optional<int>) { return translate(pattern.c_str()); },
      std::string(1, view.decimalMark())};
  // Folded tissue has a value on its own map, and its colour.
  const bool marked = values.folded() > 0 && quantity.quantity != live::StressQuantity::folded;
  return LegendText{translate((values.peak() ? quantity.peakName : quantity.name).c_str()),
                    inWords(values.measure().unit(), wording), marked ? translate("folded") : std::string(),
                    values.colors(), values.legendRange()};
}

void Presenter::Parts::updateLegend(std::optional<LegendText> wanted) {
  if (wanted == legend)
    return;
  legend = std::move(wanted);
  if (!legend)
    return view.legend().hide();
  view.legend().show(legend->title, legend->unit, legend->colors, legend->range);
  view.legend().setMark(legend->mark, missingColor(legend->colors));
}

void Presenter::Parts::updateRegions(const Scene& scene) {
  const auto wanted = scene.view.shown.regions ? std::optional(scene.view.layout) : std::nullopt;
  const bool sameSpace = !wanted || (hullRig == scene.state.rig && hullSystem == scene.state.system);
  if (sameSpace && wanted == hullParts)
    return;
  hullRig = scene.state.rig;
  hullSystem = scene.state.system;
  hullParts = wanted;
  auto hulls = wanted ? regionHulls(scene.state, *wanted, scene.systems) : std::vector<scene::RegionHull>();
  if (!hulls.empty() || !view.regions().hulls().empty())
    view.regions().setHulls(std::move(hulls));
}

void Presenter::Parts::updateLabels(const Scene& scene, bool others) {
  labels.setTheme(view.theme());
  labels.setShown(scene.view.labels || scene.view.partNames || scene.parts);
  LabelChoice wanted{scene.state.organs, scene.view.labels, scene.view.partNames, std::nullopt};
  if (scene.parts)
    wanted.parts = *scene.parts;
  wanted.ofConduction = conduction.drawn() && scene.view.partNames && !scene.parts;
  if (scene.view.partNames && !scene.parts) {
    if (!heart.full()) // Blood hides them.
      wanted.chords = valves.chordNames();
    if (cut.plane()) {
      wanted.vessels = heart.vesselNames(*cut.plane());
      wanted.septa = heart.septa();
    }
    if (cut.plane() && heart.opened())
      for (const auto& cavity : heart.opened()->heart.cavities)
        if (!takesFrom(cavity->mesh->points, *cut.plane()))
          wanted.closed.push_back(cavity->id);
  }
  wanted.full = heart.full() && !scene.parts;
  if (!others && labelled == wanted)
    return;
  labelled = std::move(wanted);
  std::vector<scene::OrganLabels::Item> items;
  const std::vector<Part> named = labelled.ofOrgans ? partsOf(*scene.state.organs) : std::vector<Part>();
  for (const auto& organ : *scene.state.organs) {
    if (!labelled.ofOrgans)
      break;
    const auto inside = [&](const auto& other) { return other->parent == organ->id; };
    const bool full = std::any_of(scene.state.organs->begin(), scene.state.organs->end(), inside);
    items.push_back({labelOf(*organ, translate), organs.actorOf(organ->id), full});
    for (const Part& part : named)
      if (part.organ == organ->id)
        items.back().places.push_back(part.vertex);
  }
  std::vector<Part> parts;
  if (labelled.parts)
    parts = *labelled.parts;
  else if (labelled.ofParts)
    parts = partsOf(*scene.state.organs);
  for (const Part& part : parts)
    if ((!labelled.full || !heart.isCavity(part.organ)) &&
        !isShutAway(part, *scene.state.organs, labelled.closed))
      items.push_back({translate(nameOf(part, *scene.state.organs).c_str()), organs.actorOf(part.organ),
                       false, part.vertex});
  if (labelled.ofConduction)
    addConduction(scene, items);
  addOpened(items);
  labels.setItems(std::move(items));
}

/// The names of the conduction system's parts, each once, beside the middle of its line.
void Presenter::Parts::addConduction(const Scene& scene, std::vector<scene::OrganLabels::Item>& items) const {
  std::set<std::string> named;
  for (const auto& organ : *scene.state.organs)
    for (const geometry::NamedWay& way : organ->ways) {
      if (!organ->look.visible || !named.insert(way.name).second)
        continue;
      const Eigen::RowVector3d middle = way.points.row(way.points.rows() / 2);
      Eigen::Index vertex = 0;
      (organ->mesh->points.rowwise() - middle).rowwise().squaredNorm().minCoeff(&vertex);
      items.push_back({translate(way.name.c_str()), organs.actorOf(organ->id), false, vertex});
    }
}

/// The names of what only the picture of an opened heart has: chords, vessels that no part is named after,
/// and the septa in the face of the cut.
void Presenter::Parts::addOpened(std::vector<scene::OrganLabels::Item>& items) const {
  using Lies = scene::OrganLabels::Lies;
  for (const auto& [ventricle, point] : labelled.chords)
    items.push_back({translate(kChords),
                     organs.actorOf(ventricle),
                     false,
                     point,
                     {},
                     valves.chordPoints(),
                     Lies::inHollow});
  if (!heart.opened())
    return;
  const document::Organ& outer = *heart.opened()->heart.outer;
  for (const HeartPicture::VesselName& vessel : labelled.vessels) {
    const bool part = std::any_of(outer.places.begin(), outer.places.end(),
                                  [&](const auto& place) { return place.name == vessel.name; });
    if (!part)
      items.push_back({translate(vessel.name.c_str()),
                       organs.actorOf(outer.id),
                       false,
                       vessel.point,
                       {},
                       heart.vesselLines(),
                       vessel.inFace ? Lies::inFace : Lies::onSurface});
  }
  for (const HeartPicture::SeptumName& septum : labelled.septa)
    items.push_back(
        {translate(septum.name), organs.actorOf(outer.id), false, 0, {}, septum.middle, Lies::inFace});
}

/// The document's measurements in their order, and behind them what is being measured.
void Presenter::Parts::updateMeasurements(const Scene& scene) {
  measurements.setTheme(view.theme());
  measurements.setShown(scene.view.measurements);
  std::vector<std::shared_ptr<const Points>> kept;
  const auto pointsOf = [&](document::OrganId organ) -> const Points& {
    return *kept.emplace_back(scene.organs.sharedPoints(organ));
  };
  const document::TissueMotion tissue =
      scene.warping && scene.view.scan.warped ? scene.warping->posed : document::TissueMotion();
  std::vector<scene::MeasurementGlyphs::Item> items;
  for (const document::Measurement& measurement : *scene.state.measurements) {
    if (document::isRegion(measurement.kind)) { // Seen on slices; items are in the document's order.
      items.emplace_back();
      continue;
    }
    document::MeasuredValues values =
        document::measure(measurement, scene.state, pointsOf, &measured, tissue);
    const bool chosen = scene.measuring && std::count(scene.measuring->highlighted.begin(),
                                                      scene.measuring->highlighted.end(), measurement.id);
    items.push_back(
        {std::move(values.places),
         measurement.name + ": " + formatMeasured(measurement.kind, values.now, {}, view.decimalMark()),
         chosen});
  }
  if (scene.measuring && !scene.measuring->pending.points.empty() &&
      !document::isRegion(scene.measuring->pending.kind)) {
    document::Measurement pending = scene.measuring->pending;
    const bool single = pending.points.size() == 1;
    if (single)
      pending.points.push_back(pending.points.front());
    document::MeasuredValues values = document::measure(pending, scene.state, pointsOf, nullptr, tissue);
    scene::MeasurementGlyphs::Item item{std::move(values.places), {}, true};
    if (single)
      item.points.resize(1);
    else if (item.points.size() == document::pointCount(pending.kind)) // An angle's first leg has no value.
      item.text = formatMeasured(pending.kind, values.now, {}, view.decimalMark());
    items.push_back(std::move(item));
  }
  if (!items.empty() || !measurements.items().empty())
    measurements.setItems(std::move(items));
}

Presenter::Presenter(scene::OrganView& view, Threads threads, Translate translate)
    : view_(view), parts_(std::make_unique<Parts>(view, threads, std::move(translate))) {}

Presenter::~Presenter() {
  view_.regions().setHulls({});
}

void Presenter::update(const Scene& scene) {
  parts_->update({parts_->seen.of(scene.state, organsSeenIn(scene)), scene.organs, scene.view, scene.systems,
                  scene.stress, scene.map, scene.measuring, scene.transient, scene.parts, scene.warping,
                  scene.valves, scene.stressRange, scene.stressLegend, scene.pointedOrgan, scene.clock,
                  scene.heartTissue});
}

void Presenter::Parts::update(const Scene& scene) {
  const bool others = organs.updateOrgans(scene);
  organs.updateTransientSurfaces(scene.transient ? *scene.transient : std::vector<TransientSurface>());
  stress.update(scene);
  updateInfluence(scene);
  heart.update(scene, mapOf(scene) != nullptr);
  cut.update(scene, heart);
  valves.update(scene, cut.plane(), heart);
  conduction.update(scene, cut.plane());
  updateColors(scene);
  handles.update(scene, stress.shownWhere(scene));
  updateRegions(scene);
  updateLabels(scene, others);
  updateMeasurements(scene);
  standing.update(scene);
  const bool empty = scene.state.organs->empty() && scene.state.rig->handles.empty() &&
                     (!scene.transient || scene.transient->empty());
  view.setOrientationCubeShown(scene.view.orientationCube && !empty);
  view.setScaleBarShown(scene.view.scaleBar && !empty);
}

document::OrganId Presenter::organOf(const scene::OrganActor* actor) const {
  return parts_->organs.organOf(actor);
}
std::shared_ptr<scene::OrganActor> Presenter::actorOf(document::OrganId organ) const {
  return parts_->organs.actorOf(organ);
}
const scene::OrganActor* Presenter::heartTissue() const {
  return parts_->heart.actor();
}
bool Presenter::heartBlood() const {
  return parts_->heart.full();
}
const scene::OrganLabels& Presenter::labels() const {
  return parts_->labels;
}
const scene::MeasurementGlyphs& Presenter::measurements() const {
  return parts_->measurements;
}
const StressValues& Presenter::stressValues() const {
  return parts_->stress.values();
}
scene::TissueActor* Presenter::tissue() const {
  return parts_->stress.tissue();
}
const scene::StretchGlyphs& Presenter::glyphs() const {
  return parts_->stress.glyphs();
}
const scene::ProbeMarker& Presenter::probe() const {
  return parts_->stress.probe();
}
const scene::MeasurementGlyphs& Presenter::stressMarks() const {
  return parts_->stress.marks();
}
const live::ReadMarks& Presenter::readMarks() const {
  return parts_->stress.readMarks();
}
const scene::ValveGlyphs& Presenter::valves() const {
  return parts_->valves.glyphs();
}
const scene::ConductionGlyphs& Presenter::conduction() const {
  return parts_->conduction.glyphs();
}
vtkVisceraCutPlaneRepresentation* Presenter::cutPlane() const {
  return parts_->stress.plane();
}
Vec3 Presenter::stressMiddle() const {
  return parts_->stress.middle();
}
double Presenter::stressRadius() const {
  return parts_->stress.radius();
}

Camera cameraOf(const scene::OrganView& view) {
  vtkCamera& eye = *view.renderer()->GetActiveCamera();
  Camera camera;
  eye.GetPosition(camera.position.data());
  eye.GetFocalPoint(camera.focus.data());
  eye.GetViewUp(camera.up.data());
  camera.angleDegrees = eye.GetViewAngle();
  camera.parallel = eye.GetParallelProjection() != 0;
  camera.parallelScaleMm = eye.GetParallelScale();
  return camera;
}

void lookFrom(const Camera& camera, scene::OrganView& view) {
  if (camera.position == camera.focus)
    return;
  vtkCamera& eye = *view.renderer()->GetActiveCamera();
  eye.SetPosition(camera.position.data());
  eye.SetFocalPoint(camera.focus.data());
  eye.SetViewUp(camera.up.data());
  eye.SetViewAngle(camera.angleDegrees);
  eye.SetParallelProjection(camera.parallel ? 1 : 0);
  eye.SetParallelScale(camera.parallelScaleMm);
  view.renderer()->ResetCameraClippingRange();
}

void lookFrom(const Camera& camera, const ViewState& state, scene::OrganView& view) {
  lookFrom(camera, view);
  if (state.shown.stress || state.influence)
    view.expectLegend();
}

Vec3 shownColor(const Vec3& color) {
  const double vivid = color.maxCoeff() - color.minCoeff();
  if (!document::isPure(color))
    return color;
  const double middle = 0.5 * (color.maxCoeff() + color.minCoeff());
  return (middle + (color.array() - middle) * (document::kMostVivid / vivid)).matrix();
}

namespace {} // namespace

std::string labelOf(const document::Organ& organ, const Presenter::Translate& translate) {
  const Presenter::Translate& say = translate ? translate : Presenter::Translate(untranslated);
  const std::optional<anatomy::Part> chamber = anatomy::chamberNamed(organ.name);
  if (chamber && organ.name == anatomy::abbreviationOf(*chamber))
    return say((organ.name + " cavity").c_str());
  if (std::string said = say(organ.name.c_str()); said != organ.name)
    return said;
  return say(anatomy::readableName(organ.name).c_str());
}

std::string formatMeasured(document::MeasurementKind kind, double value, const std::string& unit,
                           char decimalMark) {
  if (!std::isfinite(value))
    return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  const std::string number = scene::withDecimalMark(text, decimalMark);
  if (document::isRegion(kind))
    return unit.empty() ? number : number + (' ' + unit);
  return number + std::string(document::isLength(kind) ? " mm" : "\u00b0");
}

std::string describeSpread(const document::Measurement& measurement, const document::MeasuredValues& values,
                           const std::string& unit, const Presenter::Translate& translate, char decimalMark) {
  const auto region = document::regionOf(measurement);
  if (!region || !values.region || values.region->count == 0)
    return {};
  const auto* rectangle = std::get_if<medical_io::RectangleRegion>(&*region);
  const double size =
      rectangle ? rectangle->areaMm2() : std::get<medical_io::SphereRegion>(*region).volumeMl();
  const auto number = [decimalMark](const char* format, double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return scene::withDecimalMark(text, decimalMark);
  };
  const std::string parts[] = {
      number("%.1f", values.region->deviation), number("%.0f", values.region->minimum),
      number("%.0f", values.region->maximum) + (unit.empty() ? "" : ' ' + unit),
      number(size < kSmall ? "%.2f" : "%.0f", size) + (rectangle ? " mm\u00b2" : " ml"),
      std::to_string(values.region->count)};
  std::string text = translate ? translate(kSpread) : kSpread;
  for (std::size_t i = 0; i < std::size(parts); ++i)
    if (const std::size_t at = text.find('%' + std::to_string(i + 1)); at != std::string::npos)
      text.replace(at, 2, parts[i]);
  return text;
}

} // namespace viscera::presentation
