#include "viscera/coordinates/registry.h"

#include <algorithm>
#include <set>
#include <utility>

#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::coordinates {
namespace {

/// Small letters, digits and single dashes between them: what can be typed after `--system` without quotes.
bool isPlainId(const std::string& id) {
  if (id.empty() || id.front() == '-' || id.back() == '-' || id.find("--") != std::string::npos)
    return false;
  return std::all_of(id.begin(), id.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
}

/// A parameter that the window and the command line could not offer.
void requireUsable(const std::vector<Parameter>& parameters, const std::string& where) {
  std::set<std::string> names;
  for (const auto& parameter : parameters) {
    if (parameter.name.empty())
      throw UsageError(diagnostic("The coordinate system has a parameter without a name"), where);
    if (!names.insert(parameter.name).second)
      throw UsageError(diagnostic("The coordinate system offers the parameter \"%1\" twice", parameter.name),
                       where);
    // Written so that a value that is no number is refused as well.
    if (!(parameter.minimum <= parameter.standard && parameter.standard <= parameter.maximum))
      throw UsageError(
          diagnostic("The standard value of the parameter \"%1\" is out of its own range", parameter.name),
          where);
  }
}

} // namespace

void Registry::add(std::shared_ptr<const CoordinateSystem> system, const std::string& source) {
  if (!system)
    throw UsageError(diagnostic("There is no coordinate system to add"), source);
  const std::string id = system->id();
  if (!isPlainId(id))
    throw UsageError(diagnostic("\"%1\" cannot be the id of a coordinate system", id), source,
                     diagnostic("use small letters, digits and single dashes, as in \"s-celestial\""));
  const auto taken = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& entry) { return entry.system->id() == id; });
  if (taken != entries_.end())
    throw UsageError(phrase("There is already a coordinate system \"%1\" (%2)", id, taken->source), source,
                     "remove one of the two, or give one another id");
  requireUsable(system->parameters(), source + ", " + id);
  entries_.push_back({std::move(system), source});
}

std::shared_ptr<const CoordinateSystem> Registry::find(const std::string& id) const {
  std::string known;
  for (const auto& entry : entries_) {
    const std::string present = entry.system->id();
    if (present == id)
      return entry.system;
    known += (known.empty() ? "" : ", ") + present;
  }
  throw UsageError(phrase("There is no coordinate system \"%1\"", id), {},
                   known.empty() ? Text("none is loaded") : phrase("use one of: %1", known));
}

bool Registry::contains(const std::string& id) const {
  return std::any_of(entries_.begin(), entries_.end(),
                     [&](const Entry& entry) { return entry.system->id() == id; });
}

Registry builtInRegistry() {
  Registry registry;
  for (auto& system : builtInSystems())
    registry.add(std::move(system), Registry::kBuiltIn);
  return registry;
}

} // namespace viscera::coordinates
