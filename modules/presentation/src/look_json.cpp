#include "look_json.h"

#include <cmath>
#include <sstream>
#include <utility>

#include "viscera/presentation/stress_values.h"

namespace viscera::presentation {
namespace {

using nlohmann::ordered_json;

constexpr std::array<const char*, 3> kGlyphNames = {"none", "ellipsoids", "crosses"};
constexpr std::array<const char*, 2> kCutStyles = {"smooth", "crinkle"};
constexpr double kShortestNormal = 1e-6;

template <class Visit>
void visitStress(StressLook& look, Visit visit) {
  visit("onSurface", look.onSurface);
  visit("pinned", look.pinned);
  visit("logarithmic", look.logarithmic);
  visit("amountColors", look.amountColors);
  visit("ratioColors", look.ratioColors);
  visit("peak", look.peak);
  visit("cut", look.cut);
  visit("offset", look.offset);
  visit("threshold", look.threshold);
  visit("limit", look.limit);
  visit("below", look.below);
  visit("handles", look.handles);
  visit("others", look.others);
  visit("sameRange", look.sameRange);
  visit("witnesses", look.witnesses);
  visit("probe", look.probe);
}

bool isColorMap(const std::string& name) {
  const auto& all = scene::colorMaps();
  return std::any_of(all.begin(), all.end(), [&](const scene::ColorMap& map) { return map.name == name; });
}

void keepWithinBounds(StressLook& look) {
  // A map that a newer version wrote is not refused: the usual one stands for it.
  for (std::string StressLook::*colors : {&StressLook::amountColors, &StressLook::ratioColors})
    if (!isColorMap(look.*colors))
      look.*colors = StressLook().*colors;
  look.normal = unit(look.normal);
  look.offset = std::clamp(std::isfinite(look.offset) ? look.offset : 0.0, -1.0, 1.0);
  look.witnesses = std::clamp(look.witnesses, live::WitnessOptions::kFewest, live::WitnessOptions::kMost);
  if (!std::isfinite(look.range.low) || !std::isfinite(look.range.high))
    look.range = {0, 0};
  look.range = onScale(look.quantity, look.range, look.logarithmic);
}
template <class Visit>
void visitScan(ScanLook& look, Visit visit) {
  visit("layout", look.layout);
  visit("level", look.level);
  visit("width", look.width);
  visit("slabMm", look.slabMm);
  visit("maximum", look.maximum);
  visit("smooth", look.smooth);
  visit("contours", look.contours);
  visit("rest", look.rest);
  visit("standing", look.standing);
  visit("bent", look.warped);
}

template <class Visit>
void visitFraming(SliceFraming& framing, Visit visit) {
  visit("rightMm", framing.rightMm);
  visit("upMm", framing.upMm);
  visit("zoom", framing.zoom);
}

template <class Visit>
void visitHeartSigns(HeartSigns& signs, Visit visit) {
  visit("pressures", signs.pressures);
  visit("loops", signs.loops);
  visit("ecg", signs.ecg);
  visit("valves", signs.valves);
  visit("sounds", signs.sounds);
}

} // namespace

double within(double value, double low, double high, double otherwise) {
  return std::isfinite(value) && value >= low && value <= high ? value : otherwise;
}

Vec3 unit(const Vec3& normal) {
  return normal.allFinite() && normal.norm() > kShortestNormal ? Vec3(normal.normalized())
                                                               : StressLook().normal;
}

ordered_json stressJson(StressLook look) {
  look.range = onScale(look.quantity, look.range, look.logarithmic); // As it is when it is read.
  ordered_json item = {{"quantity", live::describe(look.quantity).id},
                       {"range", {look.range.low, look.range.high}},
                       {"cutStyle", kCutStyles[static_cast<std::size_t>(look.style)]},
                       {"normal", jsonOf(look.normal)},
                       {"glyphs", kGlyphNames[static_cast<std::size_t>(look.glyphs)]}};
  visitStress(look, [&](const char* key, const auto& value) { item[key] = value; });
  return item;
}

StressLook stressFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  json.requireObject(item, place);
  StressLook look;
  visitStress(look, [&](const char* key, auto& value) { json.readIfThere(item, key, place, value); });
  if (item.contains("quantity"))
    look.quantity = live::stressQuantityFromId(json.valueOf<std::string>(item, "quantity", place));
  std::array<double, 2> range = {look.range.low, look.range.high};
  json.readIfThere(item, "range", place, range);
  look.range = {range[0], range[1]};
  json.readIfThere(item, "normal", place, look.normal);
  look.style = fromName<scene::CutStyle>(kCutStyles, item.value("cutStyle", ordered_json()));
  look.glyphs = fromName<GlyphChoice>(kGlyphNames, item.value("glyphs", ordered_json()));
  keepWithinBounds(look);
  return look;
}

