#include "look_json.h"

#include <cmath>

namespace viscera::presentation {

using nlohmann::ordered_json;

namespace {

constexpr std::array<const char*, 3> kStrainDirections = {"longitudinal", "circumferential", "radial"};
constexpr std::array<const char*, 3> kStrainMoments = {"peak", "instant", "timeToPeak"};
constexpr int kMostSegments = 17;

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

ordered_json strainJson(const StrainLook& look) {
  return {{"chart", look.chart},
          {"onOrgan", look.onOrgan},
          {"direction", kStrainDirections[static_cast<std::size_t>(look.direction)]},
          {"moment", kStrainMoments[static_cast<std::size_t>(look.moment)]},
          {"segment", look.segment}};
}

StrainLook strainFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  json.requireObject(item, place);
  StrainLook look;
  json.readIfThere(item, "chart", place, look.chart);
  json.readIfThere(item, "onOrgan", place, look.onOrgan);
  look.direction =
      fromName<live::StrainDirection>(kStrainDirections, item.value("direction", ordered_json()));
  look.moment = fromName<live::StrainMoment>(kStrainMoments, item.value("moment", ordered_json()));
  json.readIfThere(item, "segment", place, look.segment);
  if (look.segment < 0 || look.segment > kMostSegments)
    look.segment = 0;
  return look;
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
