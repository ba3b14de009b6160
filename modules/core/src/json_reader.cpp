#include "viscera/core/json_reader.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <system_error>
#include <utility>

#include "viscera/core/text.h"

namespace viscera {
namespace {

using nlohmann::ordered_json;

/// Nothing that the program writes is nested as deep; writing it again would need a stack without end.
constexpr int kDeepest = 64;
constexpr double kLargestWhole = 9007199254740992.0; ///< 2^53

/// "look" for "organs[2].look".
std::string keyOf(const std::string& place) {
  return place.substr(place.find_last_of('.') + 1);
}

} // namespace

std::string readText(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    throw NoInputError("It is not a file that can be read", file.string(), "check the name and the folder");
  std::ifstream stream(file, std::ios::binary);
  if (!stream.is_open())
    throw NoInputError("It cannot be read", file.string(), "check its permissions");
  return restOf(stream, file.string());
}

template <class Json>
Json parseJson(std::string_view text, const std::string& where, const Text& tryThis, JsonComments comments) {
  const std::string latin1 = isUtf8(text) ? std::string() : toUtf8(std::string(text));
  const std::string_view utf8 = latin1.empty() ? text : latin1;
  const auto refuseDeepNesting = [&](int depth, typename Json::parse_event_t, Json&) {
    if (depth > kDeepest)
      throw JsonError(diagnostic("It is nested too deeply"), where, tryThis);
    return true;
  };
  try {
    return Json::parse(utf8, refuseDeepNesting, true, comments == JsonComments::skipped);
  } catch (const typename Json::exception& error) {
    // nlohmann's "[json.exception...] parse error at line 3, column 5: ..." without its prefix.
    const std::string message = error.what();
    const std::size_t end = message.find("] ");
    JsonError refusal(
        diagnostic("It is not complete JSON: %1", end == message.npos ? message : message.substr(end + 2)),
        where, tryThis);
    if (const auto* mistake = dynamic_cast<const typename Json::parse_error*>(&error)) {
      const auto read = static_cast<std::ptrdiff_t>(std::min(mistake->byte, utf8.size()));
      refusal.line = 1 + static_cast<std::size_t>(std::count(utf8.begin(), utf8.begin() + read, '\n'));
    }
    throw refusal;
  }
}

template nlohmann::json parseJson(std::string_view, const std::string&, const Text&, JsonComments);
template ordered_json parseJson(std::string_view, const std::string&, const Text&, JsonComments);

void JsonReader::fail(const Text& problem, const std::string& place) const {
  fail(problem, place, tryThis_);
}

void JsonReader::fail(const Text& problem, const std::string& place, const Text& tryThis) const {
  throw JsonError(problem, place.empty() ? where_ : where_ + ", " + place, tryThis);
}

ordered_json JsonReader::parse(const std::string& text) const {
  ordered_json root = parseJson<ordered_json>(text, where_, tryThis_);
  if (format_)
    requireFormat(root);
  else
    requireObject(root, "");
  return root;
}

void JsonReader::requireFormat(const ordered_json& root) const {
  if (!root.is_object() || root.value("format", ordered_json()) != format_->id)
    fail(phrase("It is no %1: its \"format\" is not \"%2\"", format_->kind, format_->id), "",
         format_->advice);
  const ordered_json& version = field(root, "version", "");
  if (!version.is_number_integer() || version.get<std::int64_t>() < 1)
    fail(diagnostic("\"version\" is not a positive whole number"), "");
  if (version.get<std::int64_t>() > format_->version)
    fail(phrase("It is of version %1; this program reads up to %2", version.dump(), format_->version), "",
         "update Viscera");
  for (const auto& [key, wanted] : {std::pair("coordinateSystem", "LPS"), std::pair("units", "mm")})
    if (root.contains(key) && root.at(key) != wanted)
      fail(diagnostic("\"%1\" is %2 instead of \"%3\"", key,
                      root.at(key).is_string() ? root.at(key).dump() : std::string(root.at(key).type_name()),
                      wanted),
           "");
}

void JsonReader::failWithout(const char* key, const std::string& place) const {
  JsonError error(diagnostic("It has no \"%1\"", key), place.empty() ? where_ : where_ + ", " + place,
                  tryThis_);
  error.missingKey = key;
  throw error;
}

const ordered_json& JsonReader::field(const ordered_json& object, const char* key,
                                      const std::string& place) const {
  const auto found = object.find(key);
  if (found == object.end())
    failWithout(key, place);
  return *found;
}

std::string JsonReader::textOf(const ordered_json& object, const char* key, const std::string& place) const {
  const ordered_json& value = field(object, key, place);
  if (!value.is_string() || value.get_ref<const std::string&>().empty())
    fail(diagnostic("\"%1\" is not a text", key), place);
  return value.get<std::string>();
}

bool JsonReader::flagOf(const ordered_json& object, const char* key, const std::string& place) const {
  const ordered_json& value = field(object, key, place);
  if (!value.is_boolean())
    fail(diagnostic("\"%1\" is neither true nor false", key), place);
  return value.get<bool>();
}

double JsonReader::numberOf(const ordered_json& value, const std::string& place) const {
  const std::optional<double> number = finiteNumber(value);
  if (!number)
    fail(diagnostic("It is not a finite number"), place);
  return *number;
}

std::int64_t JsonReader::wholeOf(const ordered_json& value, const std::string& place) const {
  if (!value.is_number_integer() || !(value.get<double>() >= 0) || value.get<double>() > kLargestWhole)
    fail(diagnostic("It is not a whole number from 0 to 2^53"), place);
  return value.get<std::int64_t>();
}

Vec3 JsonReader::vectorOf(const ordered_json& value, const std::string& place) const {
  if (!value.is_array() || value.size() != 3)
    fail(diagnostic("It is not a list of three numbers"), place);
  return {numberOf(value[0], place), numberOf(value[1], place), numberOf(value[2], place)};
}

Vec3 JsonReader::colorOf(const ordered_json& value, const std::string& place) const {
  const Vec3 color = vectorOf(value, place);
  if ((color.array() < 0).any() || (color.array() > 1).any())
    fail(diagnostic("its colour does not lie between 0 and 1"), place);
  return color;
}

const ordered_json& JsonReader::listOf(const ordered_json& object, const char* key,
                                       const std::string& place) const {
  const ordered_json& list = field(object, key, place);
  if (!list.is_array())
    fail(diagnostic("\"%1\" is not a list", key), place);
  return list;
}

void JsonReader::requireObject(const ordered_json& value, const std::string& place) const {
  if (!value.is_object())
    fail(diagnostic("It is not an object"), place);
}

void JsonReader::takeObject(const ordered_json& value, std::initializer_list<const char*> known,
                            const std::string& place) {
  requireObject(value, place);
  for (const auto& [key, unread] : value.items()) {
    const bool isKnown =
        std::any_of(known.begin(), known.end(), [&name = key](const char* one) { return name == one; });
    if (!isKnown)
      unknown_.push_back(inside(place, key));
  }
}

void JsonReader::read(const ordered_json& value, const std::string& place, bool& out) const {
  if (!value.is_boolean())
    fail(diagnostic("\"%1\" is neither true nor false", keyOf(place)), place);
  out = value.get<bool>();
}

void JsonReader::read(const ordered_json& value, const std::string& place, std::int64_t& out) const {
  const double number = numberOf(value, place);
  if (number != std::floor(number))
    fail(diagnostic("it contains %1, which is no whole number", value.dump()), place);
  if (std::abs(number) > kLargestWhole)
    fail(diagnostic("%1 is out of its range", value.dump()), place);
  out = static_cast<std::int64_t>(number);
}

void JsonReader::read(const ordered_json& value, const std::string& place, int& out) const {
  std::int64_t whole = 0;
  read(value, place, whole);
  if (whole < std::numeric_limits<int>::min() || whole > std::numeric_limits<int>::max())
    fail(diagnostic("%1 is out of its range", value.dump()), place);
  out = static_cast<int>(whole);
}

void JsonReader::read(const ordered_json& value, const std::string& place, double& out) const {
  out = numberOf(value, place);
}

void JsonReader::read(const ordered_json& value, const std::string& place, std::string& out) const {
  if (!value.is_string())
    fail(diagnostic("\"%1\" is not a text", keyOf(place)), place);
  out = value.get<std::string>();
}

void JsonReader::read(const ordered_json& value, const std::string& place, Vec3& out) const {
  out = vectorOf(value, place);
}

void JsonReader::read(const ordered_json& value, const std::string& place, std::array<double, 2>& out) const {
  std::vector<double> numbers;
  read(value, place, numbers);
  if (numbers.size() < out.size())
    failWithout(at("", numbers.size()).c_str(), place);
  out = {numbers[0], numbers[1]};
}

void JsonReader::requireList(const ordered_json& value, const std::string& place) const {
  if (!value.is_array())
    fail(diagnostic("\"%1\" is not a list", keyOf(place)), place);
}

std::string JsonReader::at(const std::string& list, std::size_t index) {
  return list + "[" + std::to_string(index) + "]";
}

std::string JsonReader::inside(const std::string& place, const std::string& key) {
  return place.empty() ? key : place + "." + key;
}

ordered_json jsonOf(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

} // namespace viscera
