#include "conduction_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "viscera/circulation/signs.h"

namespace viscera::presentation {
namespace {

/// Opacities at most, while lines are in cavities and wall.
constexpr double kAroundLinesOpacity = 0.3, kOuterOpacity = 0.4;
/// How long the front of the excitation is seen behind it, ms.
constexpr double kFadingMs = 70;

/// How far the excitation is, ms in the time of the ways; before all of them where no beat is shown.
double excitationAt(const std::optional<heart::BeatClock>& clock) {
  if (!clock)
    return -std::numeric_limits<double>::infinity();
  circulation::Parameters parameters; // Those of the electrocardiogram that is drawn of the beat.
  parameters.rate = clock->ratePerMinute;
  parameters.conduction = clock->conduction;
  return circulation::excitationMs(parameters, clock->seconds);
}

double lightOf(double reachedMs, double nowMs) {
  return nowMs < reachedMs ? 0 : std::exp(-(nowMs - reachedMs) / kFadingMs);
}

/// The parts of a line on the side of a cut that stays, of two points at least.
void addKept(const scene::ConductionLine& line, const std::optional<scene::CutPlane>& cut,
             std::vector<scene::ConductionLine>& kept) {
  const auto stays = [&](Eigen::Index i) {
    return !cut || (line.points.row(i).transpose() - cut->origin).dot(cut->normal) >= 0;
  };
  for (Eigen::Index begin = 0; begin < line.points.rows();) {
    Eigen::Index end = begin;
    while (end < line.points.rows() && stays(end))
      ++end;
    if (end - begin > 1)
      kept.push_back(
          {line.points.middleRows(begin, end - begin), line.radiusMm, line.lit.segment(begin, end - begin)});
    begin = end + 1;
  }
}

} // namespace

void ConductionPicture::update(const Scene& scene, const std::optional<scene::CutPlane>& cut) {
  Moment moment{{}, scene.clock, cut};
  if (scene.view.conduction && !scene.view.shown.stress)
    for (const auto& organ : *scene.state.organs)
      if (!organ->ways.empty() && organ->look.visible)
        moment.surfaces[organ->id] = {scene.organs.sharedPoints(organ->id), scene.organs.revision(organ->id)};
  if (moment.surfaces.empty()) {
    if (std::exchange(drawn_, std::nullopt))
      glyphs_.set({});
    return;
  }
  if (scene.view.shown.rest)
    moment.clock.reset();
  if (drawn_ == moment)
    return;
  draw(scene, moment);
  drawn_ = std::move(moment);
}

void ConductionPicture::draw(const Scene& scene, const Moment& moment) {
  const double now = excitationAt(moment.clock);
  std::vector<scene::ConductionLine> lines;
  for (const auto& [id, surface] : moment.surfaces) {
    const document::Organ& organ = *scene.state.organ(id);
    Carrier& carrier = carriers_[id];
    if (carrier.mesh != organ.mesh || carrier.lines.size() != organ.ways.size()) {
      carrier = {organ.mesh, {}};
      for (const geometry::NamedWay& way : organ.ways)
        carrier.lines.emplace_back(way.points, organ.mesh->points);
    }
    for (std::size_t i = 0; i < organ.ways.size(); ++i) {
      const geometry::NamedWay& way = organ.ways[i];
      Points places;
      carrier.lines[i].at(*surface.first, places);
      addKept({std::move(places), way.widthMm,
               way.reachedMs.unaryExpr([now](double reached) { return lightOf(reached, now); })},
              moment.cut, lines);
    }
  }
  glyphs_.set(std::move(lines));
}

void ConductionPicture::apply(const Scene& scene,
                              std::map<document::OrganId, Appearance>& appearances) const {
  if (!drawn_)
    return;
  const auto limit = [&](const document::Organ& organ, double opacity) {
    const auto [found, fresh] = appearances.try_emplace(organ.id);
    if (fresh)
      found->second = {organ.look.visible, organ.look.opacity};
    found->second.opacity = std::min(found->second.opacity, opacity);
  };
  for (const auto& organ : *scene.state.organs)
    if (drawn_->surfaces.count(organ->id) > 0)
      limit(*organ, kAroundLinesOpacity);
  for (const auto& organ : *scene.state.organs) {
    const bool around =
        std::any_of(drawn_->surfaces.begin(), drawn_->surfaces.end(),
                    [&](const auto& inside) { return scene.state.organ(inside.first)->parent == organ->id; });
    if (around && !drawn_->cut)
      limit(*organ, kOuterOpacity);
  }
}

} // namespace viscera::presentation
