#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"

namespace viscera::coordinates {

/// The coordinate systems that a program offers, each with its source. Ids are unique. Reading from several
/// threads is safe while no thread adds a system.
class Registry {
public:
  /// A system and its source: `kBuiltIn` or the file of the plugin that contains it.
  struct Entry {
    std::shared_ptr<const CoordinateSystem> system;
    std::string source;
  };

  static constexpr const char* kBuiltIn = "built-in";

  /// Adds a system after the existing ones. Throws `UsageError` with the reason, and leaves the registry
  /// unchanged, for: no system, an id that could not be typed on a command line (small letters, digits and
  /// single dashes), an id that is taken (with its source), or parameters whose names repeat or whose
  /// standard value is out of range.
  void add(std::shared_ptr<const CoordinateSystem> system, const std::string& source);

  /// The system with that id. Throws `UsageError` that lists the existing ids.
  std::shared_ptr<const CoordinateSystem> find(const std::string& id) const;

  /// Whether there is a system with that id.
  bool contains(const std::string& id) const;

  /// Every system in the order in which it was added.
  const std::vector<Entry>& list() const { return entries_; }

private:
  std::vector<Entry> entries_;
};

/// A registry that holds `builtInSystems()`, each with the source `Registry::kBuiltIn`.
Registry builtInRegistry();

} // namespace viscera::coordinates
