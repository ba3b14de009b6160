#include "surface_warnings.h"

#include <cmath>

#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/organ_norms.h"

namespace viscera::medical_io {

void appendSurfaceWarnings(SurfaceFile& surface) {
  const auto append = [&](std::optional<std::string> doubt) {
    if (doubt)
      surface.warnings.push_back(std::move(*doubt));
  };
  append(doubtAboutSize(surface.name, boundsOf(surface.mesh.points).diagonal()));
  const geometry::SurfaceReport report = geometry::checkSurface(surface.mesh);
  for (std::string& fault : geometry::faults(report))
    surface.warnings.push_back(std::move(fault));
  if (report.closed())
    append(doubtAboutVolume(surface.name, std::abs(report.volumeMm3) / kMm3PerMl));
}

} // namespace viscera::medical_io
