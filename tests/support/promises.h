#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "build_paths.h"

namespace viscera::tests {

/// Reads the properties that every coordinate system promises, by its id and then by the name of the
/// property, from the committed table `tests/contract/systems/promises.csv`. Tests fail for a system whose
/// traits differ from it, or whose measurements by `properties` contradict it.
inline std::map<std::string, std::map<std::string, bool>> promises() {
  std::ifstream file(std::filesystem::path(VISCERA_SOURCE_DIR) / "tests/contract/systems/promises.csv");
  std::map<std::string, std::map<std::string, bool>> table;
  std::vector<std::string> header;
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');)
      cells.push_back(cell);
    if (header.empty())
      header = cells;
    else
      for (std::size_t i = 1; i < header.size(); ++i)
        table[cells.at(0)][header[i]] = cells.at(i) == "yes";
  }
  return table;
}

} // namespace viscera::tests
