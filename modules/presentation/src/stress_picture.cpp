#include "stress_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <vtkActor.h>
#include <vtkRenderer.h>

#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"

namespace viscera::presentation {
namespace {

constexpr int kMostGlyphs = 300;
/// The radius of a glyph, of the distance between them.
constexpr double kGlyphSize = 0.33;
/// Handles this little on the side that is cut away stay, of the organ's radius.
constexpr double kHandleSlack = 0.08;
/// The opacity of organs around the one with the map, at most.
constexpr double kAroundMap = 0.15;

bool stressWanted(const Scene& scene) {
  // A map that is given, such as the difference of two poses, takes the stress map's place.
  return scene.view.shown.stress && scene.stress && scene.stress->organ && !scene.map;
}

bool inRange(double value, const StressLook& look) {
  return !look.threshold || !std::isfinite(value) || (look.below ? value <= look.limit : value >= look.limit);
}

} // namespace

StressPicture::StressPicture(scene::OrganView& view) : view_(view), markGlyphs_(view) {
  glyphs_.setRenderer(view.renderer());
  probe_.setRenderer(view.renderer());
  plane_->SetRenderer(view.renderer());
  view.setAlsoFramed([this]() -> std::optional<Bounds> {
    if (!tissue_ || !tissue_->visible())
      return std::nullopt;
    return boundsOf(tissue_->points());
  });
}

StressPicture::~StressPicture() {
  view_.setAlsoFramed(nullptr);
  view_.renderer()->RemoveViewProp(plane_);
  dropTissue();
}

void StressPicture::dropTissue() {
  if (tissue_)
    for (vtkActor* actor : {tissue_->faces(), tissue_->cut()})
      view_.handles()->RemoveOccluder(actor);
  tissue_.reset();
  mesh_.reset();
  glyphPoints_.clear();
}

/// Whether the organ's own surface carries the map; else the tetrahedra do.
bool StressPicture::onSurface(const Scene& scene) const {
  const StressLook& look = scene.view.stress;
  return look.onSurface && !look.threshold && look.glyphs == GlyphChoice::none && scene.stress->onSurface &&
         !(look.cut && look.style == scene::CutStyle::crinkle);
}

void StressPicture::takeMesh(const live::StressFrame& frame) {
  dropTissue();
  mesh_ = frame.mesh;
  if (!mesh_)
    return;
  const Bounds box = boundsOf(mesh_->points);
  middle_ = box.center();
  radius_ = 0.5 * (box.high - box.low).maxCoeff();
  plane_->SetBall(middle_, radius_);
  tissue_ = std::make_unique<scene::TissueActor>(
      std::shared_ptr<const scene::Tetrahedra>(mesh_, &mesh_->tetrahedra),
      std::shared_ptr<const Points>(mesh_, &mesh_->points));
  tissue_->setVisible(false);
  tissue_->setRenderer(view_.renderer());
  for (vtkActor* actor : {tissue_->faces(), tissue_->cut()})
    view_.handles()->AddOccluder(actor);
  // Props that are seen through the tissue have to be drawn after it.
  probe_.setRenderer(view_.renderer());
  view_.renderer()->RemoveViewProp(plane_);
}

void StressPicture::hideAll() {
  if (tissue_)
    tissue_->setVisible(false);
  glyphs_.setVisible(false);
  probe_.hide();
  readMarks_ = {};
  markGlyphs_.setItems({});
  view_.renderer()->RemoveViewProp(plane_);
}

void StressPicture::update(const Scene& scene) {
  if (!stressWanted(scene)) {
    made_.reset();
    values_.update({}, scene.view.stress);
    if (!scene.stress || !scene.stress->mesh)
      dropTissue();
    return hideAll();
  }
  const live::StressFrame& frame = *scene.stress;
  const StressLook& look = scene.view.stress;
  plane_->SetTheme(view_.theme());
  probe_.setTheme(view_.theme());
  markGlyphs_.setTheme(view_.theme());
  if (Made now{frame.revision, frame.mesh, frame.cycle, look, scene.state.stressMarks, scene.stressRange};
      made_ == now)
    return;
  else
    made_ = std::move(now);
  if (frame.mesh != mesh_)
    takeMesh(frame);
  values_.update(frame, look, scene.stressRange);
  ++revision_;
  updateCut(look);
  updateTissue(scene);
  updateGlyphs(frame, look);
  updateProbe(frame, look);
  updateMarks(scene);
}

void StressPicture::updateCut(const StressLook& look) {
  plane_->SetPlane({middle_ + look.offset * radius_ * look.normal, look.normal});
  if (!tissue_)
    return;
  if (look.cut) {
    view_.renderer()->AddViewProp(plane_);
    tissue_->setCut(plane_->GetPlane(), look.style);
  } else {
    view_.renderer()->RemoveViewProp(plane_);
    tissue_->clearCut();
  }
}

void StressPicture::updateTissue(const Scene& scene) {
  if (!tissue_)
    return;
  const StressLook& look = scene.view.stress;
  const bool surface = onSurface(scene);
  const bool any = drawn() && scene.stress->points;
  tissue_->setVisible(any && (!surface || look.cut));
  if (!any)
    return;
  tissue_->setPoints(scene.stress->points);
  tissue_->setValues(values_.values());
  tissue_->setColors(values_.colors(), values_.range());
  tissue_->setGhost(look.glyphs != GlyphChoice::none);
  tissue_->setOutsideShown(!surface);
  if (surface)
    (*scene.stress->onSurface)(*values_.values(), *surfaceValues_);
  if (!look.threshold)
    return tissue_->clearShownRange();
  constexpr double kEverything = std::numeric_limits<double>::infinity();
  tissue_->setShownRange(look.below ? scene::ValueRange{-kEverything, look.limit}
                                    : scene::ValueRange{look.limit, kEverything});
}

std::map<document::OrganId, Appearance> StressPicture::appearances(const Scene& scene) const {
  std::map<document::OrganId, Appearance> all;
  if (!stressWanted(scene))
    return all;
  const StressLook& look = scene.view.stress;
  const bool surface = onSurface(scene);
  const auto cut = look.cut && drawn() ? std::optional(plane_->GetPlane()) : std::nullopt;
  for (const auto& organ : *scene.state.organs) {
    Appearance& seen = all[organ->id];
    seen.opacity = organ->look.opacity;
    if (organ->id == scene.stress->organ) {
      seen.visible = !drawn() || surface;
      seen.clip = cut;
      if (drawn())
        seen.opacity = 1;
      if (drawn() && surface)
        seen.values = surfaceValues_;
      continue;
    }
    // The organ's cavities are left out of the tissue: what is seen there are their walls, cut likewise.
    const bool cavity = organ->parent == scene.stress->organ;
    const bool walls = cavity && cut && !look.threshold && look.glyphs == GlyphChoice::none;
    seen.visible = organ->look.visible && (cavity ? walls : look.others);
    if (!cavity && drawn()) // Opaque ones would hide the map.
      seen.opacity = std::min(seen.opacity, kAroundMap);
    if (walls)
      seen.clip = cut;
  }
  return all;
}

/// Handles on the side that is cut away go with it: else they would hide the cut.
ShownWhere StressPicture::shownWhere(const Scene& scene) const {
  const StressLook& look = scene.view.stress;
  if (!stressWanted(scene) || (look.handles && !(look.cut && tissue_)))
    return nullptr;
  if (!look.handles)
    return [](const Vec3&) { return false; };
  return [plane = plane_->GetPlane(), slack = kHandleSlack * radius_](const Vec3& place) {
    return (place - plane.origin).dot(plane.normal) >= -slack;
  };
}

bool StressPicture::kept(const Vec3& point, const StressLook& look) const {
  const scene::CutPlane plane = plane_->GetPlane();
  return !look.cut || (point - plane.origin).dot(plane.normal) >= 0;
}

void StressPicture::updateGlyphs(const live::StressFrame& frame, const StressLook& look) {
  const bool shown = drawn() && frame.points && look.glyphs != GlyphChoice::none;
  glyphs_.setVisible(shown);
  if (!shown)
    return;
  if (glyphPoints_.empty()) {
    glyphPoints_ = deformation::thinnedPoints(mesh_->points, mesh_->witnesses, kMostGlyphs);
    const double volume = deformation::tetrahedronVolumes(mesh_->points, mesh_->tetrahedra).cwiseAbs().sum();
    glyphs_.setRadius(kGlyphSize * std::cbrt(volume / static_cast<double>(glyphPoints_.size())));
  }
  glyphs_.setColors(values_.colors(), values_.range());
  glyphs_.setShape(look.glyphs == GlyphChoice::ellipsoids ? scene::StretchGlyphs::Shape::ellipsoids
                                                          : scene::StretchGlyphs::Shape::crosses);
  std::vector<scene::StretchGlyph> all;
  for (const int point : glyphPoints_) {
    scene::StretchGlyph glyph;
    glyph.position = frame.points->row(point);
    glyph.value = (*values_.values())[point];
    if (!kept(glyph.position, look) || !inRange(glyph.value, look))
      continue;
    const auto stretches = frame.stretchesAt(point);
    glyph.directions = stretches.directions;
    glyph.stretches = stretches.stretches;
    all.push_back(glyph);
  }
  glyphs_.set(all);
}

void StressPicture::updateProbe(const live::StressFrame& frame, const StressLook& look) {
  if (frame.points && look.probe >= 0 && look.probe < frame.points->rows())
    probe_.show(frame.points->row(look.probe).transpose());
  else
    probe_.hide();
}

/// Pinned probes with their numbers, and their lines as the pose has bent them, as far as they are tissue.
void StressPicture::updateMarks(const Scene& scene) {
  const live::StressFrame& frame = *scene.stress;
  const bool any = frame.points && drawn();
  readMarks_ = any ? marksReader_.read(scene.state, frame.organ, frame.mesh, *frame.points,
                                       values_.peak() ? *frame.cycle->peak : *frame.map)
                   : live::ReadMarks();
  std::vector<scene::MeasurementGlyphs::Item> items;
  for (const live::ReadProfile& read : readMarks_.profiles) {
    bool joined = false;
    for (const live::StressReading& reading : read.profile.readings) {
      if (reading.inTissue && !joined)
        items.push_back({{}, {}, false, true});
      if (reading.inTissue)
        items.back().points.push_back(reading.now);
      joined = reading.inTissue;
    }
  }
  for (const live::ReadProbe& read : readMarks_.probes)
    items.push_back(
        {{read.reading.inTissue ? read.reading.now : read.probe.rest}, std::to_string(read.probe.number)});
  if (!items.empty() || !markGlyphs_.items().empty())
    markGlyphs_.setItems(std::move(items));
}

} // namespace viscera::presentation
