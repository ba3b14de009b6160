#include "viscera/document/rig.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::document {
namespace {

template <class List, class Same>
int placeOf(const List& list, Same same) {
  const auto found = std::find_if(list.begin(), list.end(), same);
  return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

/// The cage by the rows of its handles.
Triangles cageRows(const Rig& rig) {
  Triangles cage(static_cast<Eigen::Index>(rig.cage.size()), 3);
  std::map<HandleId, int> rows;
  for (std::size_t i = 0; !rig.cage.empty() && i < rig.handles.size(); ++i)
    rows.emplace(rig.handles[i].id, static_cast<int>(i));
  for (Eigen::Index t = 0; t < cage.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      cage(t, k) = rows.at(rig.cage[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)]);
  return cage;
}

} // namespace

Points Rig::restPositions() const {
  Points positions(static_cast<Eigen::Index>(handles.size()), 3);
  for (std::size_t i = 0; i < handles.size(); ++i)
    positions.row(static_cast<Eigen::Index>(i)) = handles[i].rest.transpose();
  return positions;
}

int Rig::indexOf(HandleId id) const {
  return placeOf(handles, [id](const Handle& handle) { return handle.id == id; });
}

int Rig::indexOf(GroupId id) const {
  return placeOf(groups, [id](const Group& group) { return group.id == id; });
}

int Rig::indexOf(const std::string& label) const {
  return placeOf(handles, [&label](const Handle& handle) { return handle.label == label; });
}

const Group* Rig::groupOf(HandleId id) const {
  for (const Group& group : groups)
    if (std::find(group.handles.begin(), group.handles.end(), id) != group.handles.end())
      return &group;
  return nullptr;
}

void Rig::addGroup(std::string name, const Vec3& color, const std::vector<int>& rows) {
  GroupId last;
  for (const Group& group : groups)
    last = std::max(last, group.id);
  Group added{GroupId{last.value + 1}, std::move(name), color, {}};
  for (const int row : rows) {
    if (row < 0 || static_cast<std::size_t>(row) >= handles.size())
      throw UsageError(misuse("A group refers to a handle that does not exist"), added.name);
    added.handles.push_back(handles[static_cast<std::size_t>(row)].id);
  }
  groups.push_back(std::move(added));
}

int Rig::cornerCount() const {
  std::set<HandleId> corners;
  for (const CageTriangle& triangle : cage)
    corners.insert(triangle.begin(), triangle.end());
  return static_cast<int>(corners.size());
}

Rig rigAt(const Points& positions) {
  Rig rig;
  for (Eigen::Index row = 0; row < positions.rows(); ++row) {
    Handle& handle = rig.handles.emplace_back();
    handle.id = HandleId{row + 1};
    handle.rest = positions.row(row).transpose();
  }
  return rig;
}

Text describe(const Rig& rig, const std::vector<HandleId>& handles) {
  if (handles.size() == 1)
    if (const int row = rig.indexOf(handles.front()); row >= 0)
      return phrase("handle %1", named(rig.handles[static_cast<std::size_t>(row)].label));
  return phrase("%n {handle|handles}", handles.size());
}

coordinates::HandleSet handleSet(const Rig& rig) {
  coordinates::HandleSet set;
  set.positions = rig.restPositions();
  for (const Group& group : rig.groups) {
    coordinates::HandleGroup out{group.name, {}};
    for (const HandleId id : group.handles)
      out.handles.push_back(rig.indexOf(id));
    set.groups.push_back(std::move(out));
  }
  set.cage = cageRows(rig);
  return set;
}

} // namespace viscera::document
