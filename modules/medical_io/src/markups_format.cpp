#include <algorithm>
#include <array>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "handle_formats.h"
#include "scalar.h"
#include "space_tag.h"
#include "text_scanner.h"
#include "viscera/core/json_reader.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr auto kSchema = "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/"
                         "Resources/Schema/markups-schema-v1.0.3.json#";

constexpr std::array<std::pair<std::string_view, double>, 5> kUnits = {
    {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"um", 1e-3}, {"[in_i]", 25.4}}};

class MarkupsReader {
public:
  explicit MarkupsReader(const FileBytes& file) : file_(file) {}

  HandleFile run() {
    const auto document = parseJson<OrderedJson>(file_.view(), file_.name(), kUsualAdvice);
    const auto lists = document.is_object() ? document.find("markups") : document.end();
    if (!document.is_object() || lists == document.end() || !lists->is_array())
      file_.fail(diagnostic("It holds no \"markups\": it is no 3D Slicer markups file"),
                 "save the points from Slicer as .mrk.json");
    for (std::size_t i = 0; i < lists->size(); ++i)
      readList((*lists)[i], i);
    if (result_.count() == 0 && unplaced_.empty() && !others_.empty())
      file_.fail(phrase("It holds no points, but %1", listOf(others_)),
                 "copy its control points into a point list in Slicer's module Markups, and save the list");
    reportUnplaced(result_, unplaced_, file_);
    return std::move(result_);
  }

private:
  void readList(const OrderedJson& list, std::size_t number) {
    if (!list.is_object())
      file_.fail(diagnostic("markup list %1 is not a JSON object", number + 1));
    HandleGroupRecord group;
    group.name = textIn(list, "name");
    if (group.name.empty())
      group.name = "List " + std::to_string(number + 1);
    const std::string type = textIn(list, "type");
    if (type != "Fiducial") {
      result_.warnings.push_back(phrase("the markup %1 of type %2 is not a list of points and was left out",
                                        inQuotes(group.name), inQuotes(type)));
      others_.push_back(phrase("%1 %2", named(kindOf(type)), inQuotes(group.name)));
      return;
    }
    const auto display = list.find("display");
    const OrderedJson noDisplay = OrderedJson::object();
    const OrderedJson& shown = display != list.end() && display->is_object() ? *display : noDisplay;
    readColor(shown, group);
    const Frame frame = readFrame(list, group.name);
    const bool listLocked = flagIn(list, "locked", false);
    const bool listVisible = flagIn(shown, "visibility", true);
    const auto points = list.find("controlPoints");
    if (points != list.end() && !points->is_array())
      file_.fail(diagnostic("list %1: its points are no JSON array", inQuotes(group.name)));
    for (std::size_t i = 0; points != list.end() && i < points->size(); ++i)
      readPoint((*points)[i], i, frame, group);
    for (HandleRecord& handle : group.handles) {
      handle.locked = handle.locked || listLocked;
      handle.visible = handle.visible && listVisible;
    }
    result_.groups.push_back(std::move(group));
  }

