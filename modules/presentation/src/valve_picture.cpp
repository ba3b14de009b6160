#include "valve_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "viscera/heart/valve_leaflets.h"

namespace viscera::presentation {
namespace {

using heart::HeartValve;
using heart::ValveRing;

/// The cavity that carries each ring, and the blood that flows through it.
constexpr std::array<std::size_t, heart::kHeartValves> kCarrier = {0, 0, 1, 1};
constexpr std::array<const char*, 2> kCavities = {"lv", "rv"};
constexpr std::array<const char*, 2> kAtria = {"la", "ra"};
const std::array<Vec3, 2> kBlood = {Vec3(0.98, 0.25, 0.20), Vec3(0.33, 0.55, 0.98)};

/// How long an arrow is at a metre a second, and at most, mm; its shaft has this part of the opening's
/// radius.
constexpr double kMmPerMetrePerSecond = 32;
constexpr double kLongestMm = 75;
/// Leaflets that shut push back a little blood through a gap that is gone in a moment: no long arrow.
constexpr double kMmPerFlow = 0.25; ///< At most, for each ml/s.
constexpr double kShaft = 0.34;
constexpr double kThinnestMm = 0.9;
/// The part of the arrow that is behind the valve.
constexpr double kDownstream = 0.62;
/// Smaller flows are not drawn, ml/s.
constexpr double kLeastFlow = 8;
/// The cavities' opacity is at most this while leaflets are in them.
constexpr double kCavityOpacity = 0.3;

Points lineOf(const heart::Leaflets& leaflets, int leaflet, int across) {
  using heart::Leaflets;
  Points line(Leaflets::kAlong + 1, 3);
  for (int i = 0; i <= Leaflets::kAlong; ++i)
    line.row(i) = leaflets.points.row(leaflet * Leaflets::kPointsEach + i * (Leaflets::kAcross + 1) + across);
  return line;
}

scene::ValveGlyph glyphOf(const heart::Leaflets& leaflets, int count) {
  scene::ValveGlyph glyph{leaflets.points, leaflets.triangles, {}, {}};
  for (int leaflet = 0; leaflet < count; ++leaflet) {
    glyph.rims.push_back(lineOf(leaflets, leaflet, 0));
    glyph.edges.push_back(lineOf(leaflets, leaflet, heart::Leaflets::kAcross));
  }
  return glyph;
}

/// The arrow is as thick as the opening allows, as long as the blood is fast, and points backwards with it.
std::optional<scene::FlowArrow> arrowOf(const ValveRing& ring, const heart::ValveInstant& valve,
                                        const Vec3& color) {
  if (std::abs(valve.flowMlPerS) < kLeastFlow || !(valve.areaMm2 > 0))
    return std::nullopt;
  const double metresPerSecond = valve.flowMlPerS / valve.areaMm2;
  const double length = std::min({kMmPerMetrePerSecond * std::abs(metresPerSecond),
                                  kMmPerFlow * std::abs(valve.flowMlPerS), kLongestMm});
  const Vec3 along = std::copysign(length, metresPerSecond) * ring.downstream;
  const double radius = std::max(kThinnestMm, kShaft * std::sqrt(valve.areaMm2 / std::numbers::pi));
  return scene::FlowArrow{ring.center - (1 - kDownstream) * along, ring.center + kDownstream * along, radius,
                          color};
}

} // namespace

/// The valves to draw: those that beat, or shut ones in an opened heart that stands still.
std::optional<heart::ValveInstants> ValvePicture::valvesOf(const Scene& scene) const {
  return !scene.valves && opened_ ? heart::ValveInstants() : scene.valves;
}

/// The cavities of the sample heart, when it is to be seen with its valves.
std::optional<ValvePicture::Heart> ValvePicture::heartOf(const Scene& scene) const {
  if (!valvesOf(scene) || !scene.view.valves || scene.view.shown.stress || scene.view.shown.rest)
    return std::nullopt;
  Heart heart;
  bool seen = false;
  for (const auto& organ : *scene.state.organs) {
    if (organ->origin.sample.rfind("heart@", 0) != 0)
      continue;
    seen = seen || organ->look.visible;
    for (std::size_t side = 0; side < kCavities.size(); ++side)
      if (organ->origin.surface == kCavities[side])
        heart.ventricles[side] = organ;
    if (std::find(kAtria.begin(), kAtria.end(), organ->origin.surface) != kAtria.end())
      heart.atria.push_back(organ);
  }
  return seen && heart.ventricles[0] && heart.ventricles[1] ? std::optional(heart) : std::nullopt;
}

/// The chords hold on to the walls, which are known of a heart that is cut open.
void ValvePicture::updateChords(const HeartPicture& opened) {
  if (!opened.opened()) {
    chordsMesh_.reset();
    chords_.reset();
  } else if (chordsMesh_ != opened.mesh()) {
    chordsMesh_ = opened.mesh();
    chords_.emplace(chordsMesh_->points);
  }
}

void ValvePicture::update(const Scene& scene, const std::optional<scene::CutPlane>& cut,
                          const HeartPicture& opened) {
  opened_ = opened.opened() && !opened.opened()->blood;
  updateChords(opened);
  const auto heart = heartOf(scene);
  if (!heart) {
    chordsDrawn_ = {};
    if (std::exchange(drawn_, std::nullopt))
      glyphs_.set({}, {});
    return;
  }
  Moment moment{*valvesOf(scene), {}, cut, opened.revision()};
  for (std::size_t side = 0; side < heart->ventricles.size(); ++side) {
    const document::Organ& cavity = *heart->ventricles[side];
    ventricles_[side] = cavity.id;
    moment.surfaces[side] = {scene.organs.sharedPoints(cavity.id), scene.organs.revision(cavity.id)};
    Carrier& carrier = carriers_[side];
    if (carrier.mesh == cavity.mesh)
      continue;
    carrier = {cavity.mesh, {}};
    const heart::ValveRings rings = heart::sampleHeartRings();
    for (std::size_t valve = 0; valve < rings.size(); ++valve)
      if (kCarrier[valve] == side)
        carrier.rings.emplace_back(rings[valve], cavity.mesh->points);
  }
  if (drawn_ == moment)
    return;
  draw(moment.valves, moment, opened);
  drawn_ = std::move(moment);
}

/// The chords whose muscle stays.
std::vector<Points> ValvePicture::chordsOf(HeartValve valve, const heart::Leaflets& leaflets,
                                           const ValveRing& ring, const Moment& moment,
                                           const Points& walls) const {
  std::vector<Points> lines;
  for (std::size_t i = 0; i < chords_->size(); ++i) {
    const Vec3 begin = walls.row(chords_->vertex(i)).transpose();
    const bool away = moment.cut && (begin - moment.cut->origin).dot(moment.cut->normal) < 0;
    if (chords_->chord(i).valve == valve && !away)
      lines.push_back(chords_->at(i, leaflets, ring, walls));
  }
  return lines;
}

void ValvePicture::draw(const heart::ValveInstants& valves, const Moment& moment,
                        const HeartPicture& opened) {
  chordsDrawn_ = {};
  std::vector<scene::ValveGlyph> glyphs;
  std::vector<scene::FlowArrow> arrows;
  std::array<std::size_t, 2> next{};
  for (std::size_t i = 0; i < valves.size(); ++i) {
    const std::size_t side = kCarrier[i];
    const ValveRing ring = carriers_[side].rings[next[side]++].at(*moment.surfaces[side].first);
    if (moment.cut && (ring.center - moment.cut->origin).dot(moment.cut->normal) < -ring.radius())
      continue;
    const auto valve = static_cast<HeartValve>(i);
    const heart::ValveForm form = heart::formOf(valve);
    const heart::Leaflets leaflets = heart::leafletsOf(ring, form, valves[i].areaMm2);
    glyphs.push_back(glyphOf(leaflets, form.leaflets));
    if (chords_ && !form.semilunar)
      glyphs.back().chords = chordsOf(valve, leaflets, ring, moment, *opened.surface().points);
    if (const auto& chords = glyphs.back().chords; !chords.empty()) {
      chordsDrawn_[side] = true;
      chordPoints_->row(static_cast<Eigen::Index>(side)) =
          chords.front().row(heart::HeartChords::kPointsEach / 2);
    }
    if (const auto arrow = arrowOf(ring, valves[i], kBlood[side]))
      arrows.push_back(*arrow);
  }
  glyphs_.set(glyphs, arrows);
}

std::vector<std::pair<document::OrganId, Eigen::Index>> ValvePicture::chordNames() const {
  std::vector<std::pair<document::OrganId, Eigen::Index>> names;
  for (std::size_t side = 0; side < chordsDrawn_.size(); ++side)
    if (chordsDrawn_[side])
      names.emplace_back(ventricles_[side], static_cast<Eigen::Index>(side));
  return names;
}

void ValvePicture::apply(const Scene& scene, std::map<document::OrganId, Appearance>& appearances) const {
  const auto heart = drawn_ ? heartOf(scene) : std::nullopt;
  if (!heart)
    return;
  const auto seeThrough = [&](const document::Organ& cavity) {
    const auto [found, fresh] = appearances.try_emplace(cavity.id);
    if (fresh)
      found->second = {cavity.look.visible, cavity.look.opacity};
    found->second.opacity = std::min(found->second.opacity, kCavityOpacity);
  };
  for (const auto& ventricle : heart->ventricles)
    seeThrough(*ventricle);
  for (const auto& atrium : heart->atria)
    seeThrough(*atrium);
}

} // namespace viscera::presentation
