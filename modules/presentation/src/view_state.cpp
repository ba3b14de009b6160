#include "viscera/presentation/view_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "field_table.h"
#include "former_beat.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"
#include "viscera/presentation/stress_values.h"

// The view of a session as JSON: written in format 3, read in formats 1 to 3 (docs/session_format.md).
namespace viscera::presentation {
namespace {

/// Since format 2 switches have names of their own; since 3 a heart's beat begins before its atria contract.
constexpr int kFormat = 3, kNamedSwitches = 2, kBeatBeforeAtria = 3;
constexpr const char* kView = "the session's view";
constexpr const char* kViewAdvice = "the organs and the handles are complete; save the session anew";
constexpr double kFastestRate = 1e6; ///< Of a sequence, a minute: its range has the last word.
constexpr double kShortestNormal = 1e-6;
constexpr int kMostSegments = 17;
constexpr double kFar = 1e6, kMostSlabMm = 200, kMostZoom = 1000; ///< Of a scan, mm and values.

/// A number of the view, or `otherwise` for one that nothing can be drawn with.
double within(double value, double low, double high, double otherwise) {
  return value >= low && value <= high ? value : otherwise;
}

/// The normal of unit length; the usual direction for one without any.
Vec3 unit(const Vec3& normal) {
  return normal.norm() > kShortestNormal ? Vec3(normal.normalized()) : Vec3(Vec3::UnitY());
}

/// The usual colours stand for those that only a newer version has.
void requireColors(std::string& name, const std::string& usual) {
  const auto& all = scene::colorMaps();
  if (std::none_of(all.begin(), all.end(), [&](const scene::ColorMap& map) { return map.name == name; }))
    name = usual;
}

} // namespace

template <>
constexpr auto kNames<Mirror> = std::array{"off", "sagittal", "coronal", "axial"};
template <>
constexpr auto kNames<Compared::What> = std::array{"rate", "coordinates", "pose", "sample"};
template <>
constexpr auto kNames<GlyphChoice> = std::array{"none", "ellipsoids", "crosses"};
template <>
constexpr auto kNames<scene::CutStyle> = std::array{"smooth", "crinkle"};
template <>
constexpr auto kNames<live::StrainDirection> =
    std::array{"longitudinal", "circumferential", "radial", "thickening"};
template <>
constexpr auto kNames<live::StrainMoment> = std::array{"peak", "instant", "timeToPeak"};

template <>
struct Codec<live::StressQuantity>
    : TextCodec<live::StressQuantity, [](auto quantity) { return live::describe(quantity).id; },
                live::stressQuantityFromId> {};
template <>
struct Codec<anatomy::Sex> : TextCodec<anatomy::Sex, anatomy::idOf, anatomy::sexFromId> {};
template <>
struct Codec<scene::ValueRange> {
  static Json write(const scene::ValueRange& range) { return {range.low, range.high}; }
  static void read(const FieldReader& from, scene::ValueRange& range) {
    std::array<double, 2> ends{};
    from.json.read(from.item, from.place, ends);
    range = {ends[0], ends[1]};
  }
};

template <>
struct Codec<HandlePositions> {
  static Json write(const HandlePositions& positions) {
    Json rows = Json::array();
    for (const auto& row : positions.rowwise())
      rows.push_back(jsonOf(row.transpose()));
    return rows;
  }
  static void read(const FieldReader& from, HandlePositions& positions) {
    std::vector<Vec3> rows;
    from.json.read(from.item, from.place, rows);
    positions.resize(static_cast<Eigen::Index>(rows.size()), 3);
    for (std::size_t i = 0; i < rows.size(); ++i)
      positions.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
  }
};

template <class Visit>
void visitFields(Visit& visit, Camera& camera) {
  visit.required("position", camera.position);
  visit.required("focus", camera.focus);
  visit.required("up", camera.up);
  visit("angleDegrees", camera.angleDegrees);
  visit("parallel", camera.parallel);
  visit("parallelScaleMm", camera.parallelScaleMm);
}

template <class Visit>
void visitFields(Visit& visit, Shown& shown) {
  visit("rest", shown.rest);
  visit("handles", shown.handles);
  visit("movable", shown.movable);
  visit("compensating", shown.compensating);
  visit("tools", shown.tools);
  visit("regions", shown.regions);
  visit("stress", shown.stress);
}

template <class Visit>
void visitFields(Visit& visit, HeartSigns& signs) {
  visit("pressures", signs.pressures);
  visit("loops", signs.loops);
  visit("ecg", signs.ecg);
  visit("valves", signs.valves);
  visit("sounds", signs.sounds);
}

template <class Visit>
void visitFields(Visit& visit, elasticity::StatedMaterial& material) {
  visit("tissue", material.tissue);
  visit("youngKpa", material.youngKpa);
  visit("poisson", material.poisson);
  visit.afterReading([&] { // A number that is no material states none.
    const bool valid = std::isfinite(material.youngKpa) && material.youngKpa > 0 && material.poisson > 0 &&
                       material.poisson < 0.5;
    if (!valid)
      material = {};
  });
}

template <class Visit>
void visitFields(Visit& visit, StressLook& look) {
  const auto keepRange = [&] { look.range = onScale(look.quantity, look.range, look.logarithmic); };
  keepRange(); // What is written is as it will be read.
  visit("quantity", look.quantity);
  visit.where(look.material.stated(), "material", look.material);
  visit("range", look.range);
  visit("cutStyle", look.style);
  visit("normal", look.normal);
  visit("glyphs", look.glyphs);
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
  visit.afterReading([&] {
    requireColors(look.amountColors, StressLook().amountColors);
    requireColors(look.ratioColors, StressLook().ratioColors);
    look.normal = unit(look.normal);
    look.offset = std::clamp(look.offset, -1.0, 1.0);
    look.witnesses = std::clamp(look.witnesses, live::WitnessOptions::kFewest, live::WitnessOptions::kMost);
    keepRange();
  });
}

template <class Visit>
void visitFields(Visit& visit, StrainLook& look) {
  visit("chart", look.chart);
  visit("onOrgan", look.onOrgan);
  visit("direction", look.direction);
  visit("moment", look.moment);
  visit("segment", look.segment);
  visit("reference", look.reference);
  visit.object(look.base || look.apex || look.insertion, "axes", [&look](auto& inAxes) {
    inAxes.required("organ", look.axesOf);
    inAxes("base", look.base);
    inAxes("apex", look.apex);
    inAxes("insertion", look.insertion);
  });
  visit.afterReading([&] {
    if (look.segment < 0 || look.segment > kMostSegments)
      look.segment = 0;
    look.reference = std::max(look.reference, 0);
  });
}

template <class Visit>
void visitFields(Visit& visit, SliceFraming& framing) {
  visit("rightMm", framing.rightMm);
  visit("upMm", framing.upMm);
  visit("zoom", framing.zoom);
  visit.afterReading([&] {
    framing.rightMm = within(framing.rightMm, -kFar, kFar, 0);
    framing.upMm = within(framing.upMm, -kFar, kFar, 0);
    framing.zoom = within(framing.zoom, 1 / kMostZoom, kMostZoom, 1);
  });
}

template <>
struct Codec<std::array<SliceFraming, 3>> {
  using Framings = std::array<SliceFraming, 3>;
  static Json write(const Framings& framings) {
    return Codec<std::vector<SliceFraming>>::write({framings.begin(), framings.end()});
  }
  static void read(const FieldReader& from, Framings& framings) {
    std::vector<SliceFraming> all;
    Codec<std::vector<SliceFraming>>::read(from, all);
    all.resize(framings.size());
    std::copy(all.begin(), all.end(), framings.begin());
  }
};

template <class Visit>
void visitFields(Visit& visit, CineLook& look) {
  visit("first", look.slices[0]);
  visit("second", look.slices[1]);
  visit("third", look.slices[2]);
  visit("fraction", look.fraction);
  visit.afterReading([&] {
    for (int& slice : look.slices)
      slice = std::max(slice, -1);
    look.fraction = within(look.fraction, 0, 1, 0);
  });
}

template <class Visit>
void visitFields(Visit& visit, ScanLook& look) {
  visit("layout", look.layout);
  visit.where(look.width > 0, "level", look.level);
  visit.where(look.width > 0, "width", look.width);
  visit("slabMm", look.slabMm);
  visit("maximum", look.maximum);
  visit("smooth", look.smooth);
  visit("contours", look.contours);
  visit("rest", look.rest);
  visit("standing", look.standing);
  visit("bent", look.warped);
  visit("focus", look.focus);
  visit("framings", look.framings);
  visit.where(!(look.cine == CineLook()), "cine", look.cine);
  visit.afterReading([&] {
    if (look.focus && !(look.focus->cwiseAbs().maxCoeff() < kFar))
      look.focus.reset();
    look.level = within(look.level, -kFar, kFar, 0);
    look.width = within(look.width, 0, kFar, 0);
    look.slabMm = within(look.slabMm, 0, kMostSlabMm, 0);
  });
}

template <class Visit>
void visitFields(Visit& visit, OrganCut& cut) {
  visit("on", cut.on);
  visit("normal", cut.normal);
  visit("offset", cut.offset);
  visit("blood", cut.blood);
  visit.afterReading([&] {
    cut.normal = unit(cut.normal);
    cut.offset = std::clamp(cut.offset, -1.0, 1.0);
  });
}

template <class Visit>
void visitFields(Visit& visit, OrganSeen& seen) {
  visit("visible", seen.visible);
  visit("opacity", seen.opacity);
  visit.afterReading([&] { seen.opacity = within(seen.opacity, 0, 1, 1); });
}

template <>
struct Codec<OrgansSeen> {
  static Json write(const OrgansSeen& organs) {
    Json list = Json::array();
    for (auto [organ, seen] : organs) {
      FieldWriter visit{list.emplace_back()};
      visit.required("organ", organ);
      visitFields(visit, seen);
    }
    return list;
  }
  static void read(const FieldReader& from, OrgansSeen& organs) {
    from.json.requireList(from.item, from.place);
    organs.clear();
    for (std::size_t i = 0; i < from.item.size(); ++i) {
      FieldReader visit{from.json, from.item[i], JsonReader::at(from.place, i)};
      document::OrganId organ;
      visit.required("organ", organ);
      Codec<OrganSeen>::read(visit, organs[organ]);
    }
  }
};

template <class Visit>
void visitFields(Visit& visit, SlideLook& look) {
  visit("cut", look.cut);
  visit("labels", look.labels);
  visit("partNames", look.partNames);
  visit("organs", look.organs);
}

template <class Visit>
void visitFields(Visit& visit, Slide& slide) {
  visit("caption", slide.caption);
  visit.required("camera", slide.camera);
  visit("fraction", slide.fraction);
  visit("look", slide.look);
  visit.afterReading([&] {
    if (slide.fraction)
      slide.fraction = std::clamp(*slide.fraction, 0.0, 1.0);
  });
}

template <class Visit>
void visitFields(Visit& visit, anatomy::Person& person) {
  visit("sex", person.sex);
  visit("bodySurfaceM2", person.bodySurfaceM2);
  visit.afterReading([&] {
    person.bodySurfaceM2 =
        within(person.bodySurfaceM2, anatomy::kSmallestBodySurfaceM2, anatomy::kLargestBodySurfaceM2, 0);
  });
}

template <class Visit>
void visitFields(Visit& visit, heart::ChosenEnds& ends) {
  visit("diastole", ends.diastole);
  visit("systole", ends.systole);
  visit.afterReading([&] {
    for (std::optional<double>* end : {&ends.diastole, &ends.systole})
      if (*end && !(**end >= 0 && **end <= 1))
        end->reset();
  });
}

template <class Visit>
void visitFields(Visit& visit, SelectionState& selection) {
  visit.required("organ", selection.organ);
  visit.required("group", selection.group);
  visit.required("handles", selection.handles);
}

template <>
struct Codec<Playing> {
  static Json write(const Playing& playing) { return live::toJson(playing); }
  static void read(const FieldReader& from, Playing& playing) {
    playing = live::playing(from.json, from.item, from.place);
  }
};

template <>
struct Codec<MotionChoice> {
  static Json write(const MotionChoice& motion) { return live::toJson(motion); }
  static void read(const FieldReader& from, MotionChoice& motion) {
    motion = live::motionChoice(from.json, from.item, from.place);
  }
};

template <class Visit>
void visitFields(Visit& visit, Compared& compared) {
  visit.required("what", compared.what);
  visit.where(!compared.name.empty(), "name", compared.name);
  visit.where(compared.ratePerMinute > 0, "ratePerMinute", compared.ratePerMinute);
  visit.where(compared.pose.rows() > 0, "pose", compared.pose);
  visit.afterReading([&] { compared.ratePerMinute = within(compared.ratePerMinute, 0, kFastestRate, 0); });
}

template <>
struct Codec<std::optional<Compared>> {
  /// None for what only a newer version can compare with, and where what it is about is missing.
  static void read(const FieldReader& from, std::optional<Compared>& value) {
    using What = Compared::What;
    const auto what = from.json.valueOf<std::string>(from.item, "what", from.place);
    if (std::find(kNames<What>.begin(), kNames<What>.end(), what) == kNames<What>.end())
      return;
    Compared compared;
    Codec<Compared>::read(from, compared);
    const bool named = compared.what == What::coordinates || compared.what == What::sample;
    if (!(named && compared.name.empty()) && !(compared.what == What::pose && compared.pose.rows() == 0))
      value = std::move(compared);
  }
};

/// A switch has the name of its action in format 1 as well.
template <class Visit>
void visitFields(Visit& visit, ViewState& view) {
  visit("mode", view.mode);
  visit("shown", view.shown);
  visit("camera", view.camera);
  visit("handles", view.handles, "view.handles");
  visit("influence", view.influence, "handles.influence");
  visit("ghost", view.ghost, "view.ghost");
  visit("labels", view.labels, "view.labels");
  visit("partNames", view.partNames, "view.partNames");
  visit("measurements", view.measurements, "view.measurements");
  visit("orientationCube", view.orientationCube, "view.cube");
  visit("scaleBar", view.scaleBar, "view.scale");
  visit("gizmo", view.gizmo, "handles.gizmo");
  visit("exactly", view.exactly, "handles.exactly");
  visit("regions", view.layout.regions, "handles.regions");
  visit("zones", view.layout.zones, "handles.zones");
  visit("superRegions", view.layout.superRegions, "handles.superRegions");
  visit("chartOfCycle", view.chartOfCycle, "play.cycle");
  visit("circulationChart", view.circulationChart, "play.circulationChart");
  visit("beatSigns", view.beatSigns, "play.beatSigns");
  visit("valves", view.valves, "play.valves");
  visit("conduction", view.conduction, "view.conduction");
  visit.where(view.freeHandlesFollow, "freeHandlesFollow", view.freeHandlesFollow);
  visit.where(view.besideElasticity, "besideElasticity", view.besideElasticity);
  visit("mirror", view.mirror);
  visit("heartSigns", view.heartSigns);
  visit("stress", view.stress);
  visit("strain", view.strain);
  visit("scan", view.scan);
  visit("cut", view.cut);
  visit.where(!view.organsSeen.empty(), "organsSeen", view.organsSeen);
  visit("person", view.person);
  visit.where(!(view.cycleEnds == heart::ChosenEnds()), "cycleEnds", view.cycleEnds);
  visit("selection", view.selection);
  visit("motions", view.motions);
  visit("playing", view.playing);
  visit("compared", view.compared);
  visit.where(!view.slides.empty(), "slides", view.slides);
  visit.where(view.shownPose.rows() > 0, "shownPose", view.shownPose);
}

namespace {

/// Reads the switches of format 1 and passes over all other fields.
struct FormerSwitches {
  const JsonReader& json;
  const Json& switches;

