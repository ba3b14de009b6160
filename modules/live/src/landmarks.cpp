#include <algorithm>
#include <map>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/live/retarget.h"

namespace viscera::live {
namespace {

/// The label without case, numbers behind it and the American spelling: "Centerline-2" is "centreline".
std::string roleOfLabel(std::string label) {
  for (char& c : label)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  const std::size_t last = label.find_last_not_of("0123456789-_ .");
  label.resize(last == std::string::npos ? 0 : last + 1);
  return label == "centerline" ? "centreline" : label;
}

std::string labelsOf(const std::vector<LandmarkRole>& roles) {
  std::string text;
  for (const LandmarkRole& role : roles)
    text += (text.empty() ? "" : ", ") + role.role + (role.several ? "-1, " + role.role + "-2, ..." : "");
  return text;
}

} // namespace

const Landmark* Landmarks::find(const std::string& role) const {
  const auto found =
      std::find_if(points.begin(), points.end(), [&role](const Landmark& one) { return one.role == role; });
  return found == points.end() ? nullptr : &*found;
}

std::vector<Vec3> Landmarks::all(const std::string& role) const {
  std::vector<Vec3> places;
  for (const Landmark& landmark : points)
    if (landmark.role == role)
      places.push_back(landmark.position);
  return places;
}

const std::vector<LandmarkRole>& landmarkRoles(const std::string& sequence) {
  static const std::map<std::string, std::vector<LandmarkRole>> roles{
      {"heartbeat",
       {{"apex", "Apex", "The tip of the heart"},
        {"base", "Base", "The middle of the mitral valve, inside the heart"},
        {"right", "Right ventricle", "Any point on the side of the right ventricle"}}},
      {"peristalsis",
       {{"fundus", "Fundus", "The top of the fundus"},
        {"centreline", "Centreline", "Points along the middle of the stomach, from the fundus down", true},
        {"body", "Middle of the body", "Where waves arise, about a third of the way down"},
        {"pylorus", "Pylorus", "The outlet of the stomach"}}},
      {"breathing", {}}};
  const auto found = roles.find(sequence);
  if (found == roles.end())
    throw UsageError(misuse("there is no sequence \"%1\" for other organs", sequence), {},
                     misuse("use one of: heartbeat, peristalsis, breathing"));
  return found->second;
}

Landmarks landmarksFrom(const medical_io::HandleFile& file, const std::string& sequence,
                        const std::string& where) {
  const std::vector<LandmarkRole>& roles = landmarkRoles(sequence);
  Landmarks landmarks;
  for (const medical_io::HandleGroupRecord& group : file.groups)
    for (const medical_io::HandleRecord& record : group.handles) {
      const std::string role = roleOfLabel(record.label);
      const auto known = std::find_if(roles.begin(), roles.end(),
                                      [&role](const LandmarkRole& one) { return one.role == role; });
      if (known == roles.end())
        throw DataError(
            phrase("the label \"%1\" is not a landmark of the sequence %2", record.label, sequence), where,
            roles.empty() ? "leave the landmarks out" : phrase("label the points %1", labelsOf(roles)));
      if (!known->several && landmarks.find(role))
        throw DataError(phrase("the landmark \"%1\" comes twice", role), where, "remove one of the two");
      landmarks.points.push_back({role, record.position, false});
    }
  return landmarks;
}

medical_io::HandleFile landmarkFile(const Landmarks& landmarks, const std::string& name) {
  medical_io::HandleFile file;
  medical_io::HandleGroupRecord group;
  group.name = name;
  group.color = {0.34, 0.71, 0.91};
  std::map<std::string, int> count;
  for (const Landmark& landmark : landmarks.points) {
    medical_io::HandleRecord record;
    const int number = ++count[landmark.role];
    record.label = landmarks.all(landmark.role).size() > 1 ? landmark.role + "-" + std::to_string(number)
                                                           : landmark.role;
    record.position = landmark.position;
    record.description = landmark.computed ? "computed" : "given";
    group.handles.push_back(std::move(record));
  }
  file.groups.push_back(std::move(group));
  return file;
}

} // namespace viscera::live
