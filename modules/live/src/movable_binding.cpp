#include "viscera/live/movable_binding.h"

#include <utility>

#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/stiff_binding.h"

namespace viscera::live {

std::shared_ptr<const coordinates::Binding> bindMovable(const document::Organ& organ,
                                                        const coordinates::CoordinateSystem& system,
                                                        const coordinates::HandleSet& handles,
                                                        const coordinates::BindOptions& options,
                                                        Progress& progress) {
  if (organ.mobility == document::Mobility::fixed)
    return deformation::fixedBinding(handles.positions.rows(), organ.mesh->points);
  auto soft = deformation::bindOrgan(system, handles, organ.mesh->points, options, progress);
  if (organ.mobility == document::Mobility::bends)
    return soft;
  return deformation::rigidBinding(std::move(soft), *organ.mesh);
}

std::vector<std::shared_ptr<const document::Organ>> stiffOrgans(const document::OrganList& organs) {
  std::vector<std::shared_ptr<const document::Organ>> stiff;
  for (const auto& organ : organs)
    if (organ->mobility != document::Mobility::bends)
      stiff.push_back(organ);
  return stiff;
}

std::shared_ptr<deformation::StiffBodies>
stiffBodies(const std::vector<std::shared_ptr<const document::Organ>>& organs, Threads threads,
            Progress& progress) {
  std::vector<std::shared_ptr<const geometry::TriangleMesh>> surfaces;
  for (const auto& organ : organs)
    surfaces.push_back(organ->mesh);
  return std::make_shared<deformation::StiffBodies>(std::move(surfaces), threads, progress);
}

} // namespace viscera::live
