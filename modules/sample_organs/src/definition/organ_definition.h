#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "viscera/core/arrays.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::sample_organs {

/// A surface of a definition.
struct SurfaceDefinition {
  std::string name;
  std::string organ;                                    ///< Its name when it is an organ of its own.
  bool checkOnly = false;                               ///< Generated only when requested by name.
  bool hidden = false;                                  ///< Not shown at first.
  Vec3 color = {0.8, 0.45, 0.4};                        ///< Red green blue, 0 to 1.
  std::array<int, 3> triangles = {3000, 30000, 150000}; ///< Low, medium, high.
  double largestSpacing = 1.6;                          ///< mm between samples of the field.
  std::vector<geometry::NamedPlace> places;             ///< Parts that have names.
  std::vector<geometry::NamedWay> ways;                 ///< Along which it is excited.
  std::vector<geometry::NamedVessel> vessels;           ///< Drawn only: those in its walls.
  nlohmann::json paint; ///< Of a joined surface: the node whose colours the body's part has; null: its own.
  nlohmann::json root;  ///< Null when it is joined from other surfaces.
  std::array<std::string, 3> from; ///< Of a joined surface: the body's surface, low, medium, high ...
  std::vector<std::string> less;   ///< ... and those of the lumina that are taken out of it.
  std::string where;               ///< File and surface, for messages.

  const std::string& fromAt(Resolution resolution) const {
    return from[static_cast<std::size_t>(resolution)];
  }
  bool joined() const { return !less.empty(); }
  int trianglesAt(Resolution resolution) const { return triangles[static_cast<std::size_t>(resolution)]; }
};

/// A named node, not yet built.
struct NodeDefinition {
  nlohmann::json node;
  std::string where; ///< File and node, for messages.
};

/// One definition file with those that it includes, read but not built.
struct OrganDefinition {
  std::string name;
  std::string file;                            ///< The file's name, for messages.
  std::map<std::string, NodeDefinition> nodes; ///< Of this file and of the included ones.
  std::vector<SurfaceDefinition> surfaces;     ///< Of this file only, the outer surface first.
  std::uint64_t contentHash = 0;               ///< Of the bytes of all files read.

  /// Throws `UsageError` that lists the existing surfaces.
  const SurfaceDefinition& surface(const std::string& surfaceName) const;
};

/// Reads `path` and what it includes. Throws `NoInputError` for a file that cannot be read, `DataError` for
/// one that is not a definition: not JSON (with line and column), a missing or misspelt field, a name used
/// twice, files that include each other.
OrganDefinition readDefinition(const std::filesystem::path& path);

} // namespace viscera::sample_organs
