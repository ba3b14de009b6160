#include "heart_picture.h"

namespace viscera::presentation {
namespace {

bool sameHeart(const OpenedHeart& a, const OpenedHeart& b) {
  return a.heart.outer == b.heart.outer && a.heart.cavities == b.heart.cavities && a.blood == b.blood;
}

} // namespace

HeartPicture::~HeartPicture() {
  leave();
}

void HeartPicture::leave() {
  if (!opened_)
    return;
  view_.remove(actor_);
  opened_.reset();
  ++revision_;
}

void HeartPicture::take(std::shared_ptr<const live::HeartTissue> tissue) {
  if (tissue_ == tissue)
    return;
  leave();
  tissue_ = std::move(tissue);
  actor_ = std::make_shared<scene::OrganActor>(tissue_->mesh(), threads_);
  actor_->setRole(scene::SurfaceRole::picture);
  points_ = std::make_shared<Points>();
  moment_.clear();
  plane_.reset();
}

void HeartPicture::update(const Scene& scene, bool numbers) {
  std::optional<OpenedHeart> wanted;
  if (scene.heartTissue && !numbers)
    wanted = openedHeart(scene.state, scene.view);
  if (!wanted || !scene.heartTissue->isOf(wanted->heart))
    return leave();
  take(scene.heartTissue);
  if (!opened_)
    view_.add(actor_);
  if (!opened_ || !sameHeart(*opened_, *wanted))
    ++revision_;
  opened_ = std::move(wanted);
  follow(scene.organs);
}

void HeartPicture::follow(const live::PosedOrgans& organs) {
  const live::SampleHeartOrgans& heart = opened_->heart;
  const auto placeOf = [&](const document::Organ& organ) {
    return std::pair(organs.sharedPoints(organ.id), organs.revision(organ.id));
  };
  Moment now = {placeOf(*heart.outer)};
  for (const auto& cavity : heart.cavities)
    now.push_back(placeOf(*cavity));
  if (now == moment_)
    return;
  const bool first = moment_.empty();
  moment_ = std::move(now);
  tissue_->at(heart, organs, *points_, threads_);
  if (first)
    actor_->setPoints(points_);
  else
    actor_->pointsChanged();
  ++revision_;
}

void HeartPicture::apply(std::map<document::OrganId, Appearance>& appearances) const {
  if (!opened_)
    return;
  const auto hide = [&](const document::Organ& organ) {
    Appearance& appearance =
        appearances.try_emplace(organ.id, Appearance{organ.look.visible, organ.look.opacity}).first->second;
    appearance.drawn = false;
    appearance.opacity = 1; // Names are hidden by tissue, which is opaque.
  };
  hide(*opened_->heart.outer);
  if (!opened_->blood)
    for (const auto& cavity : opened_->heart.cavities)
      hide(*cavity);
}

void HeartPicture::updateLook(const scene::OrganActor& outer, const scene::CutPlane& plane) {
  const document::OrganLook& look = opened_->heart.outer->look;
  actor_->setColor(shownColor(look.color));
  actor_->setVertexColorsShown(look.vertexColors);
  actor_->setSelected(outer.selected());
  if (plane_ != plane)
    actor_->setClipPlane(plane.origin, plane.normal);
  plane_ = plane;
}

} // namespace viscera::presentation