StressLook stressFromSettings(const JsonReader& json, const ordered_json& settings) {
  json.requireObject(settings, "stress");
  ordered_json item = ordered_json::object();
  for (const auto& [key, value] : settings.items())
    item[key.substr(key.find('/') + 1)] = value;
  if (item.contains("normal") && item.at("normal").is_string()) {
    std::istringstream numbers(item.at("normal").get<std::string>());
    Vec3 normal = Vec3::Zero();
    numbers >> normal[0] >> normal[1] >> normal[2];
    item["normal"] = jsonOf(normal);
  }
  return stressFrom(json, item, "stress");
}

std::string toJson(const StressLook& look) {
  return stressJson(look).dump();
}

StressLook habitOf(StressLook look) {
  look.pinned = look.threshold = look.peak = false;
  look.range = {0, 0};
  look.probe = -1;
  look.glyphs = GlyphChoice::none;
  return look;
}

StressLook stressLookFromJson(const std::string& text) {
  const JsonReader json(kView, kViewAdvice);
  try {
    return stressFrom(json, json.parse(text), "stress");
  } catch (const JsonError&) {
    return {};
  }
}

ordered_json scanJson(ScanLook look) {
  ordered_json item;
  visitScan(look, [&](const char* key, const auto& value) { item[key] = value; });
  if (look.width <= 0) {
    item.erase("level");
    item.erase("width");
  }
  if (look.focus)
    item["focus"] = jsonOf(*look.focus);
  for (SliceFraming& framing : look.framings) {
    ordered_json one;
    visitFraming(framing, [&](const char* key, const auto& value) { one[key] = value; });
    item["framings"].push_back(one);
  }
  return item;
}

ScanLook scanFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  constexpr double kFar = 1e6;
  constexpr double kMostSlabMm = 200, kMostZoom = 1000;
  json.requireObject(item, place);
  ScanLook look;
  visitScan(look, [&](const char* key, auto& value) { json.readIfThere(item, key, place, value); });
  if (item.contains("focus"))
    look.focus = json.valueOf<Vec3>(item, "focus", place);
  if (look.focus && !(look.focus->cwiseAbs().maxCoeff() < kFar))
    look.focus.reset();
  look.level = within(look.level, -kFar, kFar, 0);
  look.width = within(look.width, 0, kFar, 0);
  look.slabMm = within(look.slabMm, 0, kMostSlabMm, 0);
  std::size_t read = 0;
  json.eachOf(item, "framings", place, [&](const ordered_json& one, const std::string& inList) {
    if (read == look.framings.size())
      return;
    SliceFraming& framing = look.framings[read++];
    visitFraming(framing, [&](const char* key, double& value) { json.readIfThere(one, key, inList, value); });
    framing.rightMm = within(framing.rightMm, -kFar, kFar, 0);
    framing.upMm = within(framing.upMm, -kFar, kFar, 0);
    framing.zoom = within(framing.zoom, 1 / kMostZoom, kMostZoom, 1);
  });
  return look;
}

ordered_json heartSignsJson(HeartSigns signs) {
  ordered_json item;
  visitHeartSigns(signs, [&](const char* key, bool value) { item[key] = value; });
  return item;
}

HeartSigns heartSignsFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  json.requireObject(item, place);
  HeartSigns signs;
  visitHeartSigns(signs, [&](const char* key, bool& value) { json.readIfThere(item, key, place, value); });
  return signs;
}

} // namespace viscera::presentation
