#pragma once

#include <cstdio>
#include <fstream>
#include <string>

#include "build_paths.h"
#include "viscera/coordinates/measure/scene.h"

/// The configurations of resources/lines, for tests of modules that have no readers below them.
namespace viscera::tests {

inline const Vec3 kLineFrom(-50, 0, 0);
inline const Vec3 kLineTo(50, 0, 0);

/// The `count` handles (9, 10, 11, 14, 15 or 26) around the line.
inline coordinates::HandleSet handlesAroundLine(int count) {
  char name[32];
  std::snprintf(name, sizeof name, "line_%02d.fcsv", count);
  std::ifstream file(std::string(VISCERA_SOURCE_DIR "/resources/lines/") + name);
  return coordinates::handlesOfTable(file, name);
}

} // namespace viscera::tests
