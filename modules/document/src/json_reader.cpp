#include "viscera/document/json_reader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <system_error>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

namespace viscera::document {
namespace {

using nlohmann::ordered_json;

/// Nothing that the program writes is nested as deep; writing it again would need a stack without end.
constexpr int kDeepest = 64;
constexpr double kLargestWhole = 9007199254740992.0; ///< 2^53

} // namespace

std::string readText(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    throw NoInputError("It is not a file that can be read", file.string(), "check the name");
  std::ifstream stream(file, std::ios::binary);
  if (!stream.is_open())
    throw NoInputError("It cannot be read", file.string(), "check its permissions");
  return restOf(stream, file.string());
}

void JsonReader::fail(const std::string& problem, const std::string& place) const {
  fail(problem, place, format_.tryThis);
}

void JsonReader::fail(const std::string& problem, const std::string& place,
                      const std::string& tryThis) const {
  throw DataError(problem, place.empty() ? where_ : where_ + ", " + place, tryThis);
}

ordered_json JsonReader::parse(const std::string& text) const {
  ordered_json root;
  try {
    root = ordered_json::parse(toUtf8(text), [this](int depth, ordered_json::parse_event_t, ordered_json&) {
      if (depth > kDeepest)
        fail("It is nested too deeply", "");
      return true;
    });
  } catch (const ordered_json::exception& error) {
    // nlohmann's "[json.exception...] parse error at line 3, column 5: ..." without its prefix.
    const std::string message = error.what();
    const std::size_t end = message.find("] ");
    fail(phrase("It is not complete JSON: %1", end == message.npos ? message : message.substr(end + 2)), "");
  }
  requireFormat(root);
  return root;
}

void JsonReader::requireFormat(const ordered_json& root) const {
  if (!root.is_object() || root.value("format", ordered_json()) != format_.id)
    fail(phrase("It is no %1: its \"format\" is not \"%2\"", format_.kind, format_.id), "", format_.advice);
  const ordered_json& version = field(root, "version", "");
  if (!version.is_number_integer() || version.get<std::int64_t>() < 1)
    fail("\"version\" is not a positive whole number", "");
  if (version.get<std::int64_t>() > format_.version)
    fail(phrase("It is of version %1; this program reads up to %2", version.dump(), format_.version), "",
         "update Viscera");
  for (const auto& [key, wanted] : {std::pair("coordinateSystem", "LPS"), std::pair("units", "mm")})
    if (root.contains(key) && root.at(key) != wanted)
      fail(phrase("\"%1\" is %2 instead of \"%3\"", key,
                  root.at(key).is_string() ? root.at(key).dump() : root.at(key).type_name(), wanted),
           "");
}

const ordered_json& JsonReader::field(const ordered_json& object, const char* key,
                                      const std::string& place) const {
  const auto found = object.find(key);
  if (found == object.end())
    fail(phrase("It has no \"%1\"", key), place);
  return *found;
}

std::string JsonReader::textOf(const ordered_json& object, const char* key, const std::string& place) const {
  const ordered_json& value = field(object, key, place);
  if (!value.is_string() || value.get_ref<const std::string&>().empty())
    fail(phrase("\"%1\" is not a text", key), place);
  return value.get<std::string>();
}

bool JsonReader::flagOf(const ordered_json& object, const char* key, const std::string& place) const {
  const ordered_json& value = field(object, key, place);
  if (!value.is_boolean())
    fail(phrase("\"%1\" is neither true nor false", key), place);
  return value.get<bool>();
}

double JsonReader::numberOf(const ordered_json& value, const std::string& place) const {
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    fail("It is not a finite number", place);
  return value.get<double>();
}

std::int64_t JsonReader::wholeOf(const ordered_json& value, const std::string& place) const {
  if (!value.is_number_integer() || !(value.get<double>() >= 0) || value.get<double>() > kLargestWhole)
    fail("It is not a whole number from 0 to 2^53", place);
  return value.get<std::int64_t>();
}

Vec3 JsonReader::vectorOf(const ordered_json& value, const std::string& place) const {
  if (!value.is_array() || value.size() != 3)
    fail("It is not a list of three numbers", place);
  return {numberOf(value[0], place), numberOf(value[1], place), numberOf(value[2], place)};
}

Vec3 JsonReader::colorOf(const ordered_json& value, const std::string& place) const {
  const Vec3 color = vectorOf(value, place);
  if ((color.array() < 0).any() || (color.array() > 1).any())
    fail("its colour does not lie between 0 and 1", place);
  return color;
}

const ordered_json& JsonReader::listOf(const ordered_json& object, const char* key,
                                       const std::string& place) const {
  const ordered_json& list = field(object, key, place);
  if (!list.is_array())
    fail(phrase("\"%1\" is not a list", key), place);
  return list;
}

void JsonReader::requireObject(const ordered_json& value, const std::string& place) const {
  if (!value.is_object())
    fail("It is not an object", place);
}

void JsonReader::takeObject(const ordered_json& value, std::initializer_list<const char*> known,
                            const std::string& place) {
  requireObject(value, place);
  for (const auto& [key, unread] : value.items()) {
    const bool isKnown =
        std::any_of(known.begin(), known.end(), [&name = key](const char* one) { return name == one; });
    if (!isKnown)
      unknown_.push_back(place.empty() ? key : place + "." + key);
  }
}

ordered_json listOf(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

} // namespace viscera::document
