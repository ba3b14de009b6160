#pragma once

#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "viscera/core/arrays.h"

namespace viscera::sample_organs {

/// The fields of one JSON object of a definition. Every reader throws a `DataError` that names the file, the
/// place and the field; `requireNothingElse` finds misspelt fields.
class Fields {
public:
  /// `where` names file and node for messages, as in `heart.json, node "LV_epi", children[1]`. Keeps a
  /// reference to `object`. Throws when it is not an object.
  Fields(const nlohmann::json& object, std::string where);

  const std::string& where() const { return where_; }
  bool has(const std::string& key) const;

  /// A field that must be there. Any of these marks its field as known.
  const nlohmann::json& get(const std::string& key);
  double number(const std::string& key);
  double positive(const std::string& key);
  Vec3 vector(const std::string& key);
  std::string text(const std::string& key);
  /// A list with at least `least` items.
  const nlohmann::json& list(const std::string& key, std::size_t least = 1);

  /// A field that may be missing: null then.
  const nlohmann::json* optional(const std::string& key);
  double number(const std::string& key, double otherwise);
  double positive(const std::string& key, double otherwise);
  /// Also throws when outside [low, high].
  int integer(const std::string& key, int otherwise, int low, int high);
  Vec3 vector(const std::string& key, const Vec3& otherwise);
  /// A direction: not zero; returned with length 1.
  Vec3 direction(const std::string& key);

  /// Calls `read` with the fields of the object `key`, if it exists; `read` has to read all of them.
  template <class Read>
  void optionalPart(const std::string& key, const Read& read) {
    if (const nlohmann::json* content = optional(key)) {
      Fields part(*content, where_ + ", " + key);
      read(part);
      part.requireNothingElse();
    }
  }

  /// Marks a field as known without reading it.
  void ignore(const std::string& key) { known_.insert(key); }
  /// Throws when the object has a field that was not read ("comment" is always allowed).
  void requireNothingElse() const;

  /// Throws `DataError`: what is wrong with `key`, and what to try.
  [[noreturn]] void fail(const std::string& key, const std::string& what,
                         const std::string& tryThis = {}) const;

private:
  const nlohmann::json& object_;
  std::string where_;
  std::set<std::string> known_ = {"comment"};
};

/// Three numbers; throws `DataError` with `where` and `key` for anything else.
Vec3 vectorFrom(const nlohmann::json& value, const std::string& where, const std::string& key);

/// The name in `names` that is most similar to `wrong`, or an empty string when none is similar.
std::string nearestName(const std::string& wrong, const std::set<std::string>& names);

/// The names of a map.
template <class Map>
std::set<std::string> namesOf(const Map& map) {
  std::set<std::string> names;
  for (const auto& item : map)
    names.insert(item.first);
  return names;
}

/// `names` as `"a", "b" and "c"`.
std::string listed(const std::set<std::string>& names);

} // namespace viscera::sample_organs
