#include "heart_labels.h"

#include <string>

#include "viscera/medical_io/heart_labels.h"

namespace viscera::live {

std::vector<LabelledSurface> heartSurfaces(const medical_io::LabelMap& map) {
  const auto heart = medical_io::heartLabels(map);
  if (!heart)
    return {};
  std::vector<LabelledSurface> surfaces = {{"heart", {}}};
  for (const std::size_t segment : heart->muscle)
    surfaces.front().labels.push_back(map.segments[segment].name);
  for (const medical_io::HeartLabels::Cavity& cavity : heart->cavities) {
    const std::string& label = map.segments[cavity.segment].name;
    surfaces.front().labels.push_back(label);
    surfaces.push_back({cavity.chamber, {label}});
  }
  return surfaces;
}

} // namespace viscera::live
