#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "viscera/coordinates/handle_set.h"

/// Arrangements of boxes of handles, one group a box, for the ways in which regions can meet.
namespace viscera::tests {

struct Box {
  Vec3 low;
  Vec3 high;
};

/// Eight corners a box; corners at one place are one handle that belongs to several groups.
inline coordinates::HandleSet groupsOfBoxes(const std::vector<Box>& boxes) {
  coordinates::HandleSet set;
  std::vector<Vec3> positions;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    coordinates::HandleGroup group{"box " + std::to_string(b + 1), {}};
    for (int i = 0; i < 8; ++i) {
      const Vec3 corner((i & 1) ? boxes[b].high[0] : boxes[b].low[0],
                        (i & 2) ? boxes[b].high[1] : boxes[b].low[1],
                        (i & 4) ? boxes[b].high[2] : boxes[b].low[2]);
      std::size_t at = 0;
      while (at < positions.size() && positions[at] != corner)
        ++at;
      if (at == positions.size())
        positions.push_back(corner);
      group.handles.push_back(static_cast<int>(at));
    }
    set.groups.push_back(group);
  }
  set.positions.resize(static_cast<Eigen::Index>(positions.size()), 3);
  for (std::size_t i = 0; i < positions.size(); ++i)
    set.positions.row(static_cast<Eigen::Index>(i)) = positions[i].transpose();
  return set;
}

struct GroupScene {
  std::string name;
  std::vector<Box> boxes;
};

inline std::vector<GroupScene> groupScenes() {
  return {
      {"TwoOverlap", {{{0, 0, 0}, {60, 40, 40}}, {{45, 5, 5}, {110, 45, 45}}}},
      {"ThreeMeetInOnePlace",
       {{{0, 0, 0}, {60, 50, 50}}, {{40, 0, 0}, {110, 50, 50}}, {{30, 30, 10}, {75, 110, 45}}}},
      {"ZoneIsAFace", {{{0, 0, 0}, {50, 40, 40}}, {{50, 0, 0}, {110, 40, 40}}}},
      {"ZoneIsAnEdge", {{{0, 0, 0}, {50, 40, 40}}, {{50, 40, 0}, {110, 90, 40}}}},
      {"ZoneIsAPoint", {{{0, 0, 0}, {50, 40, 40}}, {{50, 40, 40}, {110, 90, 90}}}},
      {"OneInsideAnother", {{{0, 0, 0}, {100, 100, 100}}, {{30, 35, 40}, {60, 65, 70}}}},
      {"ChainOfFour",
       {{{0, 0, 0}, {40, 40, 40}},
        {{30, 2, 2}, {75, 42, 42}},
        {{65, 0, 0}, {110, 38, 38}},
        {{100, 1, 1}, {150, 41, 41}}}},
  };
}

} // namespace viscera::tests
