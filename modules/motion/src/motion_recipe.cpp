#include "viscera/motion/motion_recipe.h"

#include <nlohmann/json.hpp>

#include "viscera/core/error.h"
#include "viscera/motion/sequence_setup.h"

namespace viscera::motion {
namespace {

using nlohmann::json;

Landmarks landmarksOf(const json& list) {
  Landmarks landmarks;
  for (const json& item : list) {
    const auto at = item.at("position").get<std::array<double, 3>>();
    landmarks.points.push_back({item.at("role").get<std::string>(), {at[0], at[1], at[2]}, false});
  }
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

std::optional<sample_organs::Resolution> sampleHeartOf(const std::string& recipe) {
  const json made = json::parse(recipe, nullptr, false);
  if (!made.is_object() || made.value("sequence", "") != "heartbeat" || !made.contains("resolution"))
    return {};
  return sample_organs::resolutionFromName(made.at("resolution").get<std::string>());
}

std::shared_ptr<const sequences::Sequence> makeMotion(const std::string& recipe, const document::Organ& organ,
                                                      const sample_organs::SampleLibrary& library,
                                                      Progress& progress) {
  try {
    const json made = json::parse(recipe);
    const auto id = made.at("sequence").get<std::string>();
    if (made.contains("landmarks"))
      return retargetSequence(id, organ, landmarksOf(made.at("landmarks")), progress).sequence;
    const auto resolution = sample_organs::resolutionFromName(made.at("resolution").get<std::string>());
    return setUpSequence(library, id, resolution, progress).sequence;
  } catch (const json::exception&) {
    throw DataError("the motion of an organ cannot be made again: nothing is known of how it was made",
                    organ.name, "choose it again in Play mode");
  }
}

} // namespace viscera::motion
