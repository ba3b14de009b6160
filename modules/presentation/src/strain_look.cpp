#include "strain_look.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "look_json.h"
#include "viscera/core/arrays.h"

namespace viscera::presentation {
namespace {

using nlohmann::ordered_json;

constexpr std::array<const char*, 4> kDirectionNames = {"longitudinal", "circumferential", "radial",
                                                        "thickening"};
constexpr std::array<const char*, 3> kMomentNames = {"peak", "instant", "timeToPeak"};
constexpr int kMostSegments = 17;

/// The points of the heart's axes by their names, for reading and writing alike.
template <class Visit>
void visitAxes(StrainLook& look, Visit visit) {
  visit("base", look.base);
  visit("apex", look.apex);
  visit("insertion", look.insertion);
}

} // namespace

ordered_json strainLookJson(StrainLook look) {
  ordered_json item = {{"chart", look.chart},
                       {"onOrgan", look.onOrgan},
                       {"direction", kDirectionNames[static_cast<std::size_t>(look.direction)]},
                       {"moment", kMomentNames[static_cast<std::size_t>(look.moment)]},
                       {"segment", look.segment},
                       {"reference", look.reference}};
  visitAxes(look, [&](const char* key, const std::optional<Vec3>& point) {
    if (!point)
      return;
    item["axes"]["organ"] = look.axesOf.value;
    item["axes"][key] = jsonOf(*point);
  });
  return item;
}

StrainLook strainLookFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  json.requireObject(item, place);
  StrainLook look;
  json.readIfThere(item, "chart", place, look.chart);
  json.readIfThere(item, "onOrgan", place, look.onOrgan);
  look.direction = fromName<live::StrainDirection>(kDirectionNames, item.value("direction", ordered_json()));
  look.moment = fromName<live::StrainMoment>(kMomentNames, item.value("moment", ordered_json()));
  json.readIfThere(item, "segment", place, look.segment);
  if (look.segment < 0 || look.segment > kMostSegments)
    look.segment = 0;
  json.readIfThere(item, "reference", place, look.reference);
  look.reference = std::max(look.reference, 0);
  const auto axes = item.find("axes");
  if (axes == item.end())
    return look;
  const std::string inAxes = place + ".axes";
  json.requireObject(*axes, inAxes);
  look.axesOf.value = json.valueOf<std::int64_t>(*axes, "organ", inAxes);
  visitAxes(look, [&](const char* key, std::optional<Vec3>& point) {
    if (axes->contains(key))
      point = json.valueOf<Vec3>(*axes, key, inAxes);
  });
  return look;
}

} // namespace viscera::presentation
