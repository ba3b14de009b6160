#include "viscera/live/motion_recipe.h"

#include <nlohmann/json.hpp>

#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"
#include "viscera/live/sequence_setup.h"

namespace viscera::live {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

Landmarks landmarksOf(const JsonReader& reader, const ordered_json& made) {
  Landmarks landmarks;
  reader.eachOf(made, "landmarks", "", [&](const ordered_json& item, const std::string& place) {
    landmarks.points.push_back({reader.valueOf<std::string>(item, "role", place),
                                reader.valueOf<Vec3>(item, "position", place), false});
  });
  return landmarks;
}

} // namespace

std::string sampleRecipe(const std::string& sequence, sample_organs::Resolution resolution) {
  return json{{"sequence", sequence}, {"resolution", sample_organs::nameOf(resolution)}}.dump();
}

std::string fittedRecipe(const std::string& sequence, const Landmarks& given) {
  json landmarks = json::array();
  for (const Landmark& point : given.points)
    landmarks.push_back(
        {{"role", point.role}, {"position", {point.position.x(), point.position.y(), point.position.z()}}});
  return json{{"sequence", sequence}, {"landmarks", landmarks}}.dump();
}

std::string sequenceOf(const std::string& recipe) {
  try {
    return textIn(parseJson<json>(recipe, {}, {}), "sequence");
  } catch (const Error&) {
    return {};
  }
}

std::optional<sample_organs::Resolution> sampleHeartOf(const std::string& recipe) {
  try {
    const auto made = parseJson<json>(recipe, {}, {});
    if (textIn(made, "sequence") != "heartbeat" || !made.contains("resolution"))
      return {};
    return sample_organs::resolutionFromName(textIn(made, "resolution"));
  } catch (const Error&) {
    return {};
  }
}

std::shared_ptr<const sequences::Sequence> makeMotion(const std::string& recipe, const document::Organ& organ,
                                                      const sample_organs::SampleLibrary& library,
                                                      Progress& progress) {
  const JsonReader reader(organ.name, std::string());
  try {
    const ordered_json made = reader.parse(recipe);
    const auto id = reader.valueOf<std::string>(made, "sequence", "");
    if (made.contains("landmarks"))
      return retargetSequence(id, organ, landmarksOf(reader, made), progress).sequence;
    const auto resolution =
        sample_organs::resolutionFromName(reader.valueOf<std::string>(made, "resolution", ""));
    return setUpSequence(library, id, resolution, progress).sequence;
  } catch (const JsonError&) {
    throw DataError("the motion of an organ cannot be made again: nothing is known of how it was made",
                    named(organ.name), "choose it again in Play mode");
  }
}

} // namespace viscera::live
