#include "viscera/presentation/view_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <nlohmann/json.hpp>

#include "former_beat.h"
#include "look_json.h"
#include "strain_look.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"

// The view of a session as JSON: written in format 3, read in formats 1 to 3 (docs/session_format.md).
namespace viscera::presentation {
namespace {

using nlohmann::ordered_json;

/// Since format 2 switches have names of their own; since 3 a heart's beat begins before its atria contract.
constexpr int kFormat = 3, kNamedSwitches = 2, kBeatBeforeAtria = 3;
constexpr double kFastestRate = 1e6; ///< Of a sequence, a minute: its range has the last word.
constexpr std::array<const char*, 4> kMirrors = {"off", "sagittal", "coronal", "axial"};
constexpr std::array<const char*, 4> kCompared = {"rate", "coordinates", "pose", "sample"};

ordered_json cameraJson(const Camera& camera) {
  return {{"position", jsonOf(camera.position)},
          {"focus", jsonOf(camera.focus)},
          {"up", jsonOf(camera.up)},
          {"angleDegrees", camera.angleDegrees},
          {"parallel", camera.parallel},
          {"parallelScaleMm", camera.parallelScaleMm}};
}

Camera cameraFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  Camera camera;
  camera.position = json.valueOf<Vec3>(item, "position", place);
  camera.focus = json.valueOf<Vec3>(item, "focus", place);
  camera.up = json.valueOf<Vec3>(item, "up", place);
  json.readIfThere(item, "angleDegrees", place, camera.angleDegrees);
  json.readIfThere(item, "parallel", place, camera.parallel);
  json.readIfThere(item, "parallelScaleMm", place, camera.parallelScaleMm);
  return camera;
}

/// The flags of a mode by their names, for reading and writing alike.
template <class Visit>
void visitShown(Shown& shown, Visit visit) {
  visit("rest", shown.rest);
  visit("handles", shown.handles);
  visit("movable", shown.movable);
  visit("compensating", shown.compensating);
  visit("tools", shown.tools);
  visit("regions", shown.regions);
  visit("stress", shown.stress);
}

/// The switches of a view by their names, and by those of the actions that kept them in format 1.
template <class Visit>
void visitSwitches(ViewState& view, Visit visit) {
  visit("handles", "view.handles", view.handles);
  visit("influence", "handles.influence", view.influence);
  visit("ghost", "view.ghost", view.ghost);
  visit("labels", "view.labels", view.labels);
  visit("partNames", "view.partNames", view.partNames);
  visit("measurements", "view.measurements", view.measurements);
  visit("orientationCube", "view.cube", view.orientationCube);
  visit("scaleBar", "view.scale", view.scaleBar);
  visit("gizmo", "handles.gizmo", view.gizmo);
  visit("exactly", "handles.exactly", view.exactly);
  visit("regions", "handles.regions", view.layout.regions);
  visit("zones", "handles.zones", view.layout.zones);
  visit("superRegions", "handles.superRegions", view.layout.superRegions);
  visit("chartOfCycle", "play.cycle", view.chartOfCycle);
  visit("circulationChart", "play.circulationChart", view.circulationChart);
  visit("beatSigns", "play.beatSigns", view.beatSigns);
  visit("valves", "play.valves", view.valves);
  visit("conduction", "view.conduction", view.conduction);
}

template <class Visit>
void visitPlaying(Playing& playing, Visit visit) {
  visit("motion", playing.motion);
  visit("fraction", playing.fraction);
  visit("ratePerMinute", playing.ratePerMinute);
  visit("speed", playing.speed);
  visit("loop", playing.loop);
  visit("shown", playing.shown);
}

/// The items that the modes of format 1 showed.
Shown shownByMode(const std::string& mode, bool sequenceShown) {
  Shown shown;
  shown.rest = shown.regions = mode == "handles";
  shown.compensating = shown.tools = mode == "deform";
  shown.stress = mode == "stress";
  shown.handles = shown.movable = shown.rest || shown.tools || (shown.stress && !sequenceShown);
  return shown;
}

void readSwitchesOfFormat1(const JsonReader& json, const ordered_json& item, ViewState& view) {
  const std::string place = "switches";
  const ordered_json switches = item.value(place, ordered_json::object());
  json.requireObject(switches, place);
  visitSwitches(view, [&](const char*, const char* action, bool& value) {
    json.readIfThere(switches, action, place, value);
  });
  for (std::size_t i = 1; i < kMirrors.size(); ++i) {
    bool mirrored = false;
    json.readIfThere(switches, ("mirror." + std::string(kMirrors[i])).c_str(), place, mirrored);
    if (mirrored)
      view.mirror = static_cast<Mirror>(i);
  }
  if (view.playing)
    json.readIfThere(switches, "play.loop", place, view.playing->loop);
  if (item.contains("stress"))
    view.stress = stressFromSettings(json, item.at("stress"));
  view.shown = shownByMode(view.mode, view.playing && view.playing->shown);
}

ordered_json recipeJson(const live::MotionRecipe& recipe) {
  if (const auto* sample = std::get_if<live::SampleMotion>(&recipe))
    return {{"resolution", sample_organs::nameOf(sample->resolution)}, {"sequence", sample->sequence}};
  const auto* fitted = std::get_if<live::FittedMotion>(&recipe);
  if (!fitted)
    return nullptr;
  ordered_json landmarks = ordered_json::array();
  for (const live::Landmark& point : fitted->given.points)
    landmarks.push_back({{"position", jsonOf(point.position)}, {"role", point.role}});
  return {{"landmarks", std::move(landmarks)}, {"sequence", fitted->sequence}};
}

/// A recipe that is damaged, or that only a newer version knows, is none: the rest of the view is opened.
live::MotionRecipe recipeFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  try {
    const auto sequence = json.valueOf<std::string>(item, "sequence", place);
    if (!item.contains("landmarks"))
      return live::SampleMotion{
          sequence, sample_organs::resolutionFromName(json.valueOf<std::string>(item, "resolution", place))};
    live::FittedMotion fitted{sequence, {}};
    json.eachOf(item, "landmarks", place, [&](const ordered_json& point, const std::string& inList) {
      fitted.given.points.push_back({json.valueOf<std::string>(point, "role", inList),
                                     json.valueOf<Vec3>(point, "position", inList), false});
    });
    return fitted;
  } catch (const Error&) {
    return {};
  }
}

