#pragma once

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "viscera/coordinates/handle_set.h"

/// The configurations of resources/lines, for tests of modules that have no readers below them.
namespace viscera::tests {

inline const Vec3 kLineFrom(-50, 0, 0);
inline const Vec3 kLineTo(50, 0, 0);

/// The `count` handles (9, 10, 11, 14, 15 or 26) around the line.
inline coordinates::HandleSet handlesAroundLine(int count) {
  char name[32];
  std::snprintf(name, sizeof name, "line_%02d.fcsv", count);
  std::ifstream file(std::string(VISCERA_SOURCE_DIR "/resources/lines/") + name);
  std::vector<Vec3> rows;
  for (std::string line, cell; std::getline(file, line);) {
    if (line.starts_with('#'))
      continue;
    std::istringstream cells(line);
    std::getline(cells, cell, ',');
    Vec3& row = rows.emplace_back();
    for (int axis = 0; axis < 3; ++axis) {
      std::getline(cells, cell, ',');
      row[axis] = std::stod(cell);
    }
  }
  coordinates::HandleSet handles;
  handles.positions.resize(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    handles.positions.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
  return handles;
}

} // namespace viscera::tests
