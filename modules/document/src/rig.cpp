#include "viscera/document/rig.h"

#include <algorithm>
#include <map>
#include <set>

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

int Rig::cornerCount() const {
  std::set<HandleId> corners;
  for (const CageTriangle& triangle : cage)
    corners.insert(triangle.begin(), triangle.end());
  return static_cast<int>(corners.size());
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