SelectionState selectionFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  SelectionState selection;
  selection.organ.value = json.valueOf<std::int64_t>(item, "organ", place);
  selection.group.value = json.valueOf<std::int64_t>(item, "group", place);
  for (const std::int64_t id : json.valueOf<std::vector<std::int64_t>>(item, "handles", place))
    selection.handles.push_back({id});
  return selection;
}

ordered_json prescribedJson(const Prescribed& prescribed) {
  ordered_json item = {{"organ", prescribed.organ.value}};
  if (!prescribed.file.empty())
    item["file"] = prescribed.file;
  item["curve"] = prescribed.curve;
  return item;
}

Prescribed prescribedFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  Prescribed prescribed;
  prescribed.organ.value = json.valueOf<std::int64_t>(item, "organ", place);
  json.readIfThere(item, "file", place, prescribed.file);
  prescribed.curve = json.valueOf<std::vector<std::array<double, 2>>>(item, "curve", place);
  return prescribed;
}

Playing playingFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  Playing playing;
  visitPlaying(playing, [&](const char* key, auto& value) { json.readIfThere(item, key, place, value); });
  if (item.contains("prescribed"))
    playing.prescribed = prescribedFrom(json, item.at("prescribed"), JsonReader::inside(place, "prescribed"));
  return playing;
}

OrganCut cutFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  OrganCut cut;
  json.readIfThere(item, "on", place, cut.on);
  if (item.contains("normal"))
    cut.normal = unit(json.valueOf<Vec3>(item, "normal", place));
  json.readIfThere(item, "offset", place, cut.offset);
  json.readIfThere(item, "blood", place, cut.blood);
  cut.offset = std::clamp(std::isfinite(cut.offset) ? cut.offset : 0.0, -1.0, 1.0);
  return cut;
}

ordered_json cutJson(const OrganCut& cut) {
  return {{"on", cut.on}, {"normal", jsonOf(cut.normal)}, {"offset", cut.offset}, {"blood", cut.blood}};
}

ordered_json organsJson(const OrgansSeen& organs) {
  ordered_json items = ordered_json::array();
  for (const auto& [organ, seen] : organs)
    items.push_back({{"organ", organ.value}, {"visible", seen.visible}, {"opacity", seen.opacity}});
  return items;
}

OrgansSeen organsFrom(const JsonReader& json, const ordered_json& object, const char* key,
                      const std::string& place) {
  OrgansSeen organs;
  json.eachOf(object, key, place, [&](const ordered_json& item, const std::string& inList) {
    OrganSeen seen;
    json.readIfThere(item, "visible", inList, seen.visible);
    json.readIfThere(item, "opacity", inList, seen.opacity);
    seen.opacity = within(seen.opacity, 0, 1, 1);
    organs[{json.valueOf<std::int64_t>(item, "organ", inList)}] = seen;
  });
  return organs;
}