  /// What a markup that is no list of points is to a user of Slicer.
  static std::string_view kindOf(std::string_view type) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kMarkupKinds = {
        {{"Line", "a line"},
         {"Angle", "an angle"},
         {"Curve", "a curve"},
         {"ClosedCurve", "a closed curve"},
         {"Plane", "a plane"},
         {"ROI", "a box (ROI)"}}};
    return lookUp(kMarkupKinds, type).value_or("a markup of another kind");
  }

  /// Slicer draws selected points, as all are by default, in `selectedColor`.
  static void readColor(const OrderedJson& display, HandleGroupRecord& group) {
    for (const char* key : {"selectedColor", "color"}) {
      const auto color = display.find(key);
      if (color == display.end() || !color->is_array() || color->size() != 3)
        continue;
      for (std::size_t k = 0; k < 3; ++k)
        if ((*color)[k].is_number())
          group.color[static_cast<Eigen::Index>(k)] = std::clamp((*color)[k].get<double>(), 0.0, 1.0);
      return;
    }
  }

  struct Frame {
    bool ras = false;
    double mm = 1;
  };

  Frame readFrame(const OrderedJson& list, const std::string& name) {
    Frame frame;
    const auto system = list.find("coordinateSystem");
    if (system != list.end()) {
      // Numbers are what Slicer's first versions wrote.
      const std::string value = system->is_string()            ? system->get<std::string>()
                                : system->is_number_unsigned() ? std::to_string(system->get<unsigned>())
                                                               : std::string();
      if (value != "LPS" && value != "RAS" && value != "0" && value != "1")
        file_.fail(diagnostic("list %1: its coordinate system %2 is not LPS or RAS", inQuotes(name),
                              inQuotes(value)),
                   "save the points from Slicer in LPS");
      frame.ras = value == "RAS" || value == "0";
    }
    const std::string unit = textIn(list, "coordinateUnits");
    if (const auto mm = lookUp(kUnits, unit))
      frame.mm = *mm;
    else if (!unit.empty())
      result_.warnings.push_back(phrase("%1: %2", inQuotes(name),
                                        phrase("its unit %1 is not known; mm are assumed", inQuotes(unit))));
    if (frame.mm != 1)
      result_.warnings.push_back(phrase("%1: %2", inQuotes(name), phrase("converted from %1 to mm", unit)));
    return frame;
  }

  void readPoint(const OrderedJson& point, std::size_t number, const Frame& frame, HandleGroupRecord& group) {
    const Text where = diagnostic("list %1, point %2", inQuotes(group.name), number + 1);
    if (!point.is_object())
      file_.fail(diagnostic("%1 is not a JSON object", where));
    HandleRecord handle;
    handle.label = textIn(point, "label");
    if (!isPlaced(statusOf(point))) {
      unplaced_.push_back(handle.label.empty() ? group.name + "-" + std::to_string(number + 1)
                                               : handle.label);
      return;
    }
    handle.description = textIn(point, "description");
    handle.locked = flagIn(point, "locked", false);
    handle.visible = flagIn(point, "visibility", true);
    handle.position = readPosition(point, where, frame);
    group.handles.push_back(std::move(handle));
  }

  static std::string statusOf(const OrderedJson& point) {
    const auto status = point.find("positionStatus");
    return status != point.end() && status->is_number_unsigned() ? std::to_string(status->get<unsigned>())
                                                                 : textIn(point, "positionStatus");
  }

  Vec3 readPosition(const OrderedJson& point, const Text& where, const Frame& frame) const {
    const auto position = point.find("position");
    if (position == point.end() || !position->is_array() || position->size() != 3)
      file_.fail(diagnostic("%1 has no position of three numbers", where));
    Vec3 mm;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::optional<double> coordinate = finiteNumber((*position)[axis]);
      if (!coordinate)
        file_.fail(diagnostic("%1 has a coordinate that is not a finite number", where));
      mm[static_cast<Eigen::Index>(axis)] = *coordinate;
    }
    if (frame.mm != 1)
      mm *= frame.mm;
    if (!mm.allFinite())
      file_.fail(diagnostic("%1 is too far away", where));
    return frame.ras ? lpsFromRas(mm) : mm;
  }

  const FileBytes& file_;
  HandleFile result_;
  std::vector<std::string> unplaced_; ///< The labels of points without a place.
  std::vector<Text> others_;          ///< The markups that are no lists of points.
};

OrderedJson pointJson(const HandleRecord& handle, std::size_t number, Space space) {
  const Vec3 place = space == Space::ras ? lpsFromRas(handle.position) : handle.position;
  return {{"id", std::to_string(number + 1)},
          {"label", handle.label},
          {"description", handle.description},
          {"associatedNodeID", ""},
          {"position", {place.x(), place.y(), place.z()}},
          {"orientation", {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}},
          {"selected", true},
          {"locked", handle.locked},
          {"visibility", handle.visible},
          {"positionStatus", "defined"}};
}

OrderedJson listJson(const HandleGroupRecord& group, Space space) {
  OrderedJson points = OrderedJson::array();
  for (std::size_t i = 0; i < group.handles.size(); ++i)
    points.push_back(pointJson(group.handles[i], i, space));
  const OrderedJson color = {group.color.x(), group.color.y(), group.color.z()};
  return {{"type", "Fiducial"},
          {"name", group.name},
          {"coordinateSystem", spaceName(space)},
          {"coordinateUnits", "mm"},
          {"locked", false},
          {"fixedNumberOfControlPoints", false},
          {"labelFormat", "%N-%d"},
          {"lastUsedControlPointNumber", group.handles.size()},
          {"controlPoints", std::move(points)},
          {"measurements", OrderedJson::array()},
          {"display",
           {{"visibility", true},
            {"opacity", 1.0},
            {"color", color},
            {"selectedColor", color},
            {"propertiesLabelVisibility", false},
            {"pointLabelsVisibility", false},
            {"textScale", 3.0},
            {"glyphType", "Sphere3D"},
            {"glyphScale", 3.0},
            {"glyphSize", 5.0},
            {"useGlyphScale", true}}}};
}

} // namespace

HandleFile readMarkups(const FileBytes& file) {
  return MarkupsReader(file).run();
}

void writeMarkups(std::ostream& out, const HandleFile& handles, Space space) {
  OrderedJson lists = OrderedJson::array();
  for (const HandleGroupRecord& group : handles.groups)
    lists.push_back(listJson(group, space));
  const OrderedJson document = {{"@schema", kSchema}, {"markups", std::move(lists)}};
  // A label that is no UTF-8 must not keep the rig from being saved.
  out << document.dump(2, ' ', false, OrderedJson::error_handler_t::replace) << '\n';
}

} // namespace viscera::medical_io
