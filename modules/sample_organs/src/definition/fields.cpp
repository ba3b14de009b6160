#include "definition/fields.h"

#include <cmath>
#include <optional>
#include <utility>

#include "viscera/core/edit_distance.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"

namespace viscera::sample_organs {
namespace {

using nlohmann::json;

constexpr std::size_t kMostTypos = 2;

std::string field(const std::string& key) {
  return "\"" + key + "\"";
}

} // namespace

Vec3 vectorFrom(const json& value, const std::string& where, const std::string& key) {
  const std::optional<Vec3> numbers = threeNumbers(value);
  if (!numbers)
    throw DataError(field(key) + " is not three numbers but " + value.dump(), where, "write it as [x, y, z]");
  return *numbers;
}

std::string nearestName(const std::string& wrong, const std::set<std::string>& names) {
  std::string best;
  std::size_t least = kMostTypos + 1;
  for (const std::string& name : names) {
    const std::size_t distance = editDistance(wrong, name);
    if (distance < least) {
      least = distance;
      best = name;
    }
  }
  return best;
}

std::string listed(const std::set<std::string>& names) {
  std::string text;
  std::size_t left = names.size();
  for (const std::string& name : names) {
    text += field(name);
    --left;
    if (left > 0)
      text += left == 1 ? " and " : ", ";
  }
  return text;
}

Fields::Fields(const json& object, std::string where) : object_(object), where_(std::move(where)) {
  if (!object_.is_object())
    throw DataError("there should be an object here, not " + object_.dump().substr(0, 60), where_,
                    "write { ... }");
}

void Fields::fail(const std::string& key, const std::string& what, const std::string& tryThis) const {
  throw DataError(field(key) + " " + what, where_, tryThis);
}

bool Fields::has(const std::string& key) const {
  return object_.contains(key);
}

const json& Fields::get(const std::string& key) {
  known_.insert(key);
  const auto found = object_.find(key);
  if (found == object_.end())
    fail(key, "is missing", "add it, or look for a misspelling");
  return *found;
}

const json* Fields::optional(const std::string& key) {
  known_.insert(key);
  return has(key) ? &get(key) : nullptr;
}

double Fields::number(const std::string& key) {
  const json& value = get(key);
  const std::optional<double> number = finiteNumber(value);
  if (!number)
    fail(key, "is not a number but " + value.dump());
  return *number;
}

double Fields::positive(const std::string& key) {
  const double value = number(key);
  if (value <= 0)
    fail(key, "is " + get(key).dump(), "it must be above 0");
  return value;
}

Vec3 Fields::vector(const std::string& key) {
  return vectorFrom(get(key), where_, key);
}

std::string Fields::text(const std::string& key) {
  const json& value = get(key);
  if (!value.is_string())
    fail(key, "is not a text but " + value.dump(), "put it in quotes");
  return value.get<std::string>();
}

const json& Fields::list(const std::string& key, std::size_t least) {
  const json& value = get(key);
  if (!value.is_array())
    fail(key, "is not a list", "write it as [ ... ]");
  if (value.size() < least)
    fail(key, "has " + std::to_string(value.size()) + " items", "it needs at least " + std::to_string(least));
  return value;
}

double Fields::number(const std::string& key, double otherwise) {
  return optional(key) ? number(key) : otherwise;
}

double Fields::positive(const std::string& key, double otherwise) {
  return optional(key) ? positive(key) : otherwise;
}

int Fields::integer(const std::string& key, int otherwise, int low, int high) {
  if (!optional(key))
    return otherwise;
  const double value = number(key);
  if (value != std::floor(value) || value < low || value > high)
    fail(key, "is " + get(key).dump(),
         "it must be a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  return static_cast<int>(value);
}

Vec3 Fields::vector(const std::string& key, const Vec3& otherwise) {
  return optional(key) ? vector(key) : otherwise;
}

Vec3 Fields::direction(const std::string& key) {
  const Vec3 value = vector(key);
  if (value.norm() == 0)
    fail(key, "has no length", "give a direction, for example [0, 0, 1]");
  return value.normalized();
}

void Fields::requireNothingElse() const {
  for (const auto& item : object_.items()) {
    if (known_.count(item.key()) != 0)
      continue;
    const std::string near = nearestName(item.key(), known_);
    fail(item.key(), "means nothing here",
         near.empty() ? "known are " + listed(known_) : "is it " + field(near) + " that is meant?");
  }
}

} // namespace viscera::sample_organs
