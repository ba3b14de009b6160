#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"

/// Reads JSON files with checks that name the file and the place of an error.
namespace viscera::document {

/// A whole file as text. Throws `NoInputError` when it cannot be read.
std::string readText(const std::filesystem::path& file);

/// Reads values from a JSON file with checks; every `DataError` names the file, the place in it and what to
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

  JsonReader(std::string where, const Format& format) : where_(std::move(where)), format_(format) {}

  [[noreturn]] void fail(const std::string& problem, const std::string& place) const;
  [[noreturn]] void fail(const std::string& problem, const std::string& place,
                         const std::string& tryThis) const;

  /// The outermost object, of this format and not later than this version, in mm and LPS.
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

  /// Returns the result of `find` for a name, or throws an error that lists the known names.
  template <class Value>
  Value named(std::optional<Value> (*find)(const std::string&), const nlohmann::ordered_json& object,
              const char* key, const std::string& place, const std::string& known) const {
    const std::string name = textOf(object, key, place);
    const auto value = find(name);
    if (!value)
      fail(phrase("there is no %1 \"%2\"", key, name), place, phrase("use one of: %1", known));
    return *value;
  }

  /// An object; those of its keys that are none of these are remembered for `unknownKeys`.
  void takeObject(const nlohmann::ordered_json& value, std::initializer_list<const char*> known,
                  const std::string& place);
  /// As "organs[2].look.shine".
  const std::vector<std::string>& unknownKeys() const { return unknown_; }

  const std::string& where() const { return where_; }

private:
  void requireFormat(const nlohmann::ordered_json& root) const;

  std::string where_;
  Format format_;
  std::vector<std::string> unknown_;
};

/// Three numbers as a JSON array.
nlohmann::ordered_json listOf(const Vec3& v);

} // namespace viscera::document
