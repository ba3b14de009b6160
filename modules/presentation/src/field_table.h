#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "viscera/core/arrays.h"
#include "viscera/core/json_reader.h"
#include "viscera/document/ids.h"

// The structs of a view as JSON (docs/session_format.md). Each names its fields once, in a function that
// writes and reads it; the declaration of the struct has its defaults and its equality:
//
//     template <class Visit>
//     void visitFields(Visit& visit, OrganCut& cut) {
//       visit("on", cut.on);
//       visit("offset", cut.offset);
//       visit.afterReading([&] { cut.offset = std::clamp(cut.offset, -1.0, 1.0); });
//     }
namespace viscera::presentation {

using Json = nlohmann::ordered_json;

/// A value in the JSON of a view, and the fields that it has. Fields that are missing stay as they are.
struct FieldReader {
  const JsonReader& json;
  const Json& item;
  std::string place;

  template <class Value>
  void operator()(const char* key, Value& value, const char* = nullptr);
  /// A field without which the struct is damaged.
  template <class Value>
  void required(const char* key, Value& value);
  /// A field that is written only where it is `wanted`.
  template <class Value>
  void where(bool, const char* key, Value& value) {
    (*this)(key, value);
  }
  /// Fields in an object of their own.
  template <class Nested>
  void object(bool, const char* key, const Nested& visitNested) {
    if (!item.contains(key))
      return;
    FieldReader inside{json, item.at(key), JsonReader::inside(place, key)};
    json.requireObject(inside.item, inside.place);
    visitNested(inside);
  }
  /// Moves what was read within its bounds.
  template <class Check>
  void afterReading(const Check& check) {
    check();
  }
};

/// The same for writing.
struct FieldWriter {
  Json& item;

  template <class Value>
  void operator()(const char* key, const Value& value, const char* = nullptr);
  template <class Value>
  void operator()(const char* key, const std::optional<Value>& value) {
    if (value)
      (*this)(key, *value);
  }
  template <class Value>
  void required(const char* key, const Value& value) {
    (*this)(key, value);
  }
  template <class Value>
  void where(bool wanted, const char* key, const Value& value) {
    if (wanted)
      (*this)(key, value);
  }
  template <class Nested>
  void object(bool wanted, const char* key, const Nested& visitNested) {
    if (!wanted)
      return;
    FieldWriter inside{item[key]};
    visitNested(inside);
  }
  template <class Check>
  void afterReading(const Check&) {}
};

/// A value as JSON and back: a struct with `visitFields`, or what is specialised below. `read` throws
/// `JsonError`, which names the place, for a value of another kind.
template <class Value>
struct Codec {
  static Json write(Value value) {
    Json item = Json::object();
    FieldWriter visit{item};
    visitFields(visit, value);
    return item;
  }
  static void read(FieldReader from, Value& value) {
    from.json.requireObject(from.item, from.place);
    const Value usual;
    value = usual; // Not a temporary, of which GCC 12 believes that it is not initialised.
    visitFields(from, value);
  }
};

template <class Value>
concept PlainValue = std::is_arithmetic_v<Value> || std::same_as<Value, std::string> ||
    std::same_as<Value, std::array<double, 2>>;

template <PlainValue Value>
struct Codec<Value> {
  static Json write(const Value& value) { return value; }
  static void read(const FieldReader& from, Value& value) { from.json.read(from.item, from.place, value); }
};

template <>
struct Codec<Vec3> {
  static Json write(const Vec3& value) { return jsonOf(value); }
  static void read(const FieldReader& from, Vec3& value) { from.json.read(from.item, from.place, value); }
};

/// A value that has a text of its own.
template <class Value, auto textOf, auto valueOf>
struct TextCodec {
  static Json write(Value value) { return textOf(value); }
  static void read(const FieldReader& from, Value& value) {
    std::string text;
    from.json.read(from.item, from.place, text);
    value = valueOf(text);
  }
};

/// The names of an enumeration's values, in its order.
template <class Enum>
constexpr auto kNames = nullptr;

template <class Enum>
concept Named = requires {
  kNames<Enum>.size();
};

/// A name that is none of them, as of a newer version, gives the first value.
template <Named Enum>
struct Codec<Enum> {
  static Json write(Enum value) { return kNames<Enum>[static_cast<std::size_t>(value)]; }
  static void read(const FieldReader& from, Enum& value) {
    const auto& names = kNames<Enum>;
    const std::string name = from.item.is_string() ? from.item.get<std::string>() : std::string();
    const auto found = std::find(names.begin(), names.end(), name);
    value = static_cast<Enum>(found == names.end() ? 0 : found - names.begin());
  }
};

template <class Tag>
struct Codec<document::Id<Tag>> {
  static Json write(document::Id<Tag> id) { return id.value; }
  static void read(const FieldReader& from, document::Id<Tag>& id) {
    from.json.read(from.item, from.place, id.value);
  }
};

template <class Value>
struct Codec<std::optional<Value>> {
  static void read(const FieldReader& from, std::optional<Value>& value) {
    Codec<Value>::read(from, value.emplace());
  }
};

template <class Item>
struct Codec<std::vector<Item>> {
  static Json write(const std::vector<Item>& items) {
    Json list = Json::array();
    for (const Item& item : items)
      list.push_back(Codec<Item>::write(item));
    return list;
  }
  static void read(const FieldReader& from, std::vector<Item>& items) {
    from.json.requireList(from.item, from.place);
    items.clear();
    for (std::size_t i = 0; i < from.item.size(); ++i)
      Codec<Item>::read({from.json, from.item[i], JsonReader::at(from.place, i)}, items.emplace_back());
  }
};

template <class Value>
void FieldReader::operator()(const char* key, Value& value, const char*) {
  if (item.contains(key))
    Codec<Value>::read({json, item.at(key), JsonReader::inside(place, key)}, value);
}

template <class Value>
void FieldReader::required(const char* key, Value& value) {
  Codec<Value>::read({json, json.field(item, key, place), JsonReader::inside(place, key)}, value);
}

template <class Value>
void FieldWriter::operator()(const char* key, const Value& value, const char*) {
  item[key] = Codec<Value>::write(value);
}

} // namespace viscera::presentation
