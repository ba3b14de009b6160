#include "viscera/document/selection.h"

#include <algorithm>
#include <utility>

namespace viscera::document {

Selection::Selection(Document& document)
    : document_(document), subscription_(document.onDerive([this](const Change& change) {
        if (change.rig() || change.organs())
          drop();
      })) {}

bool Selection::contains(HandleId handle) const {
  return std::find(handles_.begin(), handles_.end(), handle) != handles_.end();
}

void Selection::setHandles(const std::vector<HandleId>& handles) {
  std::vector<HandleId> present;
  for (const HandleId handle : handles)
    if (document_.rig().indexOf(handle) >= 0 &&
        std::find(present.begin(), present.end(), handle) == present.end())
      present.push_back(handle);
  if (std::exchange(handles_, present) != present)
    document_.announce(changed_.emission());
}

void Selection::toggle(HandleId handle) {
  std::vector<HandleId> handles = handles_;
  if (std::erase(handles, handle) == 0)
    handles.push_back(handle);
  setHandles(handles);
}

void Selection::setOrgan(OrganId organ) {
  const OrganId present = document_.organ(organ) ? organ : OrganId{};
  if (!present)
    removed_.clear(); // None is selected on purpose.
  if (std::exchange(organ_, present) != present)
    document_.announce(changed_.emission());
}

void Selection::setGroup(GroupId group) {
  const GroupId present = document_.rig().indexOf(group) >= 0 ? group : GroupId{};
  if (std::exchange(group_, present) != present)
    document_.announce(changed_.emission());
}

void Selection::clear() {
  const bool any = !handles_.empty() || organ_ || group_;
  handles_.clear();
  organ_ = {};
  removed_.clear();
  group_ = {};
  if (any)
    document_.announce(changed_.emission());
}

void Selection::drop() {
  const Rig& rig = document_.rig();
  auto gone = std::erase_if(handles_, [&rig](HandleId handle) { return rig.indexOf(handle) < 0; });
  if (followOrgan())
    ++gone;
  if (group_ && rig.indexOf(group_) < 0) {
    group_ = {};
    ++gone;
  }
  if (gone > 0)
    document_.announce(changed_.emission());
}

/// Forgets the organ when it has gone and takes up one that is back. Returns whether the selected one has
/// changed.
bool Selection::followOrgan() {
  const OrganId before = organ_;
  const auto isThere = [this](OrganId organ) { return document_.organ(organ) != nullptr; };
  if (organ_ && !isThere(organ_))
    removed_.push_back(std::exchange(organ_, {}));
  const auto back = std::find_if(removed_.rbegin(), removed_.rend(), isThere);
  if (!organ_ && back != removed_.rend())
    organ_ = *back;
  std::erase_if(removed_, isThere);
  return organ_ != before;
}

} // namespace viscera::document
