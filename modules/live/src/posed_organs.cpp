#include "viscera/live/posed_organs.h"

#include "bound_organ.h"

namespace viscera::live {

PosedCopy::PosedCopy(std::unique_ptr<BoundOrgans> organs) : organs_(std::move(organs)) {}
PosedCopy::PosedCopy(PosedCopy&&) noexcept = default;
PosedCopy::~PosedCopy() = default;

void PosedCopy::showPose(const Points& pose) {
  organs_->setShownPose(pose);
  organs_->poseAll(false);
}

const Points& PosedCopy::shownPose() const {
  return *organs_->shownPose;
}

std::shared_ptr<const Points> PosedCopy::sharedPoints(document::OrganId organ) const {
  return organs_->require(organ).sharedPoints();
}

std::uint64_t PosedCopy::revision(document::OrganId organ) const {
  return organs_->require(organ).revision;
}

OrganVolume PosedCopy::volume(document::OrganId organ) {
  return organs_->volume(organ);
}

Values PosedCopy::influence(document::OrganId organ, document::HandleId handle) const {
  return organs_->require(organ).influence(handle);
}

const deformation::Deformer* PosedCopy::bound(document::OrganId organ) const {
  return organs_->require(organ).bound();
}

} // namespace viscera::live
