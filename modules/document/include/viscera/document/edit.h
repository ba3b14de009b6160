#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/command.h"

/// Helper functions with which commands are implemented.
namespace viscera::document::edit {

/// A command that changes one part of the document: `change` is given a copy of that part, and if it asks for
/// them the state before and the source of ids.
template <class Part, class Change>
Command onPart(Text name, std::shared_ptr<const Part> DocumentState::*part, Change change,
               std::string mergeKey = {}) {
  return {std::move(name),
          [part, change = std::move(change)](DocumentState state, IdSource& ids) {
            Part changed = *(state.*part);
            if constexpr (std::is_invocable_v<Change, Part&>)
              change(changed);
            else
              change(changed, std::as_const(state), ids);
            state.*part = std::make_shared<const Part>(std::move(changed));
            return state;
          },
          std::move(mergeKey)};
}

/// The item of a list with that id, of a `kind` ("group"). Throws `UsageError` when it is not there.
template <class Item, class AnyId>
Item& require(std::vector<Item>& list, AnyId id, const std::string& kind) {
  const auto found = std::find_if(list.begin(), list.end(), [id](const Item& item) { return item.id == id; });
  if (found == list.end())
    throw UsageError(phrase("There is no such %1 any more", named(kind)),
                     named(kind + " " + std::to_string(id.value)));
  return *found;
}

/// Removes the items with these ids. Throws as `require`.
template <class Item, class AnyId>
void remove(std::vector<Item>& list, const std::vector<AnyId>& ids, const std::string& kind) {
  for (const AnyId id : ids)
    require(list, id, kind);
  std::erase_if(list,
                [&ids](const Item& item) { return std::find(ids.begin(), ids.end(), item.id) != ids.end(); });
}

/// The organ with that id. Throws `UsageError` when it is not there.
inline std::shared_ptr<const Organ> requireOrgan(const DocumentState& state, OrganId id) {
  auto organ = state.organ(id);
  if (!organ)
    throw UsageError("There is no such organ any more", phrase("organ %1", id.value));
  return organ;
}

/// The row of a handle; throws `UsageError` when it is not there.
inline int requireHandle(const Rig& rig, HandleId id) {
  const int row = rig.indexOf(id);
  if (row < 0)
    throw UsageError("There is no such handle any more", phrase("handle %1", id.value));
  return row;
}

/// The rows of handles that nothing locks.
inline std::vector<std::pair<int, int>> freeRows(const Rig& rig, const std::vector<HandleId>& ids) {
  std::vector<std::pair<int, int>> rows; // Row in the rig, index in `ids`.
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const int row = requireHandle(rig, ids[i]);
    if (!rig.handles[static_cast<std::size_t>(row)].locked)
      rows.emplace_back(row, static_cast<int>(i));
  }
  return rows;
}

/// Throws `UsageError` unless there is one position for each handle.
inline void requireMatch(const Points& positions, const std::vector<HandleId>& ids) {
  if (positions.rows() != static_cast<Eigen::Index>(ids.size()))
    throw UsageError(misuse("There are %1 positions for %2 handles", positions.rows(), ids.size()));
}

/// `wanted`, or with the first number from 2 that makes it new.
inline std::string freeName(const std::string& wanted, const std::function<bool(const std::string&)>& taken) {
  std::string name = wanted;
  for (int number = 2; taken(name); ++number)
    name = wanted + " " + std::to_string(number);
  return name;
}

/// Converts triangles over the rows of a rig to those of the rig. Throws `UsageError` for a row that does not
/// exist.
inline std::vector<CageTriangle> cageOf(const Rig& rig, const Triangles& rows) {
  std::vector<CageTriangle> cage(static_cast<std::size_t>(rows.rows()));
  for (std::size_t t = 0; t < cage.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto row = rows(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(k));
      if (row < 0 || static_cast<std::size_t>(row) >= rig.handles.size())
        throw UsageError(misuse("The cage refers to a handle that does not exist"), phrase("triangle %1", t));
      cage[t][k] = rig.handles[static_cast<std::size_t>(row)].id;
    }
  return cage;
}

/// The state with another rig and pose.
inline DocumentState withRig(DocumentState state, Rig rig, Points pose) {
  state.rig = std::make_shared<const Rig>(std::move(rig));
  state.pose = std::make_shared<const Points>(std::move(pose));
  return state;
}

/// Points below points.
inline Points joined(const Points& a, const Points& b) {
  Points both(a.rows() + b.rows(), 3);
  both.topRows(a.rows()) = a;
  both.bottomRows(b.rows()) = b;
  return both;
}

/// The points of all organs at rest, one organ after the other.
inline Points allPoints(const OrganList& organs) {
  Eigen::Index count = 0;
  for (const auto& organ : organs)
    count += organ->mesh->points.rows();
  Points points(count, 3);
  for (const auto& organ : organs) {
    points.middleRows(points.rows() - count, organ->mesh->points.rows()) = organ->mesh->points;
    count -= organ->mesh->points.rows();
  }
  return points;
}

} // namespace viscera::document::edit