SlideLook slideLookFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  SlideLook look;
  if (item.contains("cut"))
    look.cut = cutFrom(json, item.at("cut"), JsonReader::inside(place, "cut"));
  json.readIfThere(item, "labels", place, look.labels);
  json.readIfThere(item, "partNames", place, look.partNames);
  look.organs = organsFrom(json, item, "organs", place);
  return look;
}

ordered_json slideJson(const Slide& slide) {
  ordered_json item = {{"caption", slide.caption}, {"camera", cameraJson(slide.camera)}};
  if (slide.fraction)
    item["fraction"] = *slide.fraction;
  if (slide.look)
    item["look"] = {{"cut", cutJson(slide.look->cut)},
                    {"labels", slide.look->labels},
                    {"partNames", slide.look->partNames},
                    {"organs", organsJson(slide.look->organs)}};
  return item;
}

Slide slideFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  Slide slide;
  json.readIfThere(item, "caption", place, slide.caption);
  slide.camera = cameraFrom(json, json.field(item, "camera", place), JsonReader::inside(place, "camera"));
  if (item.contains("fraction"))
    slide.fraction = std::clamp(json.valueOf<double>(item, "fraction", place), 0.0, 1.0);
  if (item.contains("look"))
    slide.look = slideLookFrom(json, item.at("look"), JsonReader::inside(place, "look"));
  return slide;
}

ordered_json rowsOf(const Points& points) {
  ordered_json rows = ordered_json::array();
  for (const auto& row : points.rowwise())
    rows.push_back(jsonOf(row.transpose()));
  return rows;
}

/// The rows of a list that may be left out.
Points rowsFrom(const JsonReader& json, const ordered_json& object, const char* key,
                const std::string& place) {
  std::vector<Vec3> rows;
  json.readIfThere(object, key, place, rows);
  Points points(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
  return points;
}

ordered_json comparedJson(const Compared& compared) {
  ordered_json item = {{"what", kCompared[static_cast<std::size_t>(compared.what)]}};
  if (!compared.name.empty())
    item["name"] = compared.name;
  if (compared.ratePerMinute > 0)
    item["ratePerMinute"] = compared.ratePerMinute;
  if (compared.pose.rows() > 0)
    item["pose"] = rowsOf(compared.pose);
  return item;
}

/// None for what only a newer version can compare with, and where what it is about is missing.
std::optional<Compared> comparedFrom(const JsonReader& json, const ordered_json& item,
                                     const std::string& place) {
  const auto what = json.valueOf<std::string>(item, "what", place);
  if (std::find(kCompared.begin(), kCompared.end(), what) == kCompared.end())
    return std::nullopt;
  Compared compared;
  compared.what = fromName<Compared::What>(kCompared, item.at("what"));
  using What = Compared::What;
  if (compared.what == What::coordinates || compared.what == What::sample) {
    json.readIfThere(item, "name", place, compared.name);
    if (compared.name.empty())
      return std::nullopt;
  }
  if (compared.what == What::pose) {
    compared.pose = rowsFrom(json, item, "pose", place);
    if (compared.pose.rows() == 0 || !compared.pose.allFinite())
      return std::nullopt;
  }
  json.readIfThere(item, "ratePerMinute", place, compared.ratePerMinute);
  compared.ratePerMinute = within(compared.ratePerMinute, 0, kFastestRate, 0);
  return compared;
}

anatomy::Person personFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  json.requireObject(item, place);
  anatomy::Person person;
  std::string sex;
  json.readIfThere(item, "sex", place, sex);
  person.sex = anatomy::sexFromId(sex);
  json.readIfThere(item, "bodySurfaceM2", place, person.bodySurfaceM2);
  person.bodySurfaceM2 =
      within(person.bodySurfaceM2, anatomy::kSmallestBodySurfaceM2, anatomy::kLargestBodySurfaceM2, 0);
  return person;
}

