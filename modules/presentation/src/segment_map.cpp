#include "viscera/presentation/segment_map.h"

#include <memory>

#include "viscera/presentation/strain_figure.h"

namespace viscera::presentation {

SurfaceMap segmentMap(const scene::BullsEyeFigure& figure, const SegmentsOfOrgans& segments, int chosen,
                      const std::string& title) {
  SurfaceMap map;
  map.colors = figure.colors;
  map.range = figure.range;
  map.title = title;
  map.unit = figure.unit;
  map.glassAround = true;
  for (const auto& [organ, ofVertices] : segments)
    map.values[organ] = std::make_shared<const Values>(strainOnSurface(figure, ofVertices, chosen));
  return map;
}

} // namespace viscera::presentation
