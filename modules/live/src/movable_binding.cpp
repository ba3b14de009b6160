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

} // namespace viscera::live
