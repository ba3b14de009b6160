#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "viscera/core/arrays.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

/// Reads JSON: one parser for all files, and checks that name the file and the place of an error. No
/// exception of the JSON library leaves these functions. From any thread.
namespace viscera {

/// Thrown for JSON that is not what its reader expects.
struct JsonError : DataError {
  using DataError::DataError;

  std::size_t line = 0;   ///< The line of the mistake in a text that is no JSON, from 1; else 0.
  std::string missingKey; ///< The key that an object lacks; empty for another mistake.
};

/// A whole file as text. Throws `NoInputError` when it cannot be read.
std::string readText(const std::filesystem::path& file);

enum class JsonComments { refused, skipped };

/// The value that a text describes. Bytes that are no UTF-8 are read as Latin-1; of two equal keys the last
/// one counts. Throws `JsonError` for a text that is no JSON, is cut off, or is nested more than 64 deep;
/// `where` names the file and `tryThis` says what to try. O(n) for `nlohmann::json`; an `ordered_json` keeps
/// the order of keys and takes O(k^2) for an object with k keys. Made for these two types.
template <class Json>
Json parseJson(std::string_view text, const std::string& where, const Text& tryThis,
               JsonComments comments = JsonComments::refused);

/// A finite number; nothing for another value.
template <class Json>
std::optional<double> finiteNumber(const Json& value) {
  if (!value.is_number() || !std::isfinite(value.template get<double>()))
    return std::nullopt;
  return value.template get<double>();
}

/// Three finite numbers; nothing for another value.
template <class Json>
std::optional<Vec3> threeNumbers(const Json& value) {
  if (!value.is_array() || value.size() != 3)
    return std::nullopt;
  Vec3 numbers;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::optional<double> number = finiteNumber(value[axis]);
    if (!number)
      return std::nullopt;
    numbers[static_cast<Eigen::Index>(axis)] = *number;
  }
  return numbers;
}

/// The text `key` of an object; empty when it is not there or no text.
template <class Json>
std::string textIn(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->template get<std::string>() : std::string();
}

/// The flag `key` of an object; `otherwise` when it is not there or no flag.
template <class Json>
bool flagIn(const Json& object, const char* key, bool otherwise) {
  const auto found = object.find(key);
  return found != object.end() && found->is_boolean() ? found->template get<bool>() : otherwise;
}

/// Reads values from a JSON file with checks; every `JsonError` names the file, the place in it and what to
/// try. `place` is the path of a value in the file, such as `organs[2].look`; empty for the outermost object.
class JsonReader {
public:
  /// A file format that the program writes and reads.
  struct Format {
    const char* id;      ///< The value of "format".
    int version;         ///< The latest that is known.
    const char* kind;    ///< "session"
    const char* advice;  ///< For a file of another kind.
    const char* tryThis; ///< For a damaged one.
  };

  JsonReader(std::string where, const Format& format)
      : where_(std::move(where)), tryThis_(format.tryThis), format_(format) {}
  /// Reads files that do not state their format.
  JsonReader(std::string where, Text tryThis) : where_(std::move(where)), tryThis_(std::move(tryThis)) {}

  [[noreturn]] void fail(const Text& problem, const std::string& place) const;
  [[noreturn]] void fail(const Text& problem, const std::string& place, const Text& tryThis) const;

  /// The outermost object. Where there is a format, the object is of this format and not later than this
  /// version, in mm and LPS.
  nlohmann::ordered_json parse(const std::string& text) const;

  const nlohmann::ordered_json& field(const nlohmann::ordered_json& object, const char* key,
                                      const std::string& place) const;
  /// A text that is not empty.
  std::string textOf(const nlohmann::ordered_json& object, const char* key, const std::string& place) const;
  bool flagOf(const nlohmann::ordered_json& object, const char* key, const std::string& place) const;
  /// A finite number.
  double numberOf(const nlohmann::ordered_json& value, const std::string& place) const;
  /// A whole number from 0 to 2^53.
  std::int64_t wholeOf(const nlohmann::ordered_json& value, const std::string& place) const;
  Vec3 vectorOf(const nlohmann::ordered_json& value, const std::string& place) const;
  /// Red, green and blue from 0 to 1.
  Vec3 colorOf(const nlohmann::ordered_json& value, const std::string& place) const;
  const nlohmann::ordered_json& listOf(const nlohmann::ordered_json& object, const char* key,
                                       const std::string& place) const;
  void requireObject(const nlohmann::ordered_json& value, const std::string& place) const;
  void requireList(const nlohmann::ordered_json& value, const std::string& place) const;

