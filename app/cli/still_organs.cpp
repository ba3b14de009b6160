#include "cli/still_organs.h"

#include <utility>

#include "viscera/core/error.h"

namespace viscera::app::cli {

StillOrgans::StillOrgans(std::vector<document::Organ> organs) {
  document::OrganList list;
  for (document::Organ& organ : organs) {
    organ.id.value = static_cast<std::int64_t>(list.size()) + 1;
    list.push_back(std::make_shared<const document::Organ>(std::move(organ)));
    points_.emplace_back(list.back()->mesh, &list.back()->mesh->points);
  }
  state_.organs = std::make_shared<const document::OrganList>(std::move(list));
}

void StillOrgans::setRig(document::Rig rig, document::SystemChoice system) {
  for (document::Handle& handle : rig.handles) {
    handle.visible = true;
    handle.locked = false;
  }
  pose_ = rig.restPositions();
  state_.rig = std::make_shared<const document::Rig>(std::move(rig));
  state_.pose = std::make_shared<const Points>(pose_);
  state_.system = std::make_shared<const document::SystemChoice>(std::move(system));
}

std::shared_ptr<const Points> StillOrgans::sharedPoints(document::OrganId organ) const {
  const auto place = static_cast<std::size_t>(organ.value - 1);
  if (place >= points_.size())
    throw UsageError("There is no such organ", "organ " + std::to_string(organ.value));
  return points_[place];
}

} // namespace viscera::app::cli
