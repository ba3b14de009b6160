#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

#include "viscera/core/json_reader.h"
#include "viscera/core/phrase.h"
#include "viscera/live/strain_reading.h"

namespace viscera::live {
namespace {

using nlohmann::ordered_json;
using strain::ListedContour;

/// Names of contours in other programs, in small letters and without what is no letter or digit.
constexpr std::array<std::pair<const char*, const char*>, 26> kContourNames = {{
    {"fourchamber", "fourChamber"},
    {"4ch", "fourChamber"},
    {"4chamber", "fourChamber"},
    {"lvgls4ch", "fourChamber"},
    {"twochamber", "twoChamber"},
    {"2ch", "twoChamber"},
    {"2chamber", "twoChamber"},
    {"lvgls2ch", "twoChamber"},
    {"threechamber", "threeChamber"},
    {"3ch", "threeChamber"},
    {"3chamber", "threeChamber"},
    {"lvgls3ch", "threeChamber"},
    {"base", "base"},
    {"basal", "base"},
    {"lvgcsbase", "base"},
    {"middle", "middle"},
    {"mid", "middle"},
    {"lvgcsmid", "middle"},
    {"apex", "apex"},
    {"apical", "apex"},
    {"lvgcsapex", "apex"},
    {"rightfreewall", "rightFreeWall"},
    {"rvfw", "rightFreeWall"},
    {"rvfwgls4ch", "rightFreeWall"},
    {"rvfreewall", "rightFreeWall"},
    {"leftreservoir", "leftReservoir"},
}};

std::vector<std::int32_t> verticesIn(const ordered_json& list, const std::string& place, std::int64_t first,
                                     const JsonReader& reader) {
  if (!list.is_array())
    reader.fail(diagnostic("is no list of vertices"), place);
  std::vector<std::int32_t> vertices;
  for (const ordered_json& vertex : list)
    vertices.push_back(static_cast<std::int32_t>(reader.wholeOf(vertex, place) - first));
  return vertices;
}

/// The program's name of a contour; another one stays.
std::string ownNameOf(const std::string& name) {
  const std::string known = contourNamed(name);
  return known.empty() ? name : known;
}

} // namespace

std::string contourNamed(const std::string& name) {
  std::string plain;
  for (const unsigned char c : name)
    if (std::isalnum(c) != 0)
      plain += static_cast<char>(std::tolower(c));
  for (const auto& [other, known] : kContourNames)
    if (plain == other)
      return known;
  return {};
}

std::vector<ListedContour> readContours(const std::filesystem::path& file) {
  const JsonReader reader(file.string(), Text("see docs/strain.md for the form of such a file"));
  const ordered_json object = reader.parse(readText(file));
  std::int64_t first = 0;
  if (const auto found = object.find("firstIndex"); found != object.end())
    first = reader.wholeOf(*found, "firstIndex");
  std::vector<ListedContour> contours;
  if (const auto list = object.find("contours"); list != object.end() && list->is_array()) {
    for (std::size_t i = 0; i < list->size(); ++i) {
      const std::string place = "contours[" + std::to_string(i) + "]";
      const ordered_json& entry = (*list)[i];
      ListedContour contour;
      contour.name = ownNameOf(reader.textOf(entry, "name", place));
      contour.surface = textIn(entry, "surface");
      contour.vertices =
          verticesIn(reader.field(entry, "vertices", place), place + ".vertices", first, reader);
      contour.closed = flagIn(entry, "closed", false);
      contours.push_back(std::move(contour));
    }
    return contours;
  }
  for (const auto& [key, value] : object.items())
    if (key != "firstIndex")
      contours.push_back({ownNameOf(key), contourNamed(key) == "rightFreeWall" ? "RV" : "",
                          verticesIn(value, key, first, reader), false});
  return contours;
}

} // namespace viscera::live
