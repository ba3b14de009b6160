#include <array>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"
#include "viscera/live/session_motion.h"

// The motions of a session's view as JSON (docs/session_format.md).
namespace viscera::live {
namespace {

using Json = nlohmann::ordered_json;

/// Since format 2 switches have names of their own; since 3 a heart's beat begins before its atria contract.
constexpr int kNamedSwitches = 2, kBeatBeforeAtria = 3;

Json recipeJson(const SampleMotion& motion) {
  return {{"resolution", sample_organs::nameOf(motion.resolution)}, {"sequence", motion.sequence}};
}

Json recipeJson(const FittedMotion& motion) {
  Json landmarks = Json::array();
  for (const Landmark& landmark : motion.given.points)
    landmarks.push_back({{"position", jsonOf(landmark.position)}, {"role", landmark.role}});
  return {{"landmarks", std::move(landmarks)}, {"sequence", motion.sequence}};
}

Json recipeJson(std::monostate) {
  return nullptr;
}

SampleMotion sampleMotion(const JsonReader& json, const Json& item, const std::string& place) {
  json.requireObject(item, place);
  const auto resolution = json.valueOf<std::string>(item, "resolution", place);
  return {json.valueOf<std::string>(item, "sequence", place), sample_organs::resolutionFromName(resolution)};
}

FittedMotion fittedMotion(const JsonReader& json, const Json& item, const std::string& place) {
  json.requireObject(item, place);
  FittedMotion motion;
  json.eachOf(item, "landmarks", place, [&](const Json& landmark, const std::string& at) {
    json.requireObject(landmark, at);
    motion.given.points.push_back(
        {json.valueOf<std::string>(landmark, "role", at), json.valueOf<Vec3>(landmark, "position", at)});
  });
  motion.sequence = json.valueOf<std::string>(item, "sequence", place);
  return motion;
}

MotionRecipe recipe(const JsonReader& json, const Json& item, const std::string& place) {
  try {
    if (item.contains("landmarks"))
      return fittedMotion(json, item, place);
    return sampleMotion(json, item, place);
  } catch (const Error&) {
    return {};
  }
}

Json prescribedJson(const Prescribed& prescribed) {
  Json item = {{"organ", prescribed.organ.value}};
  if (!prescribed.file.empty())
    item["file"] = prescribed.file;
  item["curve"] = prescribed.curve;
  return item;
}

Prescribed prescribedFrom(const JsonReader& json, const Json& item, const std::string& place) {
  json.requireObject(item, place);
  Prescribed prescribed;
  prescribed.organ.value = json.valueOf<std::int64_t>(item, "organ", place);
  json.readIfThere(item, "file", place, prescribed.file);
  prescribed.curve = json.valueOf<std::vector<std::array<double, 2>>>(item, "curve", place);
  return prescribed;
}

} // namespace

Json toJson(const MotionChoice& motion) {
  return {{"organ", motion.organ.value},
          {"recipe", std::visit([](const auto& known) { return recipeJson(known); }, motion.recipe)}};
}

MotionChoice motionChoice(const JsonReader& json, const Json& item, const std::string& place) {
  json.requireObject(item, place);
  return {{json.valueOf<std::int64_t>(item, "organ", place)},
          recipe(json, json.field(item, "recipe", place), JsonReader::inside(place, "recipe"))};
}

Json toJson(const Playing& playing) {
  Json item = {
      {"motion", playing.motion}, {"fraction", playing.fraction}, {"ratePerMinute", playing.ratePerMinute},
      {"speed", playing.speed},   {"loop", playing.loop},         {"shown", playing.shown}};
  if (playing.prescribed)
    item["prescribed"] = prescribedJson(*playing.prescribed);
  return item;
}

Playing playing(const JsonReader& json, const Json& item, const std::string& place) {
  json.requireObject(item, place);
  Playing read;
  json.readIfThere(item, "motion", place, read.motion);
  json.readIfThere(item, "fraction", place, read.fraction);
  json.readIfThere(item, "ratePerMinute", place, read.ratePerMinute);
  json.readIfThere(item, "speed", place, read.speed);
  json.readIfThere(item, "loop", place, read.loop);
  json.readIfThere(item, "shown", place, read.shown);
  if (const auto found = item.find("prescribed"); found != item.end())
    read.prescribed = prescribedFrom(json, *found, JsonReader::inside(place, "prescribed"));
  return read;
}

Json viewOf(const SessionMotion& motion) {
  Json view = {{"format", kBeatBeforeAtria}, {"motions", Json::array()}};
  for (const MotionChoice& offered : motion.motions)
    view["motions"].push_back(toJson(offered));
  if (motion.playing)
    view["playing"] = toJson(*motion.playing);
  return view;
}

SessionMotion sessionMotion(const Json& view, const document::CirculationChoice& circulation) {
  const Text advice = "the organs and the handles are complete; save the session anew";
  const JsonReader json("the session's view", advice);
  try {
    json.requireObject(view, "");
    int format = 1;
    json.readIfThere(view, "format", "", format);
    SessionMotion motion;
    json.eachOf(view, "motions", "", [&](const Json& item, const std::string& place) {
      motion.motions.push_back(motionChoice(json, item, place));
    });
    if (const auto found = view.find("playing"); found != view.end())
      motion.playing = playing(json, *found, "playing");
    if (motion.playing && format < kNamedSwitches && view.contains("switches")) {
      json.requireObject(view.at("switches"), "switches");
      json.readIfThere(view.at("switches"), "play.loop", "switches", motion.playing->loop);
    }
    if (motion.playing && format < kBeatBeforeAtria)
      beginEarlier(*motion.playing, beginsEarlierBy(motion, circulation));
    return motion;
  } catch (const JsonError& error) {
    throw DataError("The view cannot be restored completely", error.where(), advice);
  }
}

} // namespace viscera::live