ViewState viewFrom(const JsonReader& json, const ordered_json& item,
                   const document::CirculationChoice& circulation) {
  ViewState view;
  json.readIfThere(item, "mode", "", view.mode);
  const auto take = [&](const char* key, auto& part, auto from) {
    if (item.contains(key))
      part = from(json, item.at(key), key);
  };
  take("camera", view.camera, cameraFrom);
  take("selection", view.selection, selectionFrom);
  json.eachOf(item, "motions", "", [&](const ordered_json& motion, const std::string& place) {
    view.motions.push_back({{json.valueOf<std::int64_t>(motion, "organ", place)},
                            recipeFrom(json, json.field(motion, "recipe", place), place)});
  });
  take("playing", view.playing, playingFrom);
  take("compared", view.compared, comparedFrom);
  take("cut", view.cut, cutFrom);
  view.organsSeen = organsFrom(json, item, "organsSeen", "");
  take("person", view.person, personFrom);
  json.eachOf(item, "slides", "", [&](const ordered_json& slide, const std::string& place) {
    view.slides.push_back(slideFrom(json, slide, place));
  });
  view.shownPose = rowsFrom(json, item, "shownPose", "");
  int format = 1;
  json.readIfThere(item, "format", "", format);
  if (format < kBeatBeforeAtria)
    beginBeforeAtria(view, circulation);
  if (format < kNamedSwitches) {
    readSwitchesOfFormat1(json, item, view);
    return view;
  }
  const ordered_json shown = item.value("shown", ordered_json::object());
  visitShown(view.shown, [&](const char* key, bool& value) { json.readIfThere(shown, key, "shown", value); });
  visitSwitches(view,
                [&](const char* key, const char*, bool& value) { json.readIfThere(item, key, "", value); });
  view.mirror = fromName<Mirror>(kMirrors, item.value("mirror", ordered_json()));
  take("stress", view.stress, stressFrom);
  take("strain", view.strain, strainLookFrom);
  take("scan", view.scan, scanFrom);
  take("heartSigns", view.heartSigns, heartSignsFrom);
  return view;
}

} // namespace

bool Compared::operator==(const Compared& other) const {
  return what == other.what && name == other.name && ratePerMinute == other.ratePerMinute &&
         pose.rows() == other.pose.rows() && pose == other.pose;
}

bool ViewState::operator==(const ViewState& other) const {
  const auto parts = [](const ViewState& view) {
    return std::tie(view.mode, view.shown, view.camera, view.handles, view.influence, view.ghost, view.labels,
                    view.partNames, view.measurements, view.orientationCube, view.scaleBar, view.gizmo,
                    view.exactly, view.mirror, view.layout.regions, view.layout.zones,
                    view.layout.superRegions, view.chartOfCycle, view.circulationChart, view.beatSigns,
                    view.valves, view.conduction, view.heartSigns, view.stress, view.strain, view.cut,
                    view.organsSeen, view.person.sex, view.person.bodySurfaceM2, view.scan, view.selection,
                    view.motions, view.playing, view.compared, view.slides);
  };
  return parts(*this) == parts(other) && shownPose.rows() == other.shownPose.rows() &&
         shownPose == other.shownPose;
}

ordered_json toJson(const ViewState& state) {
  ViewState view = state;
  ordered_json item = {{"format", kFormat}, {"mode", view.mode}};
  visitShown(view.shown, [&](const char* key, bool value) { item["shown"][key] = value; });
  if (view.camera)
    item["camera"] = cameraJson(*view.camera);
  visitSwitches(view, [&](const char* key, const char*, bool value) { item[key] = value; });
  item["mirror"] = kMirrors[static_cast<std::size_t>(view.mirror)];
  item["heartSigns"] = heartSignsJson(view.heartSigns);
  item["stress"] = stressJson(view.stress);
  item["strain"] = strainLookJson(view.strain);
  item["scan"] = scanJson(view.scan);
  item["cut"] = cutJson(view.cut);
  if (!view.organsSeen.empty())
    item["organsSeen"] = organsJson(view.organsSeen);
  item["person"] = {{"sex", anatomy::idOf(view.person.sex)}, {"bodySurfaceM2", view.person.bodySurfaceM2}};
  item["selection"] = {{"organ", view.selection.organ.value}, {"group", view.selection.group.value}};
  item["selection"]["handles"] = ordered_json::array();
  for (const document::HandleId id : view.selection.handles)
    item["selection"]["handles"].push_back(id.value);
  item["motions"] = ordered_json::array();
  for (const MotionChoice& motion : view.motions)
    item["motions"].push_back({{"organ", motion.organ.value}, {"recipe", recipeJson(motion.recipe)}});
  if (view.playing)
    visitPlaying(*view.playing, [&](const char* key, const auto& value) { item["playing"][key] = value; });
  if (view.playing && view.playing->prescribed)
    item["playing"]["prescribed"] = prescribedJson(*view.playing->prescribed);
  if (view.compared)
    item["compared"] = comparedJson(*view.compared);
  if (!view.slides.empty())
    item["slides"] = ordered_json::array();
  for (const Slide& slide : view.slides)
    item["slides"].push_back(slideJson(slide));
  if (view.shownPose.rows() > 0)
    item["shownPose"] = rowsOf(view.shownPose);
  return item;
}

ViewState viewFromJson(const ordered_json& item, const document::CirculationChoice& circulation) {
  const JsonReader json(kView, kViewAdvice);
  try {
    json.requireObject(item, "");
    return viewFrom(json, item, circulation);
  } catch (const JsonError& error) {
    throw DataError("The view cannot be restored completely", error.where(), kViewAdvice);
  }
}

} // namespace viscera::presentation