  void operator()(const char*, bool& value, const char* action) const {
    json.readIfThere(switches, action, "switches", value);
  }
  template <class Value>
  void operator()(const char*, Value&) const {}
  template <class Value>
  void where(bool, const char*, Value&) const {}
};

/// The items that the modes of format 1 showed.
Shown shownByMode(const std::string& mode, bool sequenceShown) {
  Shown shown;
  shown.rest = shown.regions = mode == "handles";
  shown.compensating = shown.tools = mode == "deform";
  shown.stress = mode == "stress";
  shown.handles = shown.movable = shown.rest || shown.tools || (shown.stress && !sequenceShown);
  return shown;
}

/// Format 1 kept the user's settings, some of them as text.
StressLook stressFromSettings(const JsonReader& json, const Json& settings) {
  json.requireObject(settings, "stress");
  Json item = Json::object();
  for (const auto& [key, value] : settings.items())
    item[key.substr(key.find('/') + 1)] = value;
  if (item.contains("normal") && item.at("normal").is_string()) {
    std::istringstream numbers(item.at("normal").get<std::string>());
    Vec3 normal = Vec3::Zero();
    numbers >> normal[0] >> normal[1] >> normal[2];
    item["normal"] = jsonOf(normal);
  }
  StressLook look;
  Codec<StressLook>::read({json, item, "stress"}, look);
  return look;
}

ViewState viewOfFormat1(const JsonReader& json, Json item) {
  ViewState view;
  const std::string place = "switches";
  const Json switches = item.value(place, Json::object());
  json.requireObject(switches, place);
  if (item.contains("stress"))
    view.stress = stressFromSettings(json, item.at("stress"));
  const StressLook stress = view.stress;
  item.erase("stress");
  Codec<ViewState>::read({json, item, ""}, view);
  view.stress = stress;
  FormerSwitches visit{json, switches};
  visitFields(visit, view);
  for (std::size_t i = 1; i < kNames<Mirror>.size(); ++i) {
    bool mirrored = false;
    json.readIfThere(switches, ("mirror." + std::string(kNames<Mirror>[i])).c_str(), place, mirrored);
    if (mirrored)
      view.mirror = static_cast<Mirror>(i);
  }
  if (view.playing)
    json.readIfThere(switches, "play.loop", place, view.playing->loop);
  view.shown = shownByMode(view.mode, view.playing && view.playing->shown);
  return view;
}

} // namespace

live::SessionMotion motionOf(const ViewState& view) {
  return {view.motions, view.playing};
}

Json toJson(const ViewState& view) {
  ViewState written = view;
  Json item = {{"format", kFormat}};
  FieldWriter visit{item};
  visitFields(visit, written);
  return item;
}

ViewState viewFromJson(const Json& item, const document::CirculationChoice& circulation) {
  const JsonReader json(kView, kViewAdvice);
  try {
    json.requireObject(item, "");
    int format = 1;
    json.readIfThere(item, "format", "", format);
    ViewState view;
    if (format < kNamedSwitches)
      view = viewOfFormat1(json, item);
    else
      Codec<ViewState>::read({json, item, ""}, view);
    if (format < kBeatBeforeAtria)
      beginBeforeAtria(view, circulation);
    return view;
  } catch (const JsonError& error) {
    throw DataError("The view cannot be restored completely", error.where(), kViewAdvice);
  }
}

StressLook habitOf(StressLook look) {
  look.pinned = look.threshold = look.peak = false;
  look.range = {0, 0};
  look.probe = -1;
  look.glyphs = GlyphChoice::none;
  look.material = {};
  if (live::describe(look.quantity).ofMaterial)
    look.quantity = StressLook().quantity;
  return look;
}

std::string toJson(const StressLook& look) {
  return Codec<StressLook>::write(look).dump();
}

StressLook stressLookFromJson(const std::string& text) {
  const JsonReader json(kView, kViewAdvice);
  try {
    const Json item = json.parse(text);
    StressLook look;
    Codec<StressLook>::read({json, item, "stress"}, look);
    return look;
  } catch (const JsonError&) {
    return {};
  }
}

} // namespace viscera::presentation