  /// Reads a value of the type of `out`. A text may be empty, a whole number is from -2^53 to
  /// 2^53, and a pair may have more numbers, which are left out.
  void read(const nlohmann::ordered_json& value, const std::string& place, bool& out) const;
  void read(const nlohmann::ordered_json& value, const std::string& place, int& out) const;
  void read(const nlohmann::ordered_json& value, const std::string& place, std::int64_t& out) const;
  void read(const nlohmann::ordered_json& value, const std::string& place, double& out) const;
  void read(const nlohmann::ordered_json& value, const std::string& place, std::string& out) const;
  void read(const nlohmann::ordered_json& value, const std::string& place, Vec3& out) const;
  void read(const nlohmann::ordered_json& value, const std::string& place, std::array<double, 2>& out) const;
  template <class Item>
  void read(const nlohmann::ordered_json& value, const std::string& place, std::vector<Item>& out) const;
  template <class Item>
  void read(const nlohmann::ordered_json& value, const std::string& place,
            std::map<std::string, Item>& out) const;

  /// The field `key`, which has to be there.
  template <class Value>
  Value valueOf(const nlohmann::ordered_json& object, const char* key, const std::string& place) const {
    Value value{};
    read(field(object, key, place), inside(place, key), value);
    return value;
  }
  /// Reads the field `key` into `value`, which stays as it is when the object has none.
  template <class Value>
  void readIfThere(const nlohmann::ordered_json& object, const char* key, const std::string& place,
                   Value& value) const {
    if (const auto found = object.find(key); found != object.end())
      read(*found, inside(place, key), value);
  }
  /// Calls `visit` with each item of the list `key`, which may be left out, and with the item's place.
  template <class Visit>
  void eachOf(const nlohmann::ordered_json& object, const char* key, const std::string& place,
              Visit visit) const {
    if (!object.contains(key))
      return;
    const nlohmann::ordered_json& list = listOf(object, key, place);
    for (std::size_t i = 0; i < list.size(); ++i)
      visit(list[i], at(inside(place, key), i));
  }

  /// Returns the result of `find` for a name, or throws an error that lists the known names.
  template <class Value>
  Value named(std::optional<Value> (*find)(const std::string&), const nlohmann::ordered_json& object,
              const char* key, const std::string& place, const std::string& known) const {
    const std::string name = textOf(object, key, place);
    const auto value = find(name);
    if (!value)
      fail(diagnostic("there is no %1 \"%2\"", key, name), place, phrase("use one of: %1", known));
    return *value;
  }

  /// An object; those of its keys that are none of these are remembered for `unknownKeys`.
  void takeObject(const nlohmann::ordered_json& value, std::initializer_list<const char*> known,
                  const std::string& place);
  /// Keys that were not read, such as "organs[2].look.shine".
  const std::vector<std::string>& unknownKeys() const { return unknown_; }

  /// A place in a list: "organs[2]".
  static std::string at(const std::string& list, std::size_t index);
  /// The place of a field: "organs[2].look".
  static std::string inside(const std::string& place, const std::string& key);

  const std::string& where() const { return where_; }

private:
  void requireFormat(const nlohmann::ordered_json& root) const;
  [[noreturn]] void failWithout(const char* key, const std::string& place) const;

  std::string where_;
  Text tryThis_;
  std::optional<Format> format_;
  std::vector<std::string> unknown_;
};

template <class Item>
void JsonReader::read(const nlohmann::ordered_json& value, const std::string& place,
                      std::vector<Item>& out) const {
  requireList(value, place);
  out.clear();
  for (std::size_t i = 0; i < value.size(); ++i)
    read(value[i], at(place, i), out.emplace_back());
}

template <class Item>
void JsonReader::read(const nlohmann::ordered_json& value, const std::string& place,
                      std::map<std::string, Item>& out) const {
  requireObject(value, place);
  out.clear();
  for (const auto& [key, item] : value.items())
    read(item, inside(place, key), out[key]);
}

/// Three numbers as a JSON array.
nlohmann::ordered_json jsonOf(const Vec3& v);

} // namespace viscera
