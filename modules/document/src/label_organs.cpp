#include "viscera/document/label_organs.h"

#include <utility>

namespace viscera::document {

std::vector<Organ> organsFrom(const medical_io::LabelMap& map, std::vector<medical_io::LabelSurface> surfaces,
                              const std::filesystem::path& file) {
  std::vector<Organ> organs;
  for (medical_io::LabelSurface& surface : surfaces) {
    const medical_io::Segment& segment = map.segments[surface.segment];
    Organ organ = makeOrgan(segment.name, std::move(surface.mesh));
    organ.look.color = segment.color;
    organ.file = file;
    organ.warnings.insert(organ.warnings.begin(), surface.warnings.begin(), surface.warnings.end());
    organs.push_back(std::move(organ));
  }
  if (!organs.empty())
    organs.front().warnings.insert(organs.front().warnings.begin(), map.warnings.begin(), map.warnings.end());
  return organs;
}

std::vector<Organ> readLabelOrgans(const std::filesystem::path& file, const std::vector<std::string>& labels,
                                   Progress& progress) {
  const medical_io::LabelMap map = medical_io::readLabelMap(file, progress);
  medical_io::LabelSurfaceOptions options;
  options.segments = medical_io::segmentsNamed(map, labels, file.string());
  return organsFrom(map, medical_io::labelSurfaces(map, options, progress), file);
}

} // namespace viscera::document
