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

void StillOrgans::setRig(const RigInput& input, document::SystemChoice system) {
  document::Rig rig;
  for (std::size_t i = 0; i < input.labels.size(); ++i) {
    document::Handle handle;
    handle.id.value = static_cast<std::int64_t>(i) + 1;
    handle.label = input.labels[i];
    handle.rest = input.handles.positions.row(static_cast<Eigen::Index>(i)).transpose();
    rig.handles.push_back(std::move(handle));
  }
  for (std::size_t i = 0; i < input.handles.groups.size(); ++i) {
    document::Group group;
    group.id.value = static_cast<std::int64_t>(i) + 1;
    group.name = input.handles.groups[i].name;
    group.color = input.groupColors[i];
    for (const int row : input.handles.groups[i].handles)
      group.handles.push_back(rig.handles[static_cast<std::size_t>(row)].id);
    rig.groups.push_back(std::move(group));
  }
  for (const auto& triangle : input.handles.cage.rowwise())
    rig.cage.push_back({rig.handles[static_cast<std::size_t>(triangle[0])].id,
                        rig.handles[static_cast<std::size_t>(triangle[1])].id,
                        rig.handles[static_cast<std::size_t>(triangle[2])].id});
  pose_ = input.handles.positions;
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
